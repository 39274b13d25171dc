// Would single precision hold a scene where it stands? What it would do to its walls.
#pragma once

#include "core/scene.h"

namespace halfdisk {

/// A wall whose ends float moves by more than this share of its length no longer points where it should.
inline constexpr double kMostBent = 1e-4;

struct FloatFit {
    double rounding = 0.0;  ///< m, how far float would move an end at most
    std::size_t bent = 0;   ///< walls that would be moved by more than kMostBent of their length
    std::size_t lost = 0;   ///< of these, walls of no length
    bool holds() const { return bent == 0; }
};

/// Of coordinates as they stand. The index centres and scales them before it uses float at all, and decides
/// every hit in double: what this tells is what a program that keeps floats would do.
FloatFit floatFitOf(const Scene& scene);

}  // namespace halfdisk
