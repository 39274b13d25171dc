// What would a tracer in float find? Each wall in single precision alone, several at a time: what it costs in
// truth, and what it spares in time.
//
// The rules are those of crossing.h, crossings.h and occlusion.h (signs at both ends, the skipped wall, walls
// that lie on each other, lamps and points), with float's rounding for double's. Walls and rays are rounded
// as they are, in the scene's own coordinates: far from the origin walls move, rays start beside where they
// should, and the shift that keeps an origin on its side of a corner (SegmentIndex::originShift) is lost.
// A wall whose ends round to one place is never met. Directions are about of unit length.
//
// All walls are asked, as in double precision up to 128 of them (intersect.cpp): up to there times compare.
// No fused multiply-add, so that every instruction set gives the same hits.
#pragma once

#include "core/index/descent.h"
#include "core/index/lanes.h"
#include "core/index/pick.h"

namespace halfdisk {
namespace {

// How far off a wall's line may a crossing lie? With h = 2^-24 (the rounding of a float), |o| = |o.x| + |o.y|
// of the origin, and `reach` the same of a - o and of e = b - a together: the origin is off by h |o|, the
// wall's ends by h (|o| + reach), a - o by h reach. The products, differences and e in cross(a - o, e) add
// 3 h reach |e|, those in t cross(d, e), with d rounded, 6 h reach |e|, the quotient and its comparison
// 3 h reach |e|: in all 2 h |o| + 14 h reach.
constexpr float kOriginRoundings = 2.0f * 0x1p-24f;
constexpr float kReachRoundings = 14.0f * 0x1p-24f;

inline float abs(float value) {
    return __builtin_fabsf(value);
}

struct SingleRay {
    float ox, oy, dx, dy;
    float size;   // |dx| + |dy|
    float slack;  // m, by the origin's distance from 0
    std::uint32_t skip;

    explicit SingleRay(const Ray& ray)
        : ox(static_cast<float>(ray.origin.x)),
          oy(static_cast<float>(ray.origin.y)),
          dx(static_cast<float>(ray.direction.x)),
          dy(static_cast<float>(ray.direction.y)),
          size(abs(dx) + abs(dy)),
          slack(kOriginRoundings * (abs(ox) + abs(oy))),
          skip(ray.skip) {}
};

/// One wall (float), or several (Floats), and a ray.
template <class Number>
struct SingleCrossing {
    Number ax, ay, ex, ey;   // from the origin to a, from a to b
    Number size;             // |ex| + |ey|
    Number sideA, sideB;     // signs that differ: the ray's line crosses the wall
    Number distance, slope;  // t is their quotient
    Number slack;            // t is off by less than |slack / slope|
};

template <class Number>
[[gnu::always_inline]] inline SingleCrossing<Number> crossInSingle(Number x, Number y, Number endX,
                                                                   Number endY, const SingleRay& ray) {
    SingleCrossing<Number> c;
    c.ax = x - ray.ox;
    c.ay = y - ray.oy;
    c.ex = endX - x;
    c.ey = endY - y;
    c.sideA = ray.dx * c.ay - ray.dy * c.ax;
    c.sideB = ray.dx * (endY - ray.oy) - ray.dy * (endX - ray.ox);
    c.slope = ray.dx * c.ey - ray.dy * c.ex;
    c.distance = c.ax * c.ey - c.ay * c.ex;
    c.size = abs(c.ex) + abs(c.ey);
    c.slack = c.size * (ray.slack + kReachRoundings * (abs(c.ax) + abs(c.ay) + c.size));
    return c;
}

inline SingleCrossing<float> crossInSingle(const IndexView& index, std::uint32_t segment,
                                           const SingleRay& ray) {
    const SingleWalls& walls = index.single[segment / kWidth];
    const std::size_t i = segment % kWidth;
    return crossInSingle(walls.ax[i], walls.ay[i], walls.bx[i], walls.by[i], ray);
}

[[gnu::always_inline]] inline SingleCrossing<Floats> crossInSingle(const SingleWalls& walls, int first,
                                                                   const SingleRay& ray) {
    return crossInSingle(load(walls.ax + first), load(walls.ay + first), load(walls.bx + first),
                         load(walls.by + first), ray);
}

/// No comparison with NaN holds: where there is no wall, or numbers overflow, nothing is met.
inline bool isSplit(const SingleCrossing<float>& c) {
    return (c.sideA >= 0.0f && c.sideB < 0.0f) || (c.sideA < 0.0f && c.sideB >= 0.0f);
}
inline Mask isSplit(const SingleCrossing<Floats>& c) {
    const Floats zero{};
    return (lessEqual(zero, c.sideA) & less(c.sideB, zero)) |
           (less(c.sideA, zero) & lessEqual(zero, c.sideB));
}

/// Whether t is mere rounding: off by more than the wall is long.
inline bool runsAlong(const SingleCrossing<float>& c, const SingleRay& ray) {
    const float slope = abs(c.slope);
    return !(c.slack * ray.size <= slope * c.size) && !(ray.size * c.size <= 2.0f * slope);
}
inline Mask crossesPlainly(const SingleCrossing<Floats>& c, Floats slope, const SingleRay& ray) {
    return lessEqual(c.slack * ray.size, slope * c.size) | lessEqual(ray.size * c.size, 2.0f * slope);
}

struct SinglePlace {
    bool met;
    float t, from, until;  // and t lies within these
};

/// Where the ray runs along the wall, between its ends, as in crossing.h.
inline SinglePlace placeOf(const SingleCrossing<float>& c, const SingleRay& ray) {
    const float perSlope = 1.0f / c.slope;
    const float t = c.distance * perSlope, slack = c.slack * abs(perSlope);
    if (!runsAlong(c, ray)) return {isSplit(c) && t > 0.0f && t < kFar, t, t - slack, t + slack};
    const float length2 = ray.dx * ray.dx + ray.dy * ray.dy;
    const float atA = (c.ax * ray.dx + c.ay * ray.dy) / length2,
                atB = atA + (c.ex * ray.dx + c.ey * ray.dy) / length2;
    const float margin = c.slack * ray.size / (c.size * length2);
    const float first = (atA < atB ? atA : atB) - margin, last = (atA < atB ? atB : atA) + margin;
    const float between = !(t >= first) ? first : t > last ? last : t;
    return {isSplit(c) && between > 0.0f && between < kFar, between, first, last};
}

inline bool comesFromFront(const SingleCrossing<float>& c) {
    return c.sideB > c.sideA;
}

/// Whether the wall, which the ray meets at `at`, lies within `off` (m) and its own rounding of the ray's
/// place at t, and reaches over it: else a wall that ends before it and nearly points at the origin would
/// count as well.
inline bool liesOn(const SingleCrossing<float>& c, float at, float t, float off, const SingleRay& ray) {
    const float slack = c.slack + off * c.size;
    if (!(abs(at - t) * abs(c.slope) <= slack)) return false;
    const float along = (t * ray.dx - c.ax) * c.ex + (t * ray.dy - c.ay) * c.ey, margin = 4.0f * slack;
    return along >= -margin && along <= c.ex * c.ex + c.ey * c.ey + margin;
}

inline Hit hitInSingle(std::uint32_t segment, float sideA, float sideB, float t) {
    const float u = sideA / (sideA - sideB);
    return {segment, static_cast<double>(t), u >= 0.0f ? static_cast<double>(u) : 0.0, sideB > sideA};
}

/// One wall after the other. Of those that may lie at the nearest one's place: the one that faces the ray,
/// then the lower index.
[[gnu::noinline]] Hit closestInSingleWithCare(const IndexView& index, const SingleRay& ray) {
    SinglePlace nearest{false, kFar, kFar, kFar};
    Hit chosen;
    float off = 0.0f;
    for (std::uint32_t i = 0; i < index.segmentCount; ++i) {
        const SingleCrossing<float> c = crossInSingle(index, i, ray);
        const SinglePlace place = placeOf(c, ray);
        if (i == ray.skip || !place.met || !(place.t < nearest.t)) continue;
        nearest = place;
        chosen = hitInSingle(i, c.sideA, c.sideB, place.t);
        off = c.slack / c.size;
    }
    for (std::uint32_t i = 0; nearest.met && i < index.segmentCount; ++i) {
        const SingleCrossing<float> c = crossInSingle(index, i, ray);
        const SinglePlace place = placeOf(c, ray);
        if (i == ray.skip || !place.met || place.from > nearest.until) continue;
        const bool front = comesFromFront(c), before = front != chosen.front ? front : i < chosen.segment;
        if (before && liesOn(c, place.t, nearest.t, off, ray))
            chosen = hitInSingle(i, c.sideA, c.sideB, place.t);
    }
    return chosen;
}

inline Hit closestInSingle(const IndexView& index, const Ray& along) {
    const SingleRay ray(along);
    const Ints skip = all(static_cast<std::int32_t>(ray.skip));
    // Of each lane: the nearest wall, where it may begin and end, and where another wall may begin.
    Floats nearest = all(kFar), from = all(2.0f * kFar), until = all(kFar), contested = all(2.0f * kFar);
    Floats sideA{}, sideB{};
    Ints found{};
    unsigned unclear = 0;
    for (std::uint32_t i = 0; i < index.segmentCount; i += kLanes) {
        const int first = static_cast<int>(i % kWidth);
        const SingleCrossing<Floats> c = crossInSingle(index.single[i / kWidth], first, ray);
        const Ints number = load(kNumbers) + static_cast<std::int32_t>(i);
        const Floats slope = abs(c.slope), perSlope = 1.0f / c.slope;
        const Floats t = c.distance * perSlope, slack = c.slack * abs(perSlope);
        const Mask split = isSplit(c) & notEqual(number, skip);
        const Mask met = split & less(Floats{}, t) & less(t, all(kFar)), closer = met & less(t, nearest);
        unclear |= bits(split) & ~bits(crossesPlainly(c, slope, ray));
        const Floats begin = t - slack;
        contested = min(contested, chosen(closer, from, chosen(met, begin, all(2.0f * kFar))));
        nearest = chosen(closer, t, nearest);
        from = chosen(closer, begin, from);
        until = chosen(closer, t + slack, until);
        sideA = chosen(closer, c.sideA, sideA);
        sideB = chosen(closer, c.sideB, sideB);
        found = chosen(closer, number, found);
    }
    const float t = least(nearest);
    const int lane = __builtin_ctz(bits(lessEqual(nearest, all(t))));
    alignas(64) std::int32_t walls[kLanes];
    alignas(64) float ends[kLanes], a[kLanes], b[kLanes];
    store(walls, found);
    store(ends, until);
    store(a, sideA);
    store(b, sideB);
    // Of the nearest wall's own lane only those that it displaced, or came behind it.
    const Floats begins = min(contested, chosen(notEqual(load(kNumbers), all(lane)), from, contested));
    if ((unclear | bits(lessEqual(begins, all(ends[lane])))) != 0) return closestInSingleWithCare(index, ray);
    // Without a branch, as in closest_hit.h.
    const bool met = t < kFar;
    const Hit hit = hitInSingle(static_cast<std::uint32_t>(walls[lane]), a[lane], b[lane], t);
    return {pick(met, hit.segment, kNoSegment), pick(met, hit.t, std::numeric_limits<double>::infinity()),
            pick(met, hit.u, 0.0), (met & hit.front) != 0};
}

/// A wall that the ray crosses at about the light's place or its own, or runs along.
inline bool hidesInSingle(const IndexView& index, const SingleRay& ray, std::uint32_t segment, float end,
                          std::uint32_t lamp) {
    const SingleCrossing<float> c = crossInSingle(index, segment, ray);
    const SinglePlace place = placeOf(c, ray);
    if (!place.met) return false;
    if (!liesOn(c, place.t, end, 0.0f, ray)) return place.t < end;
    const bool front = comesFromFront(c);
    return lamp == kNoSegment ? !front : front && segment < lamp;
}

inline bool occludedInSingle(const IndexView& index, const Ray& along, double tMax, std::uint32_t lamp) {
    const SingleRay ray(along);
    const Ints skip = all(static_cast<std::int32_t>(ray.skip)), light = all(static_cast<std::int32_t>(lamp));
    const float end = tMax < static_cast<double>(kFar) ? static_cast<float>(tMax) : kFar;
    for (std::uint32_t i = 0; i < index.segmentCount; i += kLanes) {
        const int first = static_cast<int>(i % kWidth);
        const SingleCrossing<Floats> c = crossInSingle(index.single[i / kWidth], first, ray);
        const Ints number = load(kNumbers) + static_cast<std::int32_t>(i);
        const Floats slope = abs(c.slope), distance = turned(c.distance, c.slope), reached = end * slope;
        const Mask plain = crossesPlainly(c, slope, ray), ahead = less(Floats{}, distance),
                   split = isSplit(c) & notEqual(number, skip) & notEqual(number, light);
        if (bits(split & plain & ahead & less(distance + c.slack, reached)) != 0) return true;
        const unsigned apart = bits(plain) & (bits(less(reached + c.slack, distance)) | ~bits(ahead));
        for (unsigned unclear = bits(split) & ~apart; unclear != 0; unclear &= unclear - 1)
            if (hidesInSingle(index, ray, i + static_cast<std::uint32_t>(__builtin_ctz(unclear)), end, lamp))
                return true;
    }
    return false;
}

}  // namespace
}  // namespace halfdisk
