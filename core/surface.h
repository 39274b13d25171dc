// What does a ray find where it meets a wall, and how does light go on from there?
//
// One way in and out for every estimator: surfaceAt tells what was met, evalSurface, pdfSurface and
// sampleSurface ask its material, leave starts the next ray. A facet of a round thing (Segment::normalA)
// scatters about the normal of the round thing, while cosines of arriving and leaving light are the flat
// facet's: its BRDF holds the ratio of both cosines towards the light, which makes all estimators agree
// (Veach 1997, section 5.3.3).
#pragma once

#include "intersect.h"
#include "rng.h"

namespace halfdisk {

struct SurfacePoint {
    Vec2 P;      ///< m, on the wall
    Vec2 N;      ///< unit normal of the flat wall, on the side that the ray came from
    Vec2 round;  ///< unit normal that scattering goes by, on the same side: N but on a facet of a round thing
    Vec2 from;   ///< unit, back along the ray
    std::uint32_t segment;
    bool front;            ///< that side is the wall's front
    bool isRound;          ///< a facet of a round thing
    std::uint32_t medium;  ///< glass on that side
    const Material* material;
};

/// Three numbers in (0, 1) that one scattering takes: which part of a mix (or which way through glass), and
/// two for the direction.
struct ScatterDraws {
    double coin, u, v;
};

/// The round thing's normal at the hit on its facet, on the side of the flat normal N; N, if it would be seen
/// from behind.
Vec2 roundNormalAt(const SegmentIndex& index, const Hit& hit, Vec2 from, Vec2 N);

/// `ray` of unit direction.
inline SurfacePoint surfaceAt(const SegmentIndex& index, const Ray& ray, const Hit& hit) {
    const Vec2 normal = index.normal(hit.segment), N = hit.front ? normal : -normal, from = -ray.direction;
    const bool isRound = index.isRound(hit.segment);
    return {index.pointOn(hit.segment, hit.u),
            N,
            isRound ? roundNormalAt(index, hit, from, N) : N,
            from,
            hit.segment,
            hit.front,
            isRound,
            ray.medium,
            &index.material(hit.segment)};
}

/// Whether the side of the wall that was met scatters (and a lamp's emits). The back of a one-sided wall is
/// black.
inline bool actsThere(const SegmentIndex& index, const SurfacePoint& at) {
    return at.front || index.scene().segments[at.segment].twoSided || actsOnBothSides(*at.material);
}

/// BRDF (1/rad) of all that is not a mirror or glass: radiance towards `toEye` = sum of BRDF * radiance from
/// `toLight` * (N.toLight).
Rgb evalSurface(const SurfacePoint& at, Vec2 toLight, Vec2 toEye);

/// By what density directions are drawn at matt and glossy walls.
enum class Directions : std::uint8_t {
    lobe,
    halfDisk
};  ///< as the wall scatters; or all alike, as the lesson does

/// Density (1/rad) of sampleSurface's draws that have one, for light (or sight) that came from `from`.
double pdfSurface(const SurfacePoint& at, Vec2 from, Vec2 to, Directions directions = Directions::lobe);

/// Draws where the path goes on. Empty: it ends. The weight of carried radiance is BRDF (N.direction) / pdf;
/// of carried power the BRDF's arguments change places.
std::optional<Scattered> sampleSurface(const SurfacePoint& at, Carried carried, const ScatterDraws& draws,
                                       Directions directions = Directions::lobe);

/// The ray that goes on: on the right side of the wall, in the right medium, counted if it is specular.
Ray leave(const SegmentIndex& index, const SurfacePoint& at, const Scattered& scattered,
          std::uint32_t speculars);

/// Start of a ray from a point of a wall, off its rounding error, on the side that `direction` goes to.
Vec2 originOff(const SegmentIndex& index, std::uint32_t segment, Vec2 P, Vec2 direction);

/// Share of light that glass lets through over `distance` metres (Beer).
Rgb transmittanceOf(const Material& glass, double distance);

/// The same of what a ray is in, which may be nothing.
inline Rgb transmittance(const SegmentIndex& index, std::uint32_t medium, double distance) {
    return medium == kNoMedium ? Rgb(1.0) : transmittanceOf(index.scene().materials[medium], distance);
}

/// The glass that a point lies in, if any: the shape whose skin a ray from there meets from within. O(n).
std::uint32_t mediumAt(const SegmentIndex& index, Vec2 P);

}  // namespace halfdisk
