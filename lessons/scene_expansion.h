// Which walls does a shape consist of, where do they meet, and what are they called?
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lessons/scene_description.h"

namespace halfdisk {

/// Most walls of a scene, all shapes together.
inline constexpr std::uint64_t kMaxSegments = 1'000'000;

/// Largest difference of an arc's angles (degrees): one turn, and what 0.1 -> 360.1 adds to it by rounding.
inline constexpr double kMaxSweep = 360.0 + 1e-9;

/// A wall's ends (m); its front is the side to the left of a->b.
struct Edge {
    Vec2 a{0.0}, b{0.0};
};

/// Number of walls of a shape. Costs nothing: it can be checked before anything is allocated.
std::uint64_t edgeCount(const Geometry& geometry);

/// The walls of a shape in the order of their numbers. Vertices that neighbours share are bit-identical.
std::vector<Edge> edgesOf(const Geometry& geometry);

/// True if rounding leaves the direction from a to b without meaning.
bool isZeroLength(Vec2 a, Vec2 b);

/// (cos, sin) of 2 pi k / count for 0 <= k <= count: exact on the axes, and symmetric in all eight octants.
Vec2 unitAtFraction(std::uint32_t k, std::uint32_t count);

/// (cos, sin) of an angle in degrees, exact at multiples of 90.
Vec2 unitAtDegrees(double degrees);

/// Names of the shapes, those without one made up ("box1"), so that no two walls get the same name.
std::vector<std::string> shapeNames(const std::vector<Shape>& shapes);

/// The core's scene: one wall per edge, in file order; NAME for a segment, NAME.0, NAME.1, ... for the
/// others. Throws InputError (without a place) for a material that does not exist; all else was checked by
/// the reader.
Scene expandScene(const SceneDescription& description);

}  // namespace halfdisk
