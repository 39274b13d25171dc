// How does a glossy wall scatter? In a lobe about the mirror direction.
//
// The lobe of Phong (1975) in its energy-conserving, reciprocal form (Lafortune & Willems 1994, "Using the
// modified Phong reflectance model for physically based rendering"), brought to the plane: f = albedo
// cos^n(a) / I(n + 1), a the angle to the mirror direction and I(n) the integral of cos^n over (-pi/2, pi/2).
// With n = 0 it is even, but still cut at a right angle from the mirror direction: Lambert's at normal
// incidence only.
#pragma once

#include "core/materials/scattering.h"

namespace halfdisk {

struct Glossy {
    Rgb albedo{0.8};  ///< reflected / arriving power at normal incidence; less at a slant, where the wall
                      ///< cuts the lobe
    double exponent = 20.0;  ///< n >= 0: 0 is the broadest lobe, large is nearly a mirror
    bool operator==(const Glossy&) const = default;
};

inline constexpr double kMostExponent = 1e6;

/// Exponent of a roughness r in 0 ... 1: n = 2 / r^2 - 2, so that 1 is the broadest lobe (n = 0) and a lobe's
/// width, about sqrt(1/n) rad, grows as r. Limited to kMostExponent, which r = 0.0014 and below reach: it is
/// a narrow lobe still, and sends less at a slant; a true mirror is a Mirror.
inline double exponentOfRoughness(double roughness) {
    const double square = roughness * roughness;
    return square * (kMostExponent + 2.0) <= 2.0 ? kMostExponent : std::max(0.0, 2.0 / square - 2.0);
}

/// I(n) = sqrt(pi) Gamma((n + 1)/2) / Gamma(n/2 + 1), for n >= 0, to about 1e-13: steps of I(n) = I(n + 2) (n
/// + 2)/(n + 1) up to where the series of Gamma(k + 1/2) / Gamma(k) in 1/k holds, k = (n + 1)/2 (Graham,
/// Knuth & Patashnik, exercise 9.60).
inline double lobeIntegral(double n) {
    double steps = 1.0;
    for (; n < 48.0; n += 2.0) steps *= (n + 2.0) / (n + 1.0);
    const double x = 2.0 / (n + 1.0);
    const double series =
        1.0 + x * (-1.0 / 8 +
                   x * (1.0 / 128 +
                        x * (5.0 / 1024 +
                             x * (-21.0 / 32768 + x * (-399.0 / 262144 +
                                                       x * (869.0 / 4194304 + x * (39325.0 / 33554432)))))));
    return steps * std::sqrt(kPi * x) / series;
}

/// cos^n of the angle between two unit vectors; 0 beyond a right angle.
inline double lobeShape(double exponent, Vec2 axis, Vec2 direction) {
    const double cosine = glm::dot(axis, direction);
    return cosine <= 0.0 ? 0.0 : std::pow(std::min(1.0, cosine), exponent);
}

/// BRDF, 1/rad: 0 where either direction lies below the wall.
inline Rgb evalGlossy(const Glossy& wall, Vec2 N, Vec2 toLight, Vec2 toEye) {
    if (glm::dot(N, toLight) <= 0.0 || glm::dot(N, toEye) <= 0.0) return Rgb(0.0);
    return wall.albedo *
           (lobeShape(wall.exponent, mirrored(toEye, N), toLight) / lobeIntegral(wall.exponent + 1.0));
}

/// 1/rad, of sampleGlossy. 0 below the wall: what the lobe sends there is lost, so over the half-disk it
/// integrates to 1 or less.
inline double pdfGlossy(const Glossy& wall, Vec2 N, Vec2 from, Vec2 to) {
    if (glm::dot(N, to) <= 0.0) return 0.0;
    return lobeShape(wall.exponent, mirrored(from, N), to) / lobeIntegral(wall.exponent);
}

/// An angle (rad, from the lobe's axis) with density cos^n / I(n): sin of it is t / sqrt(v + t^2) for t of
/// Student's distribution with v = n + 1 degrees of freedom, which two uniform numbers give (Bailey 1994,
/// "Polar generation of random variates with the t-distribution").
inline double sampleLobeAngle(double exponent, double u, double v) {
    const double radius = std::sqrt(std::expm1(-2.0 / (exponent + 1.0) * std::log(u)));
    return std::atan(radius * std::cos(2.0 * kPi * v));
}

/// Empty if the direction drawn lies below the wall. u, v in (0, 1).
inline std::optional<Scattered> sampleGlossy(const Glossy& wall, Vec2 N, Vec2 from, double u, double v) {
    const double angle = sampleLobeAngle(wall.exponent, u, v);
    const Vec2 axis = mirrored(from, N);
    const Vec2 to = std::cos(angle) * axis + std::sin(angle) * perp(axis);
    const double pdfAngle = pdfGlossy(wall, N, from, to);
    if (!(pdfAngle > 0.0)) return std::nullopt;
    return Scattered{to, pdfAngle, evalGlossy(wall, N, to, from) * (glm::dot(N, to) / pdfAngle)};
}

}  // namespace halfdisk
