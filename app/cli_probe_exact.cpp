// What is the exact answer to a probe, where quadrature gives it while one waits?
#include "app/cli_probe.h"
#include "core/exact.h"

namespace halfdisk {
namespace {

/// The work grows with the cube of the walls.
constexpr std::size_t kMostExactWalls = 60;

}  // namespace

std::optional<Rgb> exactIrradiance(const Scene& scene, const Settings& settings, const ShadedPoint& at) {
    if (scene.segments.size() > kMostExactWalls || settings.maxDepth > 1 || settings.defects != DefectSet{})
        return std::nullopt;
    if (!traitsOf(scene).diffuseOnly) return std::nullopt;
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    if (settings.maxDepth == 0) return directIrradiance(visibility, at);
    return halfDiskEstimate(visibility, at, Sampler::uniform, 1).mean;
}

}  // namespace halfdisk
