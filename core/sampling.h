// How is a direction drawn over the half-disk, and how likely was it? Published lesson, step 1.
//
// As in the published listing, theta is measured from the tangent: 0 along the frame's right, pi/2 along the
// normal, pi along its left. So the local direction is (cos theta, sin theta) and N.omega = sin theta. Every
// draw stands beside its pdf, per radian.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math.h"
#include "settings.h"

namespace halfdisk {

struct HalfDiskSample {
    double theta;     ///< rad, from the tangent, inside (0, pi)
    double pdfAngle;  ///< 1 / rad
};

/// Every angle alike. u in (0, 1).
inline HalfDiskSample sampleUniformHalfDisk(double u) {
    return {u * kPi, 1.0 / kPi};
}
inline double pdfUniformHalfDisk(double theta) {
    return theta >= 0.0 && theta <= kPi ? 1.0 / kPi : 0.0;
}

/// In proportion to N.omega: the projection of the direction on the tangent is uniform (Malley's method in
/// 2D).
inline HalfDiskSample sampleCosineHalfDisk(double u) {
    const double theta = std::acos(1.0 - 2.0 * u);
    return {theta, std::sin(theta) / 2.0};
}
inline double pdfCosineHalfDisk(double theta) {
    return theta >= 0.0 && theta <= kPi ? std::max(0.0, std::sin(theta)) / 2.0 : 0.0;
}

/// One angle in slice n of N equal slices. The pdf of a slice picked at random: the same as uniform.
inline HalfDiskSample sampleStratifiedHalfDisk(double u, std::uint32_t n, std::uint32_t N) {
    return sampleUniformHalfDisk((n + u) / N);
}

/// Sample n of N by the chosen sampler.
inline HalfDiskSample sampleHalfDisk(Sampler sampler, double u, std::uint32_t n, std::uint32_t N) {
    switch (sampler) {
        case Sampler::uniform:
            return sampleUniformHalfDisk(u);
        case Sampler::cosine:
        case Sampler::lobe:  // of a diffuse wall
            return sampleCosineHalfDisk(u);
        case Sampler::stratified:
            return sampleStratifiedHalfDisk(u, n, N);
    }
    return {};
}

/// The chosen sampler's pdf (1/rad) for a direction at `cosine` = N.omega > 0.
inline double pdfHalfDisk(Sampler sampler, double cosine) {
    return sampler == Sampler::cosine || sampler == Sampler::lobe ? cosine / 2.0 : 1.0 / kPi;
}

}  // namespace halfdisk
