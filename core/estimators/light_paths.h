// How is light sent out for a pass that stores where it arrives? At random over the power of all lights, or
// spread evenly.
#pragma once

#include "core/estimator.h"
#include "core/path_recorder.h"

namespace halfdisk {

/// Child of a pass's random numbers that its light paths draw from; pixels take the children from 0 on.
inline constexpr std::uint32_t kLightPathsChild = 0xFFFFFFF0;

enum class Spread : std::uint8_t { random, stratified };
inline constexpr std::array<std::string_view, 2> kSpreads{"random", "stratified"};
inline constexpr ParamInfo kSpreadParam{
    .name = "spread",
    .meaning = "where light sets out: at random, or evenly over the power of the lights within a pass",
    .choices = kSpreads};

/// Follows `paths` paths of light. The power they carry is the scene's whole power, shared. `see` may be
/// null. Throws Stopped if `stop` says so.
// [listing]
template <class Visitor>
void sendLight(const LightTable& lights, std::uint32_t paths, Spread spread, const WalkLimits& limits,
               const Rng& ofPass, Counts& counts, Visitor& visitor, PathRecorder* see,
               const StopQuestion& stop) {
    const Rng ofPaths = ofPass.child(kLightPathsChild);
    for (std::uint32_t path = 0; path < paths; ++path) {
        throwIfStopped(stop, path);
        const Rng rng = ofPaths.child(path);
        const double u = rng.uniform(draws::kStart, 0);
        const Emission light =
            lights.emit(spread == Spread::stratified ? (path + u) / paths : u, rng.uniform(draws::kStart, 1));
        ++counts.paths;
        if (light.power == Rgb(0.0)) continue;
        const Rgb power = light.power / static_cast<double>(paths);
        if (see) see->start(Carried::power, light.ray.origin, power, light.segment);
        Watched watched{visitor, see};
        walk(lights.index(), light.ray, power, Carried::power, limits, rng, counts, watched);
    }
}
// [end]

}  // namespace halfdisk
