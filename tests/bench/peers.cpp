#include "peers.h"

namespace halfdisk {

std::vector<FloatRay> floatRays(std::span<const Ray> rays, std::span<const double> tMax) {
    std::vector<FloatRay> floats;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];
        floats.push_back({static_cast<float>(ray.origin.x), static_cast<float>(ray.origin.y),
                          static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
                          static_cast<float>(tMax.empty() ? kInfinity : tMax[i])});
    }
    return floats;
}

std::vector<std::string> missingPeers() {
    const Scene scene = makePattern(Pattern::random, 1);
    std::vector<std::string> missing;
    if (!makeEmbree(scene, Extrusion::oneTriangle))
        missing.emplace_back("Embree (libembree-dev) is not installed: no ratios to it.");
    if (!makeBox2D(scene)) missing.emplace_back("Box2D (libbox2d-dev) is not installed: no ratios to it.");
    return missing;
}

}  // namespace halfdisk
