// What do castRay and its as-printed twin share? The scene, the settings, the observer, and the two ways to
// ask for a wall.
#pragma once

#include <cmath>

#include "half_circle.h"
#include "light.h"
#include "lobe.h"
#include "overload.h"
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
        kNoSegment;                    ///< the wall that P is on, if it is on one and N is that wall's normal
    Rgb albedo{0.0};                   ///< of that wall
    Lobe lobe{};                       ///< what that wall favours; default: nothing, as for irradiance
    std::uint32_t medium = kNoMedium;  ///< glass that P lies in
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
    std::uint64_t cut = 0;   ///< of which were not followed past maxSpecular mirrors and glass skins
};

/// A ray that leaves P's wall on the side of the half-disk: it cannot meet that straight wall again, and its
/// origin is shifted by more than P's rounding error, so no corner leaks.
inline Ray rayFrom(const SegmentIndex& index, const ShadedPoint& at, Vec2 direction, double pdfAngle = 0.0) {
    if (at.segment == kNoSegment) return {at.P, direction, kNoSegment, pdfAngle, at.medium};
    return {at.P + at.N * index.originShift(at.segment), direction, at.segment, pdfAngle, at.medium};
}

/// The matt or glossy wall that a ray met, as a point to gather light at. Of a mix, `coin` picks the part;
/// not for mirrors and glass.
inline ShadedPoint shadedPointAt(const SurfacePoint& met, double coin) {
    const auto as = [&](const auto& part) {
        return ShadedPoint{met.P, met.N, met.segment, part.albedo, lobeOf(part, met), met.medium};
    };
    return std::visit(
        Overload{[&](const Diffuse& wall) { return as(wall); }, [&](const Glossy& wall) { return as(wall); },
                 [&](const Mix& wall) {
                     const auto* glossy = std::get_if<Glossy>(&wall.specular);
                     return glossy && coin < wall.weight ? as(*glossy) : as(wall.diffuse);
                 },
                 [&](const auto&) {
                     return ShadedPoint{met.P, met.N, met.segment};
                 }},
        *met.material);
}

/// The same where all walls are diffuse and flat, its normal on the side that the ray came from.
inline ShadedPoint shadedPointAt(const SegmentIndex& index, const Hit& hit) {
    const Vec2 N = index.normal(hit.segment);
    return {index.pointOn(hit.segment, hit.u), hit.front ? N : -N, hit.segment,
            std::get<Diffuse>(index.material(hit.segment)).albedo};
}

/// Whether the side of a diffuse wall that the ray met scatters and emits.
inline bool isLitSide(const SegmentIndex& index, const Hit& hit) {
    return hit.front || index.scene().segments[hit.segment].twoSided;
}

/// Random numbers of a ray's own, where it meets a wall: beside those of the wall's half-disk.
inline constexpr std::uint32_t kOwnSample = 0xFFFFFFFF;
inline double coinOf(const SurfacePoint& met, const Rng& rng) {
    const bool tossed =
        std::holds_alternative<Mix>(*met.material) || std::holds_alternative<Dielectric>(*met.material);
    return tossed ? rng.uniform(kOwnSample, 0) : 1.0;
}

/// Whether the coin makes the wall a mirror, or glass, for this ray.
inline bool isSpecularFor(const SurfacePoint& met, double coin) {
    if (const auto* mix = std::get_if<Mix>(met.material))
        return coin < mix->weight && std::holds_alternative<Mirror>(mix->specular);
    return isSpecular(*met.material);
}

/// 1/rad, with which drawHalfDisk draws a direction L above the wall.
inline double pdfHalfDisk(Sampler sampler, const ShadedPoint& at, Vec2 L) {
    if (sampler != Sampler::lobe || at.lobe.isMatt()) return pdfHalfDisk(sampler, glm::dot(at.N, L));
    return lobeShape(at.lobe.exponent, at.lobe.axis, L) / lobeIntegral(at.lobe.exponent);
}

/// Radiance that the lit side of a wall sends back along a ray, times the share that this ray may count: an
/// emitter's light is counted once in all (balance heuristic, Veach 1997, section 9.2.2). A ray that was
/// aimed, not drawn, counts it all.
inline Rgb emittedTo(const SegmentIndex& index, const Ray& ray, const Hit& hit, Emitters emitters) {
    const Segment& wall = index.scene().segments[hit.segment];
    const Rgb emission = hit.front || wall.twoSided ? wall.emission : Rgb(0.0);
    if (ray.pdfAngle == 0.0 || emitters == Emitters::hit || emission == Rgb(0.0)) return emission;
    if (emitters == Emitters::sample) return Rgb(0.0);
    return emission * (ray.pdfAngle / (ray.pdfAngle + pdfLight(index, ray, hit)));
}

/// The other share: of a point drawn on an emitter that is seen at `cosine` = N.L. A delta light cannot be
/// met by chance. What brings nothing anyway (below the horizon, or edge-on) keeps weight 1.
inline double weightOf(const LightSample& light, const Settings& settings, const ShadedPoint& at) {
    const double cosine = glm::dot(at.N, light.L);
    if (light.segment == kNoSegment || settings.emitters == Emitters::sample) return 1.0;
    if (cosine <= 0.0 || light.pdfAngle == 0.0) return 1.0;
    return light.pdfAngle / (light.pdfAngle + pdfHalfDisk(settings.sampler, at, light.L));
}

/// How often a light is asked for a direction: once if it has only one, else once for each half-disk sample.
inline SampleRange drawsOf(const SegmentIndex& index, std::uint32_t light, Emitters emitters,
                           SampleRange range) {
    if (isDelta(index, light)) return SampleRange::all(1);
    return emitters == Emitters::hit ? SampleRange{0, 0, 1} : range;
}

/// Sample n of N over the half-disk, from dimension 0 of its random numbers (of a lobe, the last one too).
/// Theta beyond (0, pi) is a lobe's part below the wall.
inline HalfDiskSample drawHalfDisk(const Settings& settings, const ShadedPoint& at, UniformRow& draws,
                                   std::uint32_t n, std::uint32_t N) {
    const double u = draws(n);
    if (settings.sampler != Sampler::lobe || at.lobe.isMatt())
        return sampleHalfDisk(settings.sampler, u, n, N);
    const double angle = sampleLobeAngle(at.lobe.exponent, u, draws.rng().uniform(n, kOwnSample));
    const double axis = std::atan2(glm::dot(at.lobe.axis, at.N), cross(at.lobe.axis, at.N));
    return {axis + angle, std::pow(std::cos(angle), at.lobe.exponent) / lobeIntegral(at.lobe.exponent)};
}

/// A number in (0, 1): in slice n of N when the sampler is stratified.
inline double drawUnit(const Settings& settings, UniformRow& draws, std::uint32_t n, std::uint32_t N) {
    const double u = draws(n);
    return settings.sampler == Sampler::stratified ? (n + u) / N : u;
}

}  // namespace halfdisk
