// How much does a stretch of the half-disk count, and where does it lie? For sums over visible arcs.
#pragma once

#include "exact.h"

namespace halfdisk {

/// Unit; theta (rad) from the tangent.
inline Vec2 directionAt(const ShadedPoint& at, double theta) {
    return frameFromNormal(at.N).toWorld(std::cos(theta), std::sin(theta));
}

/// rad from the tangent, 0 ... pi above it.
inline double thetaOf(const ShadedPoint& at, Vec2 direction) {
    return std::atan2(glm::dot(at.N, direction), at.N.y * direction.x - at.N.x * direction.y);
}

inline Vec2 middleOf(const ShadedPoint& at, const VisibleArc& arc) {
    return directionAt(at, (arc.from + arc.to) / 2.0);
}

/// Irradiance from radiance 1 between two angles, cos from - cos to, without the cancellation that a narrow
/// arc would suffer.
inline double cosineBetween(double from, double to) {
    return 2.0 * std::sin((from + to) / 2.0) * std::sin((to - from) / 2.0);
}

/// Fluence (W/m) at a free point straight from the point and directional lights.
inline Rgb deltaFluence(const SegmentIndex& index, Vec2 P) {
    Rgb sum{0.0};
    for (std::uint32_t i = 0; i < index.scene().lights.size(); ++i) {
        const LightSample light = sampleLight(index, i, P, 0.5);
        if (!index.occluded({P, light.L}, light.distance)) sum += light.L_i;
    }
    return sum;
}

}  // namespace halfdisk
