// What is the exact answer to a probe, where quadrature gives it while one waits?
#include <algorithm>

#include "app/cli_probe.h"
#include "core/exact.h"

namespace halfdisk {
namespace {

/// The work grows with the cube of the walls.
constexpr std::size_t kMostExactWalls = 60;

double largest(const Rgb& value) {
    return std::max({value.x, value.y, value.z});
}

Rgb& strengthOf(PointLight& light) {
    return light.intensity;
}
Rgb& strengthOf(DirectionalLight& light) {
    return light.irradiance;
}

/// Calls `change` with everything that says how bright the scene is.
template <class Change>
void forSources(Scene& scene, const Change& change) {
    change(scene.environment);
    for (Segment& segment : scene.segments) change(segment.emission);
    for (DeltaLight& light : scene.lights) std::visit([&](auto& one) { change(strengthOf(one)); }, light);
}

}  // namespace

std::optional<Rgb> exactIrradiance(const Scene& scene, const Settings& settings, const ShadedPoint& at) {
    if (scene.segments.size() > kMostExactWalls || settings.maxDepth > 1 || settings.defects != DefectSet{})
        return std::nullopt;
    // Quadrature stops at an absolute error, so it is given a scene of brightness 1: light is linear in its
    // sources.
    Scene unit = scene;
    double brightness = 0.0;
    forSources(unit, [&](const Rgb& source) { brightness = std::max(brightness, largest(source)); });
    if (brightness == 0.0) return Rgb(0.0);
    forSources(unit, [&](Rgb& source) { source /= brightness; });

    const SegmentIndex index(unit);
    const Visibility visibility(index);
    if (settings.maxDepth == 0) return directIrradiance(visibility, at) * brightness;
    return halfDiskEstimate(visibility, at, Sampler::uniform, 1).mean * brightness;
}

}  // namespace halfdisk
