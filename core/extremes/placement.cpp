#include "placement.h"

#include <algorithm>
#include <limits>

namespace halfdisk {

SceneBox boxOf(const Scene& scene) {
    if (scene.segments.empty()) return {};
    constexpr double kFar = std::numeric_limits<double>::infinity();
    SceneBox box{Vec2(kFar), Vec2(-kFar)};
    for (const Segment& s : scene.segments) {
        box.least = glm::min(box.least, glm::min(s.a, s.b));
        box.most = glm::max(box.most, glm::max(s.a, s.b));
    }
    return box;
}

double sizeOf(const Scene& scene) {
    const SceneBox box = boxOf(scene);
    return scene.segments.empty() ? 1.0 : std::max(box.most.x - box.least.x, box.most.y - box.least.y);
}

Vec2 shiftOf(const Scene& scene, const Placement& placement) {
    if (placement.offset == 0.0) return Vec2(0.0);
    // The way out is slanted, so that both coordinates lose digits.
    return placement.offset * sizeOf(scene) * Vec2(0.8, -0.6) - boxOf(scene).middle();
}

Scene placed(const Scene& scene, const Placement& placement) {
    Scene copy = scene;
    const Vec2 shift = shiftOf(scene, placement);
    const auto move = [&](Vec2& p) { p = placement.scale * (p + shift); };
    for (Segment& s : copy.segments) move(s.a), move(s.b);
    for (DeltaLight& light : copy.lights)
        if (auto* bulb = std::get_if<PointLight>(&light)) {
            move(bulb->position);
            bulb->intensity *= placement.scale;
        }
    for (Material& material : copy.materials)
        if (auto* glass = std::get_if<Dielectric>(&material)) glass->absorption /= placement.scale;
    if (copy.eye) move(copy.eye->position);
    return copy;
}

}  // namespace halfdisk
