// How does a ray look in single precision, and how far off may it be?
#pragma once

#include "core/index/crossing.h"

namespace halfdisk {
namespace {

/// In the index's frame: (o - middle) scale, with a direction whose larger component is between 0.5 and 1.
///
/// With h = 2^-24 (the rounding of a float), M the largest coordinate of the origin, and walls within
/// [-1, 1]: endpoint less origin is off by 1.5 h (1 + M); each product and sum adds roundings of what it
/// holds. Summed up, cross(D, P - O), which is the place along the wall times the slope cross(D, E), is off
/// by at most 16 h (1 + M) on either end's side, and cross(P - O, E) and T cross(D, E) by 12 h (1 + M) (|Ex|
/// + |Ey|) together. A wall within these bounds is not sorted out.
struct FloatRay {
    float ox, oy, dx, dy;
    float sideSlack, wallSlack;
    double perT;   // single-precision lengths in one t
    double start;  // where the origin lies on the ray, in single-precision lengths

    /// At least as far as t, and farther than what it may be off.
    float upTo(double t) const { return static_cast<float>((t * perT - start) * (1.0 + 0x1p-22) + 0x1p-22); }
};

enum class Fit : std::uint8_t {
    fits,
    misses,    ///< the ray meets nothing
    tooLarge,  ///< so far out that single precision is no help
};

using Pair [[gnu::vector_size(16)]] = double;

inline double farther(Pair v) {
    return larger(magnitude(v[0]), magnitude(v[1]));
}

/// By a power of two. False if it can't be.
[[gnu::noinline]] bool normalise(Pair& direction, double& perT) {
    const double most = farther(direction);
    if (!(most > 0.0) || !(most < std::numeric_limits<double>::infinity())) return false;
    // In two steps, for the power may be as large as 2^1074.
    int exponent = 0;
    __builtin_frexp(most, &exponent);
    const double half = __builtin_ldexp(1.0, -exponent / 2),
                 rest = __builtin_ldexp(1.0, -exponent - -exponent / 2);
    direction = direction * half * rest;
    perT = perT / half / rest;
    return true;
}

/// To a place near the square [-1.5, 1.5]^2 that holds all walls. False if it never gets there.
[[gnu::noinline]] bool approach(Pair& origin, Pair direction, double& start) {
    const double alongX = (magnitude(origin[0]) - 1.5) / larger(magnitude(direction[0]), 1e-300);
    const double alongY = (magnitude(origin[1]) - 1.5) / larger(magnitude(direction[1]), 1e-300);
    start = larger(alongX, alongY);
    origin += start * direction;
    return farther(origin) <= 1.75;
}

inline Fit fitRay(const IndexView& index, const Ray& ray, FloatRay& out) {
    Pair direction{ray.direction.x, ray.direction.y};
    out.perT = index.frame.scale;
    out.start = 0.0;
    const double most = farther(direction);
    if (!(most >= 0.5 && most <= 1.0)) {
        if (!normalise(direction, out.perT)) return Fit::misses;
        if (!(out.perT > 1e-290 && out.perT < 1e290)) return Fit::tooLarge;
    }
    Pair origin = (Pair{ray.origin.x, ray.origin.y} - Pair{index.frame.middle.x, index.frame.middle.y}) *
                  index.frame.scale;
    double farthest = farther(origin);
    if (!(farthest <= kFarthestOrigin)) {
        if (!(farthest < 1e6)) return Fit::tooLarge;
        if (!approach(origin, direction, out.start)) return Fit::misses;
        farthest = 1.75;
    }
    out.ox = static_cast<float>(origin[0]);
    out.oy = static_cast<float>(origin[1]);
    out.dx = static_cast<float>(direction[0]);
    out.dy = static_cast<float>(direction[1]);
    const float reach = 1.0f + static_cast<float>(farthest);
    out.sideSlack = 16.0f * 0x1p-24f * reach;
    out.wallSlack = 12.0f * 0x1p-24f * reach + index.shiftSlack;
    return Fit::fits;
}

}  // namespace
}  // namespace halfdisk
