// What is in a scene that decides which light there can be? What follows from its file alone.
#pragma once

#include "core/estimator.h"

namespace halfdisk {

struct SceneFacts {
    SceneTraits traits;
    std::size_t points = 0, suns = 0, lamps = 0;
    bool environment = false;
    std::size_t mirrors = 0, glass = 0, mixes = 0,
                glossy = 0;  ///< walls; a mix with a mirror in it is a mirror too
    /// Share that any wall scatters of what arrives, at most; of any channel. Of a mix with a mirror, which
    /// mirrors some of it, that is the share if all walls were like it.
    double mostAlbedo = 0.0;
    double mostReflectance = 0.0;  ///< of mirrors
    double mostExponent = 0.0;     ///< of lobes
    /// A lamp shines on a wall so near that what a point on it brings, cos cos' / r, is no longer bounded by
    /// much: two hundredths of the lamp's length, or it touches.
    bool lampInCorner = false;
    bool grey = true;  ///< no light and no wall differs by channel
    /// Mirror and glass events in a row, if geometry has a bound.
    std::optional<std::uint32_t> longestChain;
    std::string chainReason;  ///< why it has, or has not
};

SceneFacts factsOf(const Scene& scene);

/// Least D with share^(D + 1) / (1 - share) <= tolerance: what walls that scatter at most that share leave of
/// the light after more than D scatterings. Empty if the share is 1.
std::optional<std::uint32_t> scatteringsUntil(double share, double tolerance);

}  // namespace halfdisk
