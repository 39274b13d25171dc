// What is seen where no wall is? Light from infinitely far away, the same from every point: a ring of
// radiance.
#pragma once

#include <algorithm>
#include <vector>

#include "math.h"

namespace halfdisk {

/// Radiance by direction: a constant, or a strip of equal angles that it multiplies.
struct Environment {
    Rgb radiance{0.0};       ///< W / (m rad)
    std::vector<Rgb> strip;  ///< factors; entry k spans the directions 2 pi k / n ... 2 pi (k + 1) / n from
                             ///< +x, counter-clockwise; empty: 1

    Environment() = default;
    Environment(const Rgb& constant) : radiance(constant) {}  // NOLINT: a colour is an environment
    bool operator==(const Environment&) const = default;
};

/// Entry of the strip that lies in a direction (of any length).
inline std::size_t stripIndex(std::size_t entries, Vec2 direction) {
    const double turn = std::atan2(direction.y, direction.x) / (2.0 * kPi);
    const double place = (turn < 0.0 ? turn + 1.0 : turn) * static_cast<double>(entries);
    return std::min(static_cast<std::size_t>(place), entries - 1);
}

inline Rgb radianceFrom(const Environment& environment, Vec2 direction) {
    if (environment.strip.empty()) return environment.radiance;
    return environment.radiance * environment.strip[stripIndex(environment.strip.size(), direction)];
}

}  // namespace halfdisk
