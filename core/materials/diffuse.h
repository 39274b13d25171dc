// How does a matt wall scatter? Evenly: its radiance is the same from everywhere (Lambert 1760).
#pragma once

#include "core/materials/scattering.h"

namespace halfdisk {

/// BRDF albedo / 2 per radian, since the cosine integrates to 2 over a half-disk.
struct Diffuse {
    Rgb albedo{0.8};  ///< reflected / arriving power, 0 ... 1 per channel
    bool operator==(const Diffuse&) const = default;
};

inline Rgb evalDiffuse(const Diffuse& wall) {
    return wall.albedo / 2.0;
}

/// 1/rad, of sampleDiffuse. 0 below the wall.
inline double pdfDiffuse(Vec2 N, Vec2 to) {
    return std::max(0.0, glm::dot(N, to)) / 2.0;
}

/// In proportion to the cosine: its projection on the wall, 1 - 2u, is uniform. u in (0, 1).
inline Scattered sampleDiffuse(const Diffuse& wall, Vec2 N, double u) {
    const double along = 1.0 - 2.0 * u, up = std::sqrt((1.0 - along) * (1.0 + along));
    return {frameFromNormal(N).toWorld(along, up), up / 2.0, wall.albedo};
}

}  // namespace halfdisk
