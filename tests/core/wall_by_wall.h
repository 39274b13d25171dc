// Is an answer about a ray right? Every wall is asked in long double; what double precision can't tell is
// left open.
#pragma once

#include <limits>
#include <string>

#include "core/intersect.h"

namespace halfdisk::test {

/// Of the numbers in which was decided: what they can't tell is left open.
inline constexpr double kDoubleEpsilon = std::numeric_limits<double>::epsilon();
inline constexpr double kFloatEpsilon = std::numeric_limits<float>::epsilon();

/// Empty if the hit is right: the ray meets that wall at that t and u, and surely no wall before it. Else
/// what is wrong.
std::string complaint(const Scene& scene, const Ray& ray, const Hit& hit, double epsilon = kDoubleEpsilon);

/// Empty if `occluded` is right for a light at tMax on `lamp`. Else what is wrong.
std::string complaint(const Scene& scene, const Ray& ray, double tMax, std::uint32_t lamp, bool occluded,
                      double epsilon = kDoubleEpsilon);

}  // namespace halfdisk::test
