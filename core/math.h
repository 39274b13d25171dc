// What are points, directions and colours in flatland, and how does a half-disk get its frame?
#pragma once

#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace halfdisk {

using Vec2 = glm::dvec2;  ///< a point (m) or a direction (unit length where so named), world frame
using Rgb = glm::dvec3;   ///< one value per colour channel: radiance, irradiance, albedo, ...

inline constexpr double kPi = std::numbers::pi;

/// z of the 3D cross product: > 0 when `v` lies to the left of `u`.
constexpr double cross(Vec2 u, Vec2 v) {
    return u.x * v.y - u.y * v.x;
}

/// `v` turned by +90 degrees: perp(b - a) points to the front (left) side of a segment a->b.
constexpr Vec2 perp(Vec2 v) {
    return {-v.y, v.x};
}

/// The 2x2 frame of a half-disk: columns are its `right` and its `up`, so a local (x, y) lands on x right + y
/// up. Published lesson, step 2; the matrix printed there mirrors the normal (see as_printed.h).
struct Frame {
    double rotMat[2][2];

    Vec2 toWorld(double x, double y) const {
        return {x * rotMat[0][0] + y * rotMat[0][1], x * rotMat[1][0] + y * rotMat[1][1]};
    }
};

/// Frame whose up is the unit normal N and whose right is (N.y, -N.x).
constexpr Frame frameFromNormal(Vec2 N) {
    return {{{N.y, N.x}, {-N.x, N.y}}};
}

inline bool isFinite(Vec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
inline bool isFinite(const Rgb& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

}  // namespace halfdisk
