// Which point of which wall is meant by `floor:0.25`?
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/scene.h"

namespace halfdisk {

/// The point a + t (b - a) of a wall.
struct WallPoint {
    std::uint32_t segment = 0;  ///< index into Scene::segments
    double t = 0.0;             ///< 0 at a ... 1 at b
    bool operator==(const WallPoint&) const = default;
};

/// Index of the wall of this name, if there is one.
std::optional<std::uint32_t> findSegment(const Scene& scene, std::string_view name);

/// Reads NAME:T. Throws InputError (without a file or place) that names the walls there are.
WallPoint parseWallPoint(std::string_view text, const Scene& scene);

/// In the scene's frame (m).
inline Vec2 positionOf(const Scene& scene, WallPoint at) {
    const Segment& s = scene.segments[at.segment];
    return s.a + at.t * (s.b - s.a);
}

}  // namespace halfdisk
