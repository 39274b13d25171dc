// How many samples does an answer of a given precision take? A small run first, then one that is large
// enough.
#pragma once

#include "core/estimate.h"
#include "support.h"

namespace halfdisk::test {

/// Stop at this relative precision of the mean, or after about so many rays.
struct Effort {
    double precision = 0.004;
    double rays = 6e6;
    std::uint32_t samplesPerBounce = 2;
    std::uint64_t pilot = 300;  ///< repeats of the small run
    double leastRepeats = 100.0;
};

/// E at `at` in one channel is expected to be `scale` (W/m) in size; the standard error aims at precision *
/// scale.
inline Estimate measure(const SegmentIndex& index, const ShadedPoint& at, Settings settings, const Rgb& scale,
                        const Effort& effort = {}) {
    settings.samples = effort.samplesPerBounce;
    const Estimate pilot = estimateIrradiance(index, at, settings, {.repeats = effort.pilot});
    double factor = 1.0;
    for (int c = 0; c < 3; ++c) {
        if (!(scale[c] > 0.0)) continue;
        const double error = pilot.repeats.standardError()[c] / (effort.precision * scale[c]);
        factor = std::max(factor, error * error);
        if (pilot.repeats.mean[c] == 0.0) factor = kInfinity;  // so rare that the small run saw none of it
    }
    const double runs = static_cast<double>(effort.pilot);
    const double most = std::max(effort.leastRepeats, effort.rays * runs / static_cast<double>(pilot.rays));
    const double repeats = std::clamp(runs * factor, effort.leastRepeats, most);
    // Other random numbers than the small run's, or its luck would decide how far the large one goes.
    return estimateIrradiance(
        index, at, settings,
        {.firstRepeat = effort.pilot, .repeats = static_cast<std::uint64_t>(repeats), .threads = 2});
}

}  // namespace halfdisk::test
