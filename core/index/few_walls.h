// How are few walls asked? All at once and in double precision: no search, no single precision, and hardly a
// branch, which would cost more than the test of a wall.
//
// Operation by operation the arithmetic of crossing.h, so the same to the bit. Where two walls may be met at
// one place, or a ray runs along a wall, crossing.h itself decides.
#pragma once

#include "core/index/closest_hit.h"
#include "core/index/double_lanes.h"
#include "core/index/occlusion.h"

namespace halfdisk {
namespace {

/// Of the walls.
alignas(64) constexpr double kWallNumbers[kMostFew] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// The ray's numbers in every lane.
struct DoubleRay {
    Doubles ox, oy, dx, dy, skip;
    Doubles along;  // see kAlong

    explicit DoubleRay(const Ray& ray)
        : ox(all(ray.origin.x)),
          oy(all(ray.origin.y)),
          dx(all(ray.direction.x)),
          dy(all(ray.direction.y)),
          skip(all(static_cast<double>(ray.skip))),
          along(all(kAlong * (magnitude(ray.direction.x) + magnitude(ray.direction.y)))) {}
};

/// kDoubles walls and a ray.
struct DoubleCrossing {
    Doubles sideA, sideB;
    Doubles distance, slope;  // t is their quotient, |slope| that of Crossing
    Doubles size;             // |edge.x| + |edge.y|
    DoubleMask split;         // the ray's line crosses the wall
};

[[gnu::always_inline]] inline DoubleCrossing crossWalls(const FewWalls& walls, int first,
                                                        const DoubleRay& ray) {
    const Doubles x = load(walls.ax + first), y = load(walls.ay + first);
    const Doubles endX = load(walls.bx + first), endY = load(walls.by + first);
    const Doubles ax = x - ray.ox, ay = y - ray.oy, bx = endX - ray.ox, by = endY - ray.oy;
    const Doubles ex = endX - x, ey = endY - y;
    DoubleCrossing c;
    c.sideA = ray.dx * ay - ray.dy * ax;
    c.sideB = ray.dx * by - ray.dy * bx;
    c.slope = ray.dx * ey - ray.dy * ex;
    c.distance = ax * ey - ay * ex;
    c.size = abs(ex) + abs(ey);
    // Never where there is no wall: no comparison with NaN holds.
    c.split = differ(lessEqual(Doubles{}, c.sideA), lessEqual(Doubles{}, c.sideB)) &
              notEqual(load(kWallNumbers + first), ray.skip);
    return c;
}

/// Where the ray does not run along the wall: cross() has nothing to mend.
[[gnu::always_inline]] inline DoubleMask isPlain(const DoubleCrossing& c, Doubles slope,
                                                 const DoubleRay& ray) {
    return less(ray.along * c.size, slope);
}

/// Whether all that is reckoned of it keeps clear of underflow and overflow.
inline bool isOrdinary(const Ray& ray) {
    const double length = magnitude(ray.direction.x) + magnitude(ray.direction.y);
    return length > 1e-60 && length < 1e60 && magnitude(ray.origin.x) + magnitude(ray.origin.y) < 1e120;
}

constexpr int kHalf = static_cast<int>(kMostFew) / 2 / kDoubles;

template <int kParts>
inline Hit closestOfFew(const IndexView& index, const Ray& ray) {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const DoubleRay lanes(ray);
    alignas(64) double sideA[kParts * kDoubles], sideB[kParts * kDoubles];
    Doubles t[kParts], slope[kParts], tie[kParts];
    Doubles nearest = all(kNever);
    unsigned unclear = 0;
    for (int i = 0; i < kParts; ++i) {
        const DoubleCrossing c = crossWalls(*index.few, i * kDoubles, lanes);
        slope[i] = abs(c.slope);
        unclear |= laneBits(c.split & inverted(isPlain(c, slope[i], lanes)));
        const Doubles quotient = c.distance / c.slope;
        t[i] = chosen(c.split & less(Doubles{}, quotient), quotient, all(kNever));
        tie[i] = 2.0 * index.mostShift * c.size;
        store(sideA + i * kDoubles, c.sideA);
        store(sideB + i * kDoubles, c.sideB);
        nearest = min(t[i], nearest);
    }
    const double first = least(nearest);
    unsigned near = 0;
    for (int i = 0; i < kParts; ++i)
        near |= laneBits(lessEqual((t[i] - all(first)) * slope[i], tie[i])) << (i * kDoubles);
    if (unclear != 0 || (near & (near - 1)) != 0) return closestOfAll(index, ray);
    // Without a branch: it would be guessed wrong wherever rays often leave the scene.
    const bool met = near != 0;
    const auto wall = static_cast<std::uint32_t>(__builtin_ctz(near | (met ? 0u : 1u)));
    const double a = sideA[wall], b = sideB[wall];
    return {pick(met, wall, kNoSegment), first, pick(met, a / (a - b), 0.0), (met & (b > a)) != 0};
}

template <int kParts>
inline bool occludedByFew(const IndexView& index, const Ray& ray, double tMax, std::uint32_t lamp) {
    const DoubleRay lanes(ray);
    const Doubles lampLanes = all(static_cast<double>(lamp));
    const Doubles least = all(tMax * (1.0 - 1e-12)), most = all(tMax * (1.0 + 1e-12));
    const Doubles slackPerSize = all(4.0 * index.mostShift);
    unsigned blocked = 0, unclear = 0;
    for (int i = 0; i < kParts; ++i) {
        const DoubleCrossing c = crossWalls(*index.few, i * kDoubles, lanes);
        const Doubles slope = abs(c.slope), distance = turned(c.distance, c.slope);
        const DoubleMask clear = isPlain(c, slope, lanes);
        const DoubleMask split = c.split & notEqual(load(kWallNumbers + i * kDoubles), lampLanes);
        // Wider than what liesOn() grants; and t must not be lost in rounding.
        const Doubles slack = slackPerSize * c.size;
        const DoubleMask before = less(distance, least * slope - slack) & less(slack, distance) & clear;
        const DoubleMask apart = (less(most * slope + slack, distance) | less(distance, -slack)) & clear;
        blocked |= laneBits(split & before);
        unclear |= laneBits(split & inverted(before | apart)) << (i * kDoubles);
    }
    if (unclear == 0 || blocked != 0) return blocked != 0;
    const Shadow shadow(index, ray, tMax, lamp);
    for (; unclear != 0; unclear &= unclear - 1)
        if (shadow(static_cast<std::uint32_t>(__builtin_ctz(unclear)))) return true;
    return false;
}

inline Hit closestOfFew(const IndexView& index, const Ray& ray) {
    if (!isOrdinary(ray)) return closestOfAll(index, ray);
    return index.segmentCount <= kMostFew / 2 ? closestOfFew<kHalf>(index, ray)
                                              : closestOfFew<2 * kHalf>(index, ray);
}

inline bool occludedByFew(const IndexView& index, const Ray& ray, double tMax, std::uint32_t lamp) {
    if (!isOrdinary(ray)) return occludedByAny(index, ray, tMax, lamp);
    return index.segmentCount <= kMostFew / 2 ? occludedByFew<kHalf>(index, ray, tMax, lamp)
                                              : occludedByFew<2 * kHalf>(index, ray, tMax, lamp);
}

}  // namespace
}  // namespace halfdisk
