// What does light straight from its source amount to where nothing stands in its way, and does anything? The
// closed forms of direct light in the plane.
#pragma once

#include <optional>

#include "exact.h"

namespace halfdisk {

/// Irradiance (W/m) at P, normal N, from all lights, emitting segments and the environment, as if none hid
/// another.
Rgb unoccludedIrradiance(const SegmentIndex& index, const ShadedPoint& at);

/// Fluence (W/m) at P likewise: a segment's radiance times the angle that it fills, I / r, E0, 2 pi L.
Rgb unoccludedFluence(const SegmentIndex& index, Vec2 P);

/// Irradiance on a normal N from an environment with nothing before it; exact for strips of angles too.
Rgb environmentIrradiance(const Environment& environment, Vec2 N);

/// A wall, and a part of what it hides: "a light", the name of an emitting wall, "the environment".
struct Obstacle {
    std::uint32_t wall = kNoSegment;
    std::string hides;
};

/// The first wall that hides a part of a light from the half-disk of `at`; empty where the closed forms hold.
/// Parts narrower than 1e-10 rad do not count.
std::optional<Obstacle> obstacleAt(const Visibility& visibility, const ShadedPoint& at, ArcMemory& memory);

/// The same for all directions around a free point.
std::optional<Obstacle> obstacleAround(const Visibility& visibility, Vec2 P, ArcMemory& memory);

}  // namespace halfdisk
