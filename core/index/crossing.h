// Does a ray meet a wall, where, and which of several walls at one place? Decided in double precision.
//
// The test is the sign of cross(d, p - o) at both endpoints p: the ray's line separates them iff the signs
// differ. Zero counts as positive, and neighbours share their vertex bit for bit, so of two neighbours
// exactly one is hit: nothing leaks between them and nothing is hit twice.
//
// Internal linkage and plain numbers: the kernels of several instruction sets each have their own copy.
#pragma once

#include <limits>

#include "core/index/layout.h"
#include "core/ray.h"

namespace halfdisk {
namespace {

// Rounding of a point p + u (q - p), with unit roundoff h = epsilon / 2 and m the largest coordinate: the
// edge is off by h |e|, the product by h |e|, the sum by h m, and |e| <= 2 m: 5 h m a component, 3.6 epsilon
// m as a vector. Adding the shift along the normal rounds once more, 0.8 epsilon m. So 8 epsilon m puts the
// origin on the front side for sure, and no more than 13 epsilon m from the wall.
constexpr double kShiftRoundings = 8.0;

inline double larger(double a, double b) {
    return a > b ? a : b;
}
inline double magnitude(double a) {
    return __builtin_fabs(a);
}

/// Bound (m) on how far a rounded point of this segment can lie from its line; twice over.
inline double shiftOf(const Segment& s) {
    const double most =
        larger(larger(magnitude(s.a.x), magnitude(s.a.y)), larger(magnitude(s.b.x), magnitude(s.b.y)));
    return kShiftRoundings * std::numeric_limits<double>::epsilon() * most;
}

// A ray runs along a wall if the sine of the angle between them is less than about this. Below it t is off by
// more than a few 1e-9 of the way to the wall's ends.
constexpr double kAlong = 1e-7;

struct Crossing {
    bool met = false;    // if not, the rest means nothing
    bool front = false;  // the ray came from the front side
    double t = 0.0;      // > 0, along the ray in lengths of its direction
    double u = 0.0;      // along the segment, 0 at a and 1 at b
    double slope = 0.0;  // |cross(direction, b - a)|
};

/// Of a ray that does not run along the wall.
inline Crossing crossPlainly(const Segment& s, const Ray& ray) {
    const double ax = s.a.x - ray.origin.x, ay = s.a.y - ray.origin.y;
    const double bx = s.b.x - ray.origin.x, by = s.b.y - ray.origin.y;
    const double sideA = ray.direction.x * ay - ray.direction.y * ax;
    const double sideB = ray.direction.x * by - ray.direction.y * bx;
    const double ex = s.b.x - s.a.x, ey = s.b.y - s.a.y;
    const double slope = ray.direction.x * ey - ray.direction.y * ex;
    const double t = (ax * ey - ay * ex) / slope;
    const bool split = (sideA >= 0.0) != (sideB >= 0.0);
    // For a ray that comes from the front of a->b, b lies on its left: the positive side.
    return {split && t > 0.0, sideB > sideA, t, sideA / (sideA - sideB), magnitude(slope)};
}

/// Whether the side that a ray comes to scatters and emits: a two-sided wall faces all rays.
inline bool facesRay(const Segment& s, bool front) {
    return front || s.twoSided;
}

/// Of any ray. Where it runs along the wall, the quotient t is mere rounding; but the crossing lies between
/// the wall's ends.
inline Crossing cross(const Segment& s, const Ray& ray) {
    Crossing crossing = crossPlainly(s, ray);
    const double dx = ray.direction.x, dy = ray.direction.y;
    const double size = magnitude(s.b.x - s.a.x) + magnitude(s.b.y - s.a.y);
    if (crossing.slope > kAlong * (magnitude(dx) + magnitude(dy)) * size) return crossing;
    const double length2 = dx * dx + dy * dy;
    const double atA = ((s.a.x - ray.origin.x) * dx + (s.a.y - ray.origin.y) * dy) / length2;
    const double atB = ((s.b.x - ray.origin.x) * dx + (s.b.y - ray.origin.y) * dy) / length2;
    // Wider than the rounding of any t that is good for something.
    const double margin = 1e-9 * (magnitude(atA) + magnitude(atB));
    const double first = (atA < atB ? atA : atB) - margin, last = larger(atA, atB) + margin;
    if (crossing.t >= first && crossing.t <= last) return crossing;
    const double sideA = dx * (s.a.y - ray.origin.y) - dy * (s.a.x - ray.origin.x);
    const double sideB = dx * (s.b.y - ray.origin.y) - dy * (s.b.x - ray.origin.x);
    crossing.t = crossing.t > last ? last : first;
    crossing.met = (sideA >= 0.0) != (sideB >= 0.0) && crossing.t > 0.0;
    return crossing;
}

}  // namespace
}  // namespace halfdisk
