// How does an estimator work until it has done enough? Passes until their number, the time, or Ctrl-C ends
// them.
#pragma once

#include <functional>
#include <optional>

#include "core/render.h"

namespace halfdisk {

struct MeasureLimits {
    std::uint64_t passes = 1;       ///< at most
    std::optional<double> seconds;  ///< of wall-clock time, preparation included; the passes under way end
    unsigned threads = 1;
};

struct Measurement {
    Film film;
    double seconds = 0.0;      ///< wall-clock, of preparation and passes
    bool interrupted = false;  ///< somebody asked to stop; film.passes tells how far it got, maybe 0
};

/// Shows a progress bar on a terminal, and ends by a signal (interruption.h) or when `stop` (may be empty)
/// says so, within milliseconds, with the passes that are done. `firstPixels` (may be null) receives the
/// first pixel of every pass that was made, in their order; only for numbers of passes that fit. Throws
/// InputError if the estimator refuses, before any work.
Measurement measure(const EstimatorInfo& info, const Problem& problem, const ParamValues& params,
                    const MeasureLimits& limits, const std::function<bool()>& stop = {},
                    std::vector<Rgb>* firstPixels = nullptr);

/// `37 of 64 samples`, or `37 samples in 1.2 of 600 s`.
std::string howFar(const Measurement& measurement, const MeasureLimits& limits);

}  // namespace halfdisk
