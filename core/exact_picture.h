// What should a picture look like without any noise? Every pixel by quadrature, to hold estimates against.
#pragma once

#include "reference.h"
#include "sensor.h"

namespace halfdisk {

/// Whether exactPicture can be asked for this sensor: an eye's strip or a wall's profile.
bool hasExactPicture(const Sensor& sensor);

/// Mean of every pixel (radiance, W/(m rad), or irradiance, W/m), as Problem::maxDepth counts: of light
/// scattered at most `maxDepth` times, and once more for an eye. `reference` must be prepared for maxDepth
/// + 1. Adaptive quadrature between all edges of what is seen; relative error about 1e-4, with that of the
/// reference's interpolation where light is scattered twice or more. Throws Stopped.
std::vector<Rgb> exactPicture(const Reference& reference, const Sensor& sensor, unsigned maxDepth,
                              const StopQuestion& stop = {});

/// Root mean square of the pixels' differences from `exact` as a share of its mean (means of the channels);
/// nothing if that is black or has another number of pixels.
std::optional<double> relativeError(const std::vector<Rgb>& pixels, const std::vector<Rgb>& exact);

}  // namespace halfdisk
