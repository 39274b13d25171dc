// Where in the scene is the light of a picture measured, and which place has each pixel?
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "app/cli_output.h"
#include "app/render_request.h"

namespace halfdisk {

struct PictureOf {
    Sensor sensor;
    std::uint32_t width = 0;   ///< pixels of the picture; of a strip, the sensor's own
    std::uint32_t height = 0;  ///< of a strip: how often its row is repeated
};

/// Made from what was typed and the scene. Throws InputError: no eye, unknown walls, too many pixels ...
PictureOf pictureOf(const RenderRequest& request, const Scene& scene);

/// Unit of a pixel's value.
std::string_view unitOf(PictureSensor sensor);

/// What a file says of the sensor.
Json sensorFacts(const PictureOf& picture, const SegmentIndex& index);

/// One line for people.
std::string sensorLine(const PictureOf& picture, const SegmentIndex& index);

/// Names of the columns that tell where a pixel is: `angle` (degrees to the right of the middle of the view),
/// `s` (m along the walls), `x` and `y` (m).
std::vector<std::string_view> placeColumns(const Sensor& sensor);

/// Their values at the middle of a pixel. Made once per sensor, for all its pixels.
class PixelPlaces {
 public:
    PixelPlaces(const Sensor& sensor, const SegmentIndex& index);
    std::array<double, 2> at(std::uint32_t pixel) const;  ///< the second is used by a field only

 private:
    const Sensor& sensor_;
    double wallLength_ = 0.0;  // m, of a profile
};

}  // namespace halfdisk
