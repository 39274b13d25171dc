// What is a picture that grows while it is looked at? The film so far, and how it looks on the screen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/film.h"
#include "core/sensor.h"

namespace halfdisk {

/// A finished batch of passes of one sensor. Never changes: a later batch is another picture.
struct LightPicture {
    Sensor sensor;
    Film film;
    std::vector<std::uint32_t> colors;  ///< of each pixel, packed as ImGui's (IM_COL32), opaque
    /// The same in false colours, where the picture is a field: over kScaleDecades powers of ten below white,
    /// and by standard error / mean over as many below 1.
    std::vector<std::uint32_t> logColors{}, noiseColors{};
    double white =
        1.0;  ///< what is shown as white, in the unit of the sensor; more is cut off; 0: all is black
    std::optional<double> noise;  ///< see noiseOf
    std::string refusal;          ///< not empty: why there is no picture
    double seconds = 0.0;         ///< that it took, preparation included
    double passSeconds = 0.0;     ///< its passes alone
    bool firstLook = false;       ///< coarse, until the one that was asked for is prepared
    bool complete = false;
};

/// Of the false colours.
inline constexpr double kScaleDecades = 4.0;

/// Ways of light that are followed to be counted and seen as a cloud, and the first of them that are drawn as
/// lines, so that each can be traced.
inline constexpr std::uint32_t kWaysFollowed = 2000, kWaysDrawn = 40;
/// Of the eye (m), by which they are counted.
inline constexpr double kPupilRadius = 0.01;

/// The eye's strip, W/(m rad); nothing if the scene has no eye.
std::optional<Sensor> eyeStripOf(const Scene& scene);

/// The light along a wall, W/m.
Sensor profileOf(std::uint32_t segment);

/// Of all pixels together, what chance still does to them: the root mean square of their standard errors, as
/// a share of their mean. Nothing if all are black, or there is only one pass.
std::optional<double> noiseOf(const LightPicture& picture);

/// The picture of a room that reaches from `min` to `max` (m), with a margin, W/m. Its cells are about
/// square.
Sensor fieldOf(Vec2 min, Vec2 max);

}  // namespace halfdisk
