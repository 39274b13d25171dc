// What are rays measured on? Scenes of any size, and the rays that are sent into them.
//
// Every scene lies in the unit box, so that a float's precision is the same for all.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/intersect.h"
#include "core/scene.h"

namespace halfdisk {

enum class Pattern : std::uint8_t { random, circles, fractal };

struct PatternInfo {
    Pattern pattern;
    std::string_view name;
    std::string_view meaning;
    bool clustered;  ///< may lose a fifth of the required ratios
};

const PatternInfo& infoOf(Pattern pattern);

/// A scene of about `count` walls: exactly so many of Pattern::random; of the others what whole circles of
/// 64, or a whole fractal, come nearest to.
Scene makePattern(Pattern pattern, std::size_t count);

/// From random points in the scene's bounding box into random directions, of unit length.
std::vector<Ray> incoherentRays(const Scene& scene, std::size_t count);

/// From one random point in the bounding box towards another, of unit length; `tMax` is set to the distance.
std::vector<Ray> pointPairs(const Scene& scene, std::size_t count, std::vector<double>& tMax);

inline constexpr std::size_t kFanRays = 256;

/// Half-disks about random normals at random points in the bounding box: kFanRays rays each, at equal angles,
/// in their order.
std::vector<Ray> halfDiskFans(const Scene& scene, std::size_t fans);

}  // namespace halfdisk
