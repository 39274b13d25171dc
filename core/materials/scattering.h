// What do all materials speak? Directions at a wall, and what a draw of one gives.
//
// All directions are unit vectors that point away from the wall: `toLight` is where light arrives from,
// `toEye` where it leaves to. A BRDF is per radian; the cosine is never part of it.
#pragma once

#include <cmath>
#include <optional>

#include "core/math.h"

namespace halfdisk {

/// What is carried along a path that is followed. Refraction conserves L / n, so radiance scales by the ratio
/// of the indices, while the power of a particle does not (physics: Veach 1997, section 5.2, in the plane).
enum class Carried : std::uint8_t { radiance, power };

/// A direction drawn by a material.
struct Scattered {
    Vec2 direction;         ///< unit, away from the wall
    double pdfAngle = 0.0;  ///< 1/rad; 0: the only direction there was (mirror, glass)
    Rgb weight{
        0.0};  ///< BRDF cosine / pdf; of a mirror or glass the share that goes this way / its probability

    bool isDelta() const { return pdfAngle == 0.0; }
};

/// `v` mirrored about the unit normal N: the mirror direction of a ray that came from there.
inline Vec2 mirrored(Vec2 v, Vec2 N) {
    return 2.0 * glm::dot(v, N) * N - v;
}

}  // namespace halfdisk
