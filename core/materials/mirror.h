// How does a mirror reflect? All in one direction, so there is nothing to evaluate: only to follow.
#pragma once

#include "core/materials/scattering.h"

namespace halfdisk {

/// A perfect mirror, on both of its sides.
struct Mirror {
    Rgb reflectance{1.0};  ///< reflected / arriving power, 0 ... 1 per channel
    bool operator==(const Mirror&) const = default;
};

inline Scattered sampleMirror(const Mirror& wall, Vec2 N, Vec2 from) {
    return {mirrored(from, N), 0.0, wall.reflectance};
}

}  // namespace halfdisk
