// By which rays does a place gather light, and how much comes to it straight?
#pragma once

#include "core/path_recorder.h"

namespace halfdisk {

/// Draws `count` directions from a scattering wall, spread evenly over what it favours, and calls each(ray,
/// share, rng): the sum of `share` times the radiance that each ray meets estimates what the wall sends back
/// along here.ray. Mirrors' parts of mixed walls are left out: whoever looks follows them.
template <class Each>
void forDirections(const SegmentIndex& index, const Arrival& here, std::uint32_t count, const Rng& rng,
                   const Each& each) {
    for (std::uint32_t n = 0; n < count; ++n) {
        const Rng ofRay = rng.child(here.vertex).child(n);
        const ScatterDraws numbers{ofRay.uniform(draws::kStart, 0),
                                   (n + ofRay.uniform(draws::kStart, 1)) / count,
                                   ofRay.uniform(draws::kStart, 2)};
        const auto way = sampleSurface(here.at, Carried::radiance, numbers);
        if (!way || way->isDelta()) continue;
        each(leave(index, here.at, *way, 0), way->weight / static_cast<double>(count), ofRay);
    }
}

/// The same at a receiver that gathers.
template <class Each>
void forDirections(const SegmentIndex& index, const Receiver& receiver, std::uint32_t count, const Rng& rng,
                   const Each& each) {
    for (std::uint32_t n = 0; n < count; ++n) {
        const Rng ofRay = rng.child(draws::kStart).child(n);
        const Sight sight = sightFrom(receiver, index, (n + ofRay.uniform(draws::kStart, 0)) / count);
        each(sight.ray, Rgb(sight.weight / count), ofRay);
    }
}

/// Directions that look for direct light beside each light that is asked, where no other rays do: few beside
/// what the rest of the light costs.
inline constexpr std::uint32_t kDirectRays = 4;

/// Light straight from lamps, sky and lights without size: radiance that an Arrival's wall sends back of it,
/// or what a Receiver gets. `see` (may be null) is told it times `throughput`.
// [listing]
template <class Place>
Rgb directLight(const LightTable& lights, const Place& place, const Rng& rng, Counts& counts,
                PathRecorder* see = nullptr, const Rgb& throughput = Rgb(1.0)) {
    const LightWays ways{.perLight = kDirectRays};
    const AskedLight asked = askLight(ways, lights, place, rng, counts);
    if (see) see->asked(place.at.P, asked, throughput * asked.value);
    Rgb sum = asked.value;
    if (!canBeMet(lights)) return sum;
    forDirections(lights.index(), place, kDirectRays, rng, [&](const Ray& ray, const Rgb& share, const Rng&) {
        const Hit hit = lights.index().closestHit(ray);
        ++counts.rays;
        const Rgb clear = hit ? transmittance(lights.index(), ray.medium, hit.t) : Rgb(1.0);
        const Rgb light = share * (lightMet(ways, lights, ray, hit) * clear);
        sum += light;
        if (see && light != Rgb(0.0))
            see->met(ray, hit, weightMet(ways, lights, ray, hit), throughput * light);
    });
    return sum;
}
// [end]

}  // namespace halfdisk
