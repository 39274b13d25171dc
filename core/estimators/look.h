// What is seen along a ray, straight or through mirrors and glass? The step by which estimators that know the
// light on scattering walls from elsewhere look at it.
#pragma once

#include "core/direct_light.h"
#include "core/walk.h"

namespace halfdisk {

/// Which lamps and sky that are met along the way count: none; those seen by mirrors or glass; all.
enum class Met : std::uint8_t { none, bySpeculars, all };

/// Walks up to the first wall that scatters what it reflects; mirrors' parts of mixed walls are followed.
/// `Outgoing` gives the radiance that such a wall sends back (its emission apart): Rgb(const Arrival&).
template <class Outgoing>
struct LookVisitor : WalkVisitor {
    const SegmentIndex& index;
    Met met;
    const Outgoing& outgoing;
    Rgb found{0.0};

    LookVisitor(const SegmentIndex& scene, Met counted, const Outgoing& ofWall)
        : index(scene), met(counted), outgoing(ofWall) {}

    bool counts(const Ray& ray) const {
        return met == Met::all || (met == Met::bySpeculars && ray.speculars > 0);
    }

    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t) {
        if (counts(ray)) found += throughput * index.environment(ray.direction);
    }

    bool arrive(const Arrival& here) {
        const Segment& wall = index.scene().segments[here.hit.segment];
        if (isEmitter(wall) && (here.at.front || wall.twoSided) && counts(here.ray))
            found += here.throughput * wall.emission;
        if (!isSpecular(*here.at.material)) found += here.throughput * outgoing(here);
        return true;
    }
};

/// `throughput` times the radiance that arrives along `ray`.
template <class Outgoing>
Rgb look(const SegmentIndex& index, const Ray& ray, const Rgb& throughput, std::uint32_t mostSpecular,
         Met met, const Rng& rng, Counts& counts, const Outgoing& outgoing) {
    LookVisitor<Outgoing> visitor(index, met, outgoing);
    const WalkLimits limits{.scatterings = 0, .speculars = mostSpecular};
    walk(index, ray, throughput, Carried::radiance, limits, rng, counts, visitor);
    return visitor.found;
}

/// Radiance that a scattering wall sends back of the light that it gets straight from one light, drawn by the
/// numbers of the arrival's vertex.
inline Rgb directFrom(const LightTable& lights, const Arrival& here, const Rng& rng, Counts& counts) {
    const DrawnLight light = drawLight(lights, here.at, rng.uniform(here.vertex, draws::kPick),
                                       rng.uniform(here.vertex, draws::kLight), counts);
    if (light.L_i == Rgb(0.0)) return Rgb(0.0);
    return evalSurface(here.at, light.L, here.at.from) * light.L_i * glm::dot(here.at.N, light.L);
}

/// What a receiver gets straight from one light, drawn by the numbers of the path's start.
inline Rgb directAt(const LightTable& lights, const Receiver& receiver, const Rng& rng, Counts& counts) {
    const DrawnLight light = drawLight(lights, receiver, rng.uniform(draws::kStart, draws::kPick),
                                       rng.uniform(draws::kStart, draws::kLight), counts);
    if (light.L_i == Rgb(0.0)) return Rgb(0.0);
    return light.L_i * responseTo(receiver, light.L).weight;
}

}  // namespace halfdisk
