// Does a ray meet a wall, and where, in single precision alone? The rules of crossing.h and crossings.h, with
// float's rounding for double's: see single.h.
#pragma once

#include "core/index/descent.h"
#include "core/index/lanes.h"

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

}  // namespace
}  // namespace halfdisk
