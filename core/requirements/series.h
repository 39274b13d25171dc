// How much light is cut off where paths are cut short? The same paths are followed further, with the same
// random numbers, so that the difference is what the further events bring.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

inline constexpr double kSeriesRays = 100'000.0;
inline constexpr double kSure = 2.0;  // standard errors that a measured share is taken for larger

/// A way that finds all light, to be followed deep.
struct Series {
    Plan plan;
    std::uint32_t deepest;
};

/// Nothing if no way finds all light.
std::optional<Series> seriesOf(const RequirementsQuestion& question, std::uint32_t maxSpecular);

/// Of the light of `all` that is not in `upTo`, which has the same passes, cut after so many events.
BeyondDepth shareBeyond(std::uint32_t events, const Pilot& all, const Pilot& upTo);

/// What may be missing, as far as is known.
inline double mayMiss(const BeyondDepth& beyond) {
    return beyond.share + kSure * beyond.standardError;
}

/// Whether that is no more than the tolerance.
inline bool isEnough(const BeyondDepth& beyond, double tolerance) {
    return mayMiss(beyond) <= tolerance;
}

/// `0.44 % (± 0.23 %) of the light`, and, where that is what decided, what it was taken for.
std::string shareWords(const BeyondDepth& beyond, double tolerance);

}  // namespace halfdisk
