// What does a ray tracer do that was written in an afternoon? The naive twin: plain formulas in a number type
// of your choice, and four ways to keep a ray off the wall that it leaves.
//
// It is what many introductions print, done with care, so that what breaks is the method and not a slip.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/precision.h"
#include "core/ray.h"
#include "core/scene.h"
#include "core/settings.h"

namespace halfdisk {

enum class EpsilonPolicy : std::uint8_t { none, fixed, relative, ours };
inline constexpr std::array<Named<EpsilonPolicy>, 4> kEpsilonPolicies{{
    {EpsilonPolicy::none, "none", "a ray starts on its wall, and meets whatever comes at t > 0"},
    {EpsilonPolicy::fixed, "fixed", "hits nearer than a fixed length do not count"},
    {EpsilonPolicy::relative, "relative", "hits nearer than some roundings of the origin do not count"},
    {EpsilonPolicy::ours, "bounded",
     "a ray skips its own wall, starts off it by a bound on the rounding, and decides by signs at both ends"},
}};

template <class Real>
struct NaivePoint {
    Real x{}, y{};
};

template <class Real>
struct NaiveRay {
    NaivePoint<Real> origin, direction;
    std::uint32_t skip = kNoSegment;
};

template <class Real>
struct NaiveHit {
    std::uint32_t segment = kNoSegment;
    Real t = std::numeric_limits<Real>::infinity();
    bool front = false;
};

template <class Real>
struct NaiveRoom {
    struct Wall {
        NaivePoint<Real> a, b;
    };

    std::vector<Wall> walls;
    EpsilonPolicy policy = EpsilonPolicy::fixed;
    Real fixed = static_cast<Real>(1e-4);  ///< m, of EpsilonPolicy::fixed

    explicit NaiveRoom(const Scene& scene, EpsilonPolicy epsilon = EpsilonPolicy::fixed, double metres = 1e-4)
        : policy(epsilon), fixed(static_cast<Real>(metres)) {
        const auto rounded = [](Vec2 p) {
            return NaivePoint<Real>{static_cast<Real>(p.x), static_cast<Real>(p.y)};
        };
        walls.reserve(scene.segments.size());
        for (const Segment& s : scene.segments) walls.push_back({rounded(s.a), rounded(s.b)});
    }

    /// u of a wall: 0 at a, 1 at b. The bounded policy keeps away from both ends, as SegmentIndex::pointOn.
    NaivePoint<Real> pointOn(std::uint32_t wall, Real u) const {
        const auto& [a, b] = walls[wall];
        if (policy == EpsilonPolicy::ours) {
            const Real ex = b.x - a.x, ey = b.y - a.y, length = std::sqrt(ex * ex + ey * ey);
            const Real margin = std::min(Real(0.5), 2048 * shiftOf(wall) / length);
            u = std::clamp(u, margin, 1 - margin);
        }
        return {a.x + u * (b.x - a.x), a.y + u * (b.y - a.y)};
    }

    /// From P on a wall into the direction theta (rad from the wall, on its front).
    NaiveRay<Real> rayFrom(std::uint32_t wall, NaivePoint<Real> P, Real theta) const {
        const auto& [a, b] = walls[wall];
        const Real ex = b.x - a.x, ey = b.y - a.y, length = std::sqrt(ex * ex + ey * ey);
        const Real rightX = ex / length, rightY = ey / length;  // the wall's own direction; its front is left
        const Real c = std::cos(theta), s = std::sin(theta);
        NaiveRay<Real> ray{P, {c * rightX - s * rightY, c * rightY + s * rightX}};
        if (policy != EpsilonPolicy::ours) return ray;
        const Real shift = shiftOf(wall);
        ray.origin.x -= shift * rightY;
        ray.origin.y += shift * rightX;
        ray.skip = wall;
        return ray;
    }

    NaiveHit<Real> closestHit(const NaiveRay<Real>& ray) const {
        NaiveHit<Real> nearest;
        const Real least = leastDistance(ray);
        for (std::uint32_t i = 0; i < walls.size(); ++i) {
            if (i == ray.skip) continue;
            const NaiveHit<Real> hit = policy == EpsilonPolicy::ours ? meetBySigns(i, ray) : meet(i, ray);
            if (hit.segment != kNoSegment && hit.t > least && hit.t < nearest.t) nearest = hit;
        }
        return nearest;
    }

 private:
    static Real largest(NaivePoint<Real> p) { return std::max(std::abs(p.x), std::abs(p.y)); }

    /// Bound (m) on how far a rounded point of a wall can lie from its line; twice over
    /// (core/index/crossing.h).
    Real shiftOf(std::uint32_t wall) const {
        return 8 * std::numeric_limits<Real>::epsilon() *
               std::max(largest(walls[wall].a), largest(walls[wall].b));
    }

    Real leastDistance(const NaiveRay<Real>& ray) const {
        if (policy == EpsilonPolicy::fixed) return fixed;
        if (policy == EpsilonPolicy::relative)
            return 64 * std::numeric_limits<Real>::epsilon() * largest(ray.origin);
        return 0;
    }

    /// Cramer's rule for o + t d = a + u e, as everybody writes it.
    NaiveHit<Real> meet(std::uint32_t i, const NaiveRay<Real>& ray) const {
        const auto& [a, b] = walls[i];
        const Real ex = b.x - a.x, ey = b.y - a.y, ax = a.x - ray.origin.x, ay = a.y - ray.origin.y;
        const Real slope = ray.direction.x * ey - ray.direction.y * ex;
        const Real t = (ax * ey - ay * ex) / slope;
        const Real u = (ax * ray.direction.y - ay * ray.direction.x) / slope;
        if (!(u >= 0 && u <= 1)) return {};
        return {i, t, slope > 0};
    }

    /// The sign at both ends decides, so that neighbours leave no gap (core/index/crossing.h).
    NaiveHit<Real> meetBySigns(std::uint32_t i, const NaiveRay<Real>& ray) const {
        const auto& [a, b] = walls[i];
        const Real ax = a.x - ray.origin.x, ay = a.y - ray.origin.y;
        const Real bx = b.x - ray.origin.x, by = b.y - ray.origin.y;
        const Real sideA = ray.direction.x * ay - ray.direction.y * ax;
        const Real sideB = ray.direction.x * by - ray.direction.y * bx;
        if ((sideA >= 0) == (sideB >= 0)) return {};
        const Real ex = b.x - a.x, ey = b.y - a.y;
        return {i, (ax * ey - ay * ex) / (ray.direction.x * ey - ray.direction.y * ex), sideB > sideA};
    }
};

}  // namespace halfdisk
