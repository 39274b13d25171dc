// How much light is left out where paths are cut short?
#pragma once

#include <cstdint>

namespace halfdisk {

/// Light that is scattered more often than so many times, or meets more mirrors and glass in a row.
struct BeyondDepth {
    std::uint32_t depth = 0;
    double share = 0.0;          ///< of all light at the sensor, of all its pixels and channels
    double standardError = 0.0;  ///< of what was drawn at random, or of the patches
};

inline constexpr double kSureErrors = 2.0;  // standard errors that a share is taken for larger

/// What may be missing, as far as is known.
inline double mayMiss(const BeyondDepth& beyond) {
    return beyond.share + kSureErrors * beyond.standardError;
}

/// Whether that is no more than the tolerance.
inline bool isEnough(const BeyondDepth& beyond, double tolerance) {
    return mayMiss(beyond) <= tolerance;
}

}  // namespace halfdisk
