#include "app/prepared_scene.h"

#include <utility>

#include "core/estimator.h"

namespace halfdisk {
namespace {

Bounds boundsOf(const Scene& scene) {
    Bounds bounds{Vec2(kInfinity), Vec2(-kInfinity)};
    const auto include = [&](Vec2 p) {
        bounds.min = glm::min(bounds.min, p);
        bounds.max = glm::max(bounds.max, p);
    };
    for (const Segment& s : scene.segments) {
        include(s.a);
        include(s.b);
    }
    for (const DeltaLight& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light)) include(point->position);
    if (scene.eye) include(scene.eye->position);
    if (bounds.min.x > bounds.max.x) return {};
    return bounds;
}

}  // namespace

PreparedScene::PreparedScene(SceneDescription described)
    : description(std::move(described)),
      scene(expandScene(description)),
      index(scene),
      bounds(boundsOf(scene)) {
    // Exact answers are known for diffuse rooms only.
    if (scene.segments.size() <= Reference::kMostWalls && traitsOf(scene).diffuseOnly)
        visibility.emplace(index);
}

}  // namespace halfdisk
