#include "nearest_wall.h"

#include <algorithm>

namespace halfdisk {

NearestWall nearestOnStretch(Vec2 a, Vec2 b, Vec2 P) {
    const Vec2 edge = b - a;
    const double length2 = glm::dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(P - a, edge) / length2, 0.0, 1.0) : 0.0;
    return {kNoSegment, t, glm::length(a + t * edge - P)};
}

NearestWall nearestOn(const Scene& scene, std::uint32_t segment, Vec2 P) {
    const Segment& wall = scene.segments[segment];
    NearestWall nearest = nearestOnStretch(wall.a, wall.b, P);
    nearest.segment = segment;
    return nearest;
}

NearestWall nearestWall(const Scene& scene, Vec2 P) {
    NearestWall nearest;
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i) {
        const NearestWall candidate = nearestOn(scene, i, P);
        if (candidate.distance < nearest.distance) nearest = candidate;
    }
    return nearest;
}

}  // namespace halfdisk
