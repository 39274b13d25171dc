// How does a path go on from wall to wall? The one loop behind every estimator that follows paths, backwards
// from a sensor or forwards from a light; each says by a visitor what it does where the path arrives.
#pragma once

#include <algorithm>

#include "surface.h"

namespace halfdisk {

/// What was spent, and what was not followed to its end.
struct Counts {
    std::uint64_t rays = 0;       ///< cast, shadow rays included
    std::uint64_t paths = 0;      ///< begun
    std::uint64_t cut = 0;        ///< ended by the limit on mirror and glass events in a row
    std::uint64_t nonFinite = 0;  ///< contributions that were not finite: left out, and told
    std::uint64_t negative = 0;   ///< contributions below zero

    void merge(const Counts& other) {
        rays += other.rays;
        paths += other.paths;
        cut += other.cut;
        nonFinite += other.nonFinite;
        negative += other.negative;
    }
};

struct WalkLimits {
    std::uint32_t scatterings = 1;  ///< at most, mirrors and glass not counted
    std::uint32_t speculars = 32;   ///< at most, in a row
    std::uint32_t roulette = 0;     ///< paths may end by chance from this scattering on; 0: never
    Directions directions = Directions::lobe;
};

/// Random numbers of a path: vertex k draws the dimensions below of sample k. 8 and more are the visitor's.
namespace draws {
inline constexpr std::uint32_t kCoin = 0, kScatterU = 1, kScatterV = 2, kRoulette = 3, kPick = 4, kLight = 5;
inline constexpr std::uint32_t kStart = 0xFFFFFFFF;  ///< the sample whose dimensions start a path
}  // namespace draws

/// A path where it arrives at a wall.
struct Arrival {
    SurfacePoint at;
    Ray ray;  ///< by which it came; ray.pdfAngle is 0 if aimed or after a specular event
    Hit hit;
    Rgb throughput{0.0};            ///< factor of radiance from here to the sensor, or power (W) that arrives
    std::uint32_t vertex = 0;       ///< 0 at the first wall
    std::uint32_t scatterings = 0;  ///< before this wall, mirrors and glass not counted
};

/// Why a path goes no further.
enum class Ending : std::uint8_t {
    back,      ///< of a one-sided wall: black
    visitor,   ///< it was asked for no more
    absorbed,  ///< the wall sends nothing on
    scatterings,
    speculars,
    roulette
};

/// A visitor that does nothing; derive from it what is needed.
struct WalkVisitor {
    /// The path flies from the ray's origin to `distance` metres along it (infinity: into the environment),
    /// with the throughput that it had at the start.
    void fly(const Ray&, double /*distance*/, const Rgb& /*throughput*/, std::uint32_t /*scatterings*/) {}
    /// It met no wall.
    void escape(const Ray&, const Rgb& /*throughput*/, std::uint32_t /*scatterings*/) {}
    /// It met a wall, on a side that acts. False ends it.
    bool arrive(const Arrival&) { return true; }
    /// It goes on from there.
    void depart(const Arrival&, const Scattered&) {}
    /// It ends at the wall where it arrived last.
    void end(Ending) {}
};

/// Follows one path until it leaves the scene, is absorbed, or reaches a limit. The draws of vertex k are
/// those of `rng`'s sample k.
// [listing]
template <class Visitor>
void walk(const SegmentIndex& index, Ray ray, Rgb throughput, Carried carried, const WalkLimits& limits,
          const Rng& rng, Counts& counts, Visitor& visitor) {
    std::uint32_t scatterings = 0;
    const double whole = std::max({throughput.x, throughput.y, throughput.z});
    for (std::uint32_t vertex = 0;; ++vertex) {
        const Hit hit = index.closestHit(ray);
        ++counts.rays;
        visitor.fly(ray, hit ? hit.t : kInfinity, throughput, scatterings);
        if (!hit) return visitor.escape(ray, throughput, scatterings);
        if (ray.medium != kNoMedium) throughput *= transmittance(index, ray.medium, hit.t);
        const Arrival arrival{surfaceAt(index, ray, hit), ray, hit, throughput, vertex, scatterings};
        if (!actsThere(index, arrival.at)) return visitor.end(Ending::back);
        if (!visitor.arrive(arrival)) return visitor.end(Ending::visitor);

        const ScatterDraws numbers{rng.uniform(vertex, draws::kCoin), rng.uniform(vertex, draws::kScatterU),
                                   rng.uniform(vertex, draws::kScatterV)};
        const auto scattered = sampleSurface(arrival.at, carried, numbers, limits.directions);
        if (!scattered) return visitor.end(Ending::absorbed);
        const std::uint32_t speculars = scattered->isDelta() ? ray.speculars + 1 : 0;
        if (speculars > limits.speculars) {
            ++counts.cut;
            return visitor.end(Ending::speculars);
        }
        if (!scattered->isDelta() && ++scatterings > limits.scatterings)
            return visitor.end(Ending::scatterings);
        throughput *= scattered->weight;
        const double left = std::max({throughput.x, throughput.y, throughput.z});
        if (!(left > 0.0)) return visitor.end(Ending::absorbed);
        if (limits.roulette > 0 && scatterings >= limits.roulette && !scattered->isDelta()) {
            const double survival = std::min(1.0, left / whole);
            if (rng.uniform(vertex, draws::kRoulette) >= survival) return visitor.end(Ending::roulette);
            throughput /= survival;
        }
        visitor.depart(arrival, *scattered);
        ray = leave(index, arrival.at, *scattered, speculars);
    }
}
// [end]

}  // namespace halfdisk
