// How does a light that is known everywhere become a picture? One place is drawn for every pixel, and the
// light is asked there.
#pragma once

#include "core/estimator.h"
#include "core/exact.h"
#include "core/walk.h"

namespace halfdisk {

/// What `light` says of one receiver. `light` has irradiance(const ShadedPoint&, Counts&, ArcMemory&) and
/// fluence(Vec2, Counts&, ArcMemory&); walls that are looked at must be flat and diffuse. `u` draws the
/// direction that an eye looks to.
template <class Light>
Rgb receivedAt(const Light& light, const SegmentIndex& index, const Receiver& receiver, double u,
               Counts& counts, ArcMemory& memory) {
    if (receiver.covered) return Rgb(0.0);
    if (receiver.weighing == Weighing::cosine) return light.irradiance(receiver.at, counts, memory);
    if (receiver.weighing == Weighing::even) return light.fluence(receiver.at.P, counts, memory);
    const Sight sight = sightFrom(receiver, index, u);
    const Hit hit = index.closestHit(sight.ray);
    ++counts.rays;
    if (!hit) return index.environment(sight.ray.direction) * sight.weight;
    if (!isLitSide(index, hit)) return Rgb(0.0);
    const ShadedPoint there = shadedPointAt(index, hit);
    const Rgb& emission = index.scene().segments[hit.segment].emission;
    if (there.albedo == Rgb(0.0)) return emission * sight.weight;
    return (emission + there.albedo / 2.0 * light.irradiance(there, counts, memory)) * sight.weight;
}

/// One pass: the same places for the same seed, pass and pixel.
template <class Light>
void addPlaces(const Light& light, const Problem& problem, const Receivers& receivers, std::uint64_t pass,
               Picture& picture, Counts& counts) {
    ArcMemory memory;
    for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
        throwIfStopped(problem.stop);
        const Rng rng = Rng(problem.seed, pass).child(pixel);
        const Receiver receiver =
            receivers.draw(pixel, rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
        addTo(picture, pixel,
              receivedAt(light, problem.index, receiver, rng.uniform(draws::kStart, 2), counts, memory),
              counts);
        ++counts.paths;
    }
}

}  // namespace halfdisk
