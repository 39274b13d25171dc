// How does one find a lamp's light in an afternoon? As the difference of two sines.
#pragma once

#include "core/extremes/naive_room.h"

namespace halfdisk {

/// Relative error of E at P, on an upright normal, from a lamp of radiance 1 between a and b: in `Real` from
/// its coordinates on.
template <class Real>
double naiveLampError(Vec2 P, const Segment& lamp, double exact) {
    const auto sine = [&](Vec2 end) {
        const Real x = static_cast<Real>(end.x) - static_cast<Real>(P.x),
                   y = static_cast<Real>(end.y) - static_cast<Real>(P.y);
        return x / std::sqrt(x * x + y * y);
    };
    const Real E = std::abs(sine(lamp.a) - sine(lamp.b));
    return std::abs(static_cast<double>(E) - exact) / exact;
}

}  // namespace halfdisk
