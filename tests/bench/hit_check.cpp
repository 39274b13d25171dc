#include "hit_check.h"

#include <cmath>

namespace halfdisk {
namespace {

/// t at which the ray meets the wall; negative if it does not.
double meeting(const Segment& wall, const Ray& ray) {
    const Vec2 d = ray.direction, p = wall.a - ray.origin, q = wall.b - ray.origin, e = wall.b - wall.a;
    const double sideP = d.x * p.y - d.y * p.x, sideQ = d.x * q.y - d.y * q.x;
    if ((sideP >= 0.0) == (sideQ >= 0.0)) return -1.0;
    return (p.x * e.y - p.y * e.x) / (sideQ - sideP);
}

bool isFront(const Segment& wall, const Ray& ray) {
    const Vec2 e = wall.b - wall.a;
    return ray.direction.x * e.y - ray.direction.y * e.x > 0.0;
}

}  // namespace

Hit bruteClosest(const Scene& scene, const Ray& ray) {
    Hit closest;
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        const double t = meeting(scene.segments[i], ray);
        if (t > 0.0 && t < closest.t) closest = {static_cast<std::uint32_t>(i), t};
    }
    if (closest) closest.front = isFront(scene.segments[closest.segment], ray);
    return closest;
}

bool bruteOccluded(const Scene& scene, const Ray& ray, double tMax) {
    for (const Segment& wall : scene.segments) {
        const double t = meeting(wall, ray);
        if (t > 0.0 && t < tMax) return true;
    }
    return false;
}

std::size_t countDifferences(std::span<const Hit> hits, std::span<const Hit> brute, double tolerance) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool same = hits[i].segment == brute[i].segment && hits[i].front == brute[i].front;
        if (!same || (hits[i] && !(std::abs(hits[i].t - brute[i].t) <= tolerance))) ++count;
    }
    return count;
}

std::size_t countDifferences(std::span<const PeerHit> hits, std::span<const Hit> brute, double tolerance) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool met = hits[i].segment != kNoSegment;
        if (met != static_cast<bool>(brute[i]) || (met && !(std::abs(hits[i].t - brute[i].t) <= tolerance)))
            ++count;
    }
    return count;
}

std::size_t countDifferences(std::span<const std::uint8_t> answers, std::span<const std::uint8_t> brute) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if ((answers[i] != 0) != (brute[i] != 0)) ++count;
    return count;
}

}  // namespace halfdisk
