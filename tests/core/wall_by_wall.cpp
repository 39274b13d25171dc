#include "wall_by_wall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfdisk::test {
namespace {

using Real = long double;

/// Where the ray's line meets the wall's, and how far rounding may move that.
struct Meeting {
    Real t, u;    // of the lines; NaN if they are parallel
    Real dt, du;  // bounds on the errors of t and u
    bool front;

    bool mayMeet() const { return !(u < -du || u > 1.0L + du || t < -dt); }
    bool surelyMeets() const { return u > du && u < 1.0L - du && t > dt; }
};

Real lengthOf(Vec2 v) {
    return std::hypot(Real{v.x}, Real{v.y});
}

/// With m the largest coordinate, a vector from the origin to an endpoint is at most sqrt(8) m long and off
/// by epsilon m; its cross product with v is off by another 1.5 epsilon of both lengths: 7 epsilon m |v| in
/// all, for v = d (twice in the slope) and v = e.
Meeting meetingOf(const Segment& wall, const Ray& ray, double epsilon) {
    const Vec2 o = ray.origin, d = ray.direction;
    const Real ex = Real{wall.b.x} - wall.a.x, ey = Real{wall.b.y} - wall.a.y;
    const Real ax = Real{wall.a.x} - o.x, ay = Real{wall.a.y} - o.y;
    const Real slope = d.x * ey - d.y * ex;
    const Real t = (ax * ey - ay * ex) / slope, u = (ax * d.y - ay * d.x) / slope;
    const Real most = std::max({std::abs(o.x), std::abs(o.y), std::abs(wall.a.x), std::abs(wall.a.y),
                                std::abs(wall.b.x), std::abs(wall.b.y)});
    const Real error = 16.0L * epsilon * most / std::abs(slope);
    const Real directionLength = lengthOf(d);
    return {t, u, error * (std::hypot(ex, ey) + std::abs(t) * directionLength), error * directionLength,
            slope > 0.0L};
}

}  // namespace

std::string complaint(const Scene& scene, const Ray& ray, const Hit& hit, double epsilon) {
    Real reached = INFINITY;
    if (hit) {
        if (hit.segment >= scene.segments.size() || hit.segment == ray.skip)
            return fmt::format("wall {} can't be met", hit.segment);
        const Meeting met = meetingOf(scene.segments[hit.segment], ray, epsilon);
        if (!(hit.t > 0.0) || !(hit.u >= 0.0) || !(hit.u <= 1.0))
            return fmt::format("t = {}, u = {} of wall {}", hit.t, hit.u, hit.segment);
        if (!met.mayMeet() || std::abs(hit.t - met.t) > met.dt || std::abs(hit.u - met.u) > met.du)
            return fmt::format("wall {} is met at t = {}, u = {}, not {}, {}", hit.segment,
                               static_cast<double>(met.t), static_cast<double>(met.u), hit.t, hit.u);
        if (met.surelyMeets() && hit.front != met.front) return "the wrong side";
        reached = met.t - met.dt;
    }
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i) {
        if (i == ray.skip || i == hit.segment) continue;
        const Meeting other = meetingOf(scene.segments[i], ray, epsilon);
        if (other.surelyMeets() && other.t + other.dt < reached)
            return fmt::format("wall {} at t = {} is met before {} at t = {}", i,
                               static_cast<double>(other.t), hit.segment, hit.t);
    }
    return "";
}

std::string complaint(const Scene& scene, const Ray& ray, double tMax, std::uint32_t lamp, bool occluded,
                      double epsilon) {
    bool mayBe = false;
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i) {
        if (i == ray.skip || i == lamp) continue;
        const Meeting met = meetingOf(scene.segments[i], ray, epsilon);
        // Two shifts of 8 epsilon each are what the light and the ray's origin may be off their walls by.
        const Real end = 3.0L * met.dt;
        if (met.surelyMeets() && met.t + end < tMax && !occluded)
            return fmt::format("wall {} at t = {} hides what is at {}", i, static_cast<double>(met.t), tMax);
        mayBe = mayBe || (met.mayMeet() && !(met.t - end > tMax));
    }
    return occluded && !mayBe ? "nothing hides it" : "";
}

}  // namespace halfdisk::test
