// How much does a wall favour one direction? The factor by which a glossy wall's BRDF, or a facet's of a
// round thing, differs from that of a flat diffuse wall of the same albedo.
//
// castRay gathers over the half-disk and multiplies by albedo / 2 at the end, as the published listing does
// for diffuse walls. Seen so, a glossy wall is the same wall with favourites: albedo cos^n / I(n + 1) =
// albedo / 2 times 2 cos^n / I(n + 1), where a matt wall has 1.
#pragma once

#include "surface.h"

namespace halfdisk {

struct Lobe {
    double exponent = 0.0;  ///< of the cosine of the angle to `axis`
    double scale = 1.0;     ///< 2 / I(exponent + 1)
    Vec2 axis{0.0};         ///< mirror direction of the ray that met the wall, unit; zero: a matt wall
    Vec2 round{0.0};        ///< normal of the round thing that the wall is a facet of; zero: flat

    bool isMatt() const { return axis == Vec2(0.0); }
    bool isEven() const { return isMatt() && round == Vec2(0.0); }
};

/// Mean 1 over the directions, weighed by their cosine, at normal incidence. N: of the flat wall.
inline double favour(const Lobe& lobe, Vec2 N, Vec2 L) {
    if (lobe.isEven()) return 1.0;
    double factor = lobe.scale;
    if (!lobe.isMatt()) factor *= lobeShape(lobe.exponent, lobe.axis, L);
    if (lobe.round == Vec2(0.0)) return factor;
    const double height = glm::dot(N, L);
    return height > 0.0 ? factor * std::max(0.0, glm::dot(lobe.round, L)) / height : 0.0;
}

/// Of a matt wall, for a point `at` on it.
inline Lobe lobeOf(const Diffuse&, const SurfacePoint& at) {
    return {.round = at.round == at.N ? Vec2(0.0) : at.round};
}
inline Lobe lobeOf(const Glossy& wall, const SurfacePoint& at) {
    Lobe lobe = lobeOf(Diffuse{}, at);
    lobe.exponent = wall.exponent;
    lobe.scale = 2.0 / lobeIntegral(wall.exponent + 1.0);
    lobe.axis = mirrored(at.from, at.round);
    return lobe;
}

}  // namespace halfdisk
