// Which walls does a shape consist of, where do they meet, and which way do they curve?
#pragma once

#include <cstdint>
#include <vector>

#include "lessons/scene_description.h"

namespace halfdisk {

/// Largest difference of an arc's angles (degrees): one turn, and what 0.1 -> 360.1 adds to it by rounding.
inline constexpr double kMaxSweep = 360.0 + 1e-9;

/// Largest part of a turn (degrees) that an edge of an arc spans: a longer chord has the middle on its other
/// side, and the normals at the ends of a smooth one must not part so far that none is left between them.
inline constexpr double kMaxEdgeSweep = 180.0;
inline constexpr double kMaxSmoothEdgeSweep = 120.0;

/// A wall's ends (m); its front is the side to the left of a->b.
struct Edge {
    Vec2 a{0.0}, b{0.0};
    Vec2 normalA{0.0}, normalB{0.0};  ///< of the round thing it is a facet of, on the front side; 0: flat
};

/// Number of walls of a shape. Costs nothing: it can be checked before anything is allocated.
std::uint64_t edgeCount(const Geometry& geometry);

/// The walls of a shape in the order of their numbers. Vertices that neighbours share are bit-identical,
/// and so are the normals there.
std::vector<Edge> edgesOf(const Geometry& geometry);

/// True if rounding leaves the direction from a to b without meaning.
bool isZeroLength(Vec2 a, Vec2 b);

/// (cos, sin) of 2 pi k / count for 0 <= k <= count: exact on the axes, and symmetric in all eight octants.
Vec2 unitAtFraction(std::uint32_t k, std::uint32_t count);

/// (cos, sin) of an angle in degrees, exact at multiples of 90.
Vec2 unitAtDegrees(double degrees);

/// A direction of any length but zero, made unit.
Vec2 unitAlong(Vec2 direction);

}  // namespace halfdisk
