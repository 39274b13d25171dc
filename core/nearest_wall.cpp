#include "nearest_wall.h"

#include <algorithm>

namespace halfdisk {

NearestWall nearestOn(const Scene& scene, std::uint32_t segment, Vec2 P) {
    const Segment& s = scene.segments[segment];
    const Vec2 edge = s.b - s.a;
    const double t = std::clamp(glm::dot(P - s.a, edge) / glm::dot(edge, edge), 0.0, 1.0);
    return {segment, t, glm::length(s.a + t * edge - P)};
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
