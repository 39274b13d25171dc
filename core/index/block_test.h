// Which of a block's walls may a ray meet before T?
#pragma once

#include "core/index/float_ray.h"
#include "core/index/lanes.h"

namespace halfdisk {
namespace {

/// The ray's numbers in every lane, so that they are spread once for many blocks.
struct RayLanes {
    Floats ox, oy, dx, dy, sideSlack, wallSlack;

    explicit RayLanes(const FloatRay& ray)
        : ox(all(ray.ox)),
          oy(all(ray.oy)),
          dx(all(ray.dx)),
          dy(all(ray.dy)),
          sideSlack(all(ray.sideSlack)),
          wallSlack(all(ray.wallSlack)) {}
};

/// What single precision says of kLanes walls and a ray that ends at T.
struct Lanes {
    Mask possible;                  // all walls that are met, and some that are not
    Mask sure;                      // met for sure, if before T
    Floats distance, slope, slack;  // t is within (distance +- slack) / slope
};

/// Pairs of a wall (from A, relative to the origin, along E) and a direction, one in each lane.
[[gnu::always_inline]] inline Lanes testPairs(Floats ax, Floats ay, Floats ex, Floats ey, Floats dx,
                                              Floats dy, Floats sideSlack, Floats wallSlack, Floats T) {
    const Floats along = mulSub(dx, ey, dy * ex);
    Lanes found;
    // t = cross(P - O, E) / cross(D, E), without the division.
    found.distance = turned(mulSub(ax, ey, ay * ex), along);
    found.slope = abs(along);
    found.slack = wallSlack * (abs(ex) + abs(ey));
    // Where the ray's line crosses the wall's, from both of its ends, times the slope.
    const Floats fromP = turned(mulSub(dy, ax, dx * ay), along);
    const Floats inside = min(fromP, found.slope - fromP);
    found.possible = lessEqual(-sideSlack, inside) & lessEqual(-found.slack, found.distance) &
                     lessEqual(found.distance, mulAdd(T, found.slope, found.slack));
    found.sure = lessEqual(sideSlack, inside) & lessEqual(found.slack, found.distance) & found.possible;
    return found;
}

[[gnu::always_inline]] inline Lanes testWalls(const WallBlock& block, int first, const RayLanes& ray,
                                              float T) {
    return testPairs(load(block.px + first) - ray.ox, load(block.py + first) - ray.oy, load(block.ex + first),
                     load(block.ey + first), ray.dx, ray.dy, ray.sideSlack, ray.wallSlack, all(T));
}

/// t of each wall lies between these, if it is met. NaN where the ray runs along the wall.
struct Range {
    Floats from, until;
};

inline Range rangeOf(const Lanes& lanes) {
    // Widened by what the inverse may be off.
    const Floats inverseSlope = inverse(lanes.slope);
    return {(lanes.distance - lanes.slack) * inverseSlope * (1.0f - 0x1p-20f),
            (lanes.distance + lanes.slack) * inverseSlope * (1.0f + 0x1p-20f)};
}

inline Mask isNot(std::uint32_t segment, const WallBlock& block, int first) {
    return notEqual(load(reinterpret_cast<const std::int32_t*>(block.segment) + first),
                    all(static_cast<std::int32_t>(segment)));
}

}  // namespace
}  // namespace halfdisk
