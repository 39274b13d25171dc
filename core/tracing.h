// What do castRay and its as-printed twin share? The scene, the settings, the observer, and the two ways to
// ask for a wall.
#pragma once

#include <cmath>

#include "light.h"
#include "rng.h"
#include "sampling.h"
#include "settings.h"

namespace halfdisk {

/// What comes back along a ray, W / (m rad), at the end where it started.
struct Radiance {
    Rgb emitted{0.0};    ///< sent out by the first wall (or the environment) itself
    Rgb scattered{0.0};  ///< reflected there

    Rgb total() const { return emitted + scattered; }
};

/// What arrives at a point over its half-disk, W / m.
struct Irradiance {
    Rgb direct{0.0};    ///< straight from lights, emitting walls and the environment
    Rgb indirect{0.0};  ///< scattered at least once before it arrived

    Rgb total() const { return direct + indirect; }
};

/// The point that is being lit: P and N of the published listing.
struct ShadedPoint {
    Vec2 P;  ///< m
    Vec2 N;  ///< unit; the half-disk lies about it
    std::uint32_t segment =
        kNoSegment;   ///< the wall that P is on, if it is on one and N is that wall's normal
    Rgb albedo{0.0};  ///< of that wall
};

/// Which of a half-disk's N samples to take: first ... last - 1. One at a time, a caller sees each sample's
/// own value.
struct SampleRange {
    std::uint32_t first, last, N;

    static SampleRange all(std::uint32_t N) { return {0, N, N}; }
    double size() const { return static_cast<double>(last - first); }
};

/// Sees nothing, at no cost. Recorder (recorder.h) has the same functions and keeps what it sees.
struct NoObserver {
    static constexpr bool keepGoing() { return true; }  ///< false: give up, the result will not be used
    static constexpr void meet(const Ray&, const Hit&, std::uint32_t, std::uint64_t) {}
    static constexpr void enter(const ShadedPoint&, std::uint32_t) {}
    static constexpr void light(std::uint32_t, std::uint32_t, const LightSample&, double, const Rgb&) {}
    static constexpr void sample(std::uint32_t, double, double) {}
    static constexpr void direction(std::uint32_t, const Ray&) {}
    static constexpr void arrival(std::uint32_t, const Ray&, const Radiance&) {}
    static constexpr void accumulate(std::uint32_t, const Rgb&, const Rgb&) {}
    static constexpr void average(const Rgb&) {}
    static constexpr void leave(const ShadedPoint&, const Irradiance&) {}
};

/// What the two estimators are made of.
template <class Observer>
struct Tracing {
    const SegmentIndex& scene;
    const Settings& settings;
    Observer& see;
    std::uint64_t rays = 0;  ///< cast so far, shadow rays included
};

/// A ray that leaves the front of P's wall: it cannot meet that straight wall again, and its origin is
/// shifted to the front by more than P's rounding error, so no corner leaks.
inline Ray rayFrom(const SegmentIndex& index, const ShadedPoint& at, Vec2 direction, double pdfAngle = 0.0) {
    if (at.segment == kNoSegment) return {at.P, direction, kNoSegment, pdfAngle};
    return {at.P + at.N * index.originShift(at.segment), direction, at.segment, pdfAngle};
}

/// The point that a ray met, its normal on the side that the ray came from.
inline ShadedPoint shadedPointAt(const SegmentIndex& index, const Hit& hit) {
    const Segment& wall = index.scene().segments[hit.segment];
    const Vec2 N = index.normal(hit.segment);
    return {index.pointOn(hit.segment, hit.u), hit.front ? N : -N, hit.segment,
            std::get<Diffuse>(index.scene().materials[wall.material]).albedo};
}

/// Whether the side that the ray met scatters and emits. The back of a one-sided wall is black.
inline bool isLitSide(const SegmentIndex& index, const Hit& hit) {
    return hit.front || index.scene().segments[hit.segment].twoSided;
}

/// Radiance that the lit side of a wall sends back along a ray, times the share that this ray may count: an
/// emitter's light is counted once in all (balance heuristic, Veach 1997, section 9.2.2). A ray that was
/// aimed, not drawn, counts it all.
inline Rgb emittedTo(const SegmentIndex& index, const Ray& ray, const Hit& hit, Emitters emitters) {
    const Rgb& emission = index.scene().segments[hit.segment].emission;
    if (ray.pdfAngle == 0.0 || emitters == Emitters::hit || emission == Rgb(0.0)) return emission;
    if (emitters == Emitters::sample) return Rgb(0.0);
    return emission * (ray.pdfAngle / (ray.pdfAngle + pdfLight(index, ray, hit)));
}

/// The other share: of a point drawn on an emitter that is seen at `cosine` = N.L. A delta light cannot be
/// met by chance. What brings nothing anyway (below the horizon, or edge-on) keeps weight 1.
inline double weightOf(const LightSample& light, const Settings& settings, double cosine) {
    if (light.segment == kNoSegment || settings.emitters == Emitters::sample) return 1.0;
    if (cosine <= 0.0 || light.pdfAngle == 0.0) return 1.0;
    return light.pdfAngle / (light.pdfAngle + pdfHalfDisk(settings.sampler, cosine));
}

/// How often a light is asked for a direction: once if it has only one, else once for each half-disk sample.
inline SampleRange drawsOf(const SegmentIndex& index, std::uint32_t light, Emitters emitters,
                           SampleRange range) {
    if (isDelta(index, light)) return SampleRange::all(1);
    return emitters == Emitters::hit ? SampleRange{0, 0, 1} : range;
}

/// Sample n of N over the half-disk: dimension 0 of its random numbers.
inline HalfDiskSample drawHalfDisk(const Settings& settings, const Rng& rng, std::uint32_t n,
                                   std::uint32_t N) {
    return sampleHalfDisk(settings.sampler, rng.uniform(n, 0), n, N);
}

/// A number in (0, 1) from dimension d: in slice n of N when the sampler is stratified.
inline double drawUnit(const Settings& settings, const Rng& rng, std::uint32_t n, std::uint32_t d,
                       std::uint32_t N) {
    const double u = rng.uniform(n, d);
    return settings.sampler == Sampler::stratified ? (n + u) / N : u;
}

}  // namespace halfdisk
