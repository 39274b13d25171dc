// What does an estimator that follows paths do for one point, or for one pixel? A run of it with every step
// written down.
#pragma once

#include <optional>

#include "estimators.h"
#include "path_recorder.h"

namespace halfdisk {

struct PathRun {
    PathRecord record;
    std::string refusal;               ///< not empty: it can't do this, and there is nothing else
    Rgb estimate{0.0};                 ///< of the pixel, in the sensor's unit: of a point E, W/m
    std::optional<Rgb> standardError;  ///< of it, where the run is made of independent passes
    std::uint32_t divisor = 1;         ///< the estimate is the sum of all values, divided by this
    Counts counts;
};

/// The run of N paths for one pixel of the sensor (of a Probe 0): as many passes of an estimator that follows
/// one path for each pixel, or one pass that sends out so many paths of light (its parameter `paths` or
/// `photons`, whatever `params` says). The same question gives the same run. `path` follows for a pixel what
/// it follows for it among all others. Throws Stopped if `stop` says so. `info.recorded` must hold.
PathRun recordPaths(const EstimatorInfo& info, const SegmentIndex& index, const Sensor& sensor,
                    std::uint32_t pixel, const Settings& settings, ParamValues params,
                    const StopQuestion& stop, std::size_t eventLimit = 100'000);

}  // namespace halfdisk
