// How does glass split light? By Fresnel's equations, into a reflected ray and, by Snell's law, a refracted
// one.
#pragma once

#include "core/materials/scattering.h"

namespace halfdisk {

/// The skin of a closed shape of glass; its segments' fronts are outside, where the index is 1.
struct Dielectric {
    double ior = 1.5;  ///< index of refraction of the inside, 1 or more
    Rgb absorption{
        0.0};  ///< Beer's coefficient of the inside, 1/m: light that runs r metres keeps exp(-absorption r)
    bool operator==(const Dielectric&) const = default;
};

/// What happens to light that arrives at `cosine` >= 0 to the normal, out of a medium of index n1, at one of
/// index n2.
struct Refraction {
    double reflected = 1.0;  ///< share of the power; 1: total internal reflection
    double cosine = 0.0;     ///< of the refracted ray to the normal on its own side
};

/// Unpolarised: the mean of the reflectances of both polarisations (Born & Wolf, "Principles of Optics",
/// section 1.5).
inline Refraction refraction(double cosine, double n1, double n2) {
    if (n1 == n2) return {0.0, cosine};
    const double ratio = n1 / n2;
    const double square = 1.0 - ratio * ratio * (1.0 - cosine) * (1.0 + cosine);
    if (!(square > 0.0)) return {};
    const double refracted = std::sqrt(square);
    const double s = (n1 * cosine - n2 * refracted) / (n1 * cosine + n2 * refracted);
    const double p = (n2 * cosine - n1 * refracted) / (n2 * cosine + n1 * refracted);
    return {(s * s + p * p) / 2.0, refracted};
}

/// `outside`: the ray arrived from the front. Draws one of the two ways with the probability of its share of
/// the power, so the weight is 1, times the ratio of the indices where radiance passes (n of the side it is
/// carried to over n of the other). u in (0, 1).
inline Scattered sampleDielectric(const Dielectric& glass, Vec2 N, Vec2 from, bool outside, Carried carried,
                                  double u) {
    const double n1 = outside ? 1.0 : glass.ior, n2 = outside ? glass.ior : 1.0;
    const double cosine = std::min(1.0, glm::dot(N, from));
    const Refraction split = refraction(cosine, n1, n2);
    if (u < split.reflected) return {mirrored(from, N), 0.0, Rgb(1.0)};
    const Vec2 along = (cosine * N - from) * (n1 / n2);
    return {glm::normalize(along - split.cosine * N), 0.0, Rgb(carried == Carried::radiance ? n1 / n2 : 1.0)};
}

}  // namespace halfdisk
