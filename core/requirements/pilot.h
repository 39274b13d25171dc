// What does a plan cost in this scene, and how noisy is it? A short run, by rays: the same on every machine.
#pragma once

#include "core/film.h"
#include "core/requirements/plan.h"

namespace halfdisk {

struct Pilot {
    std::uint64_t passes = 0, rays = 0, cut = 0, paths = 0;
    std::size_t pixels = 0;
    double mean = 0.0;           ///< of all pixels and channels
    double meanError = 0.0;      ///< its standard error
    double square = 0.0;         ///< mean over pixels and channels of the squared mean
    double variance = 0.0;       ///< of one pass, mean over pixels and channels
    double seconds = 0.0;        ///< of the passes, wall-clock, one thread
    double preparation = 0.0;    ///< seconds before the first pass
    std::vector<Rgb> picture;    ///< mean of every pixel
    std::vector<double> totals;  ///< of each pass: mean of all pixels and channels

    double raysPerPass() const {
        return passes > 0 ? static_cast<double>(rays) / static_cast<double>(passes) : 0.0;
    }
    double secondsPerRay() const { return rays > 0 ? seconds / static_cast<double>(rays) : 0.0; }
    /// Rays until noise is so large a part of the light (root mean squares over the pixels): n = V / (rho^2
    /// light^2) passes.
    double raysTo(double relativeError) const;
    double secondsTo(double relativeError) const { return raysTo(relativeError) * secondsPerRay(); }
};

/// Relative standard error of the mean; infinite where no light was met.
inline double lightError(const Pilot& run) {
    return run.mean > 0.0 ? run.meanError / run.mean : kInfinity;
}

inline constexpr double kSurely = 3.0;  ///< standard errors

inline double surelyBrought(const Pilot& run) {
    return run.mean - kSurely * run.meanError;
}

/// Whether it brings surely less than what another surely does, or nothing.
inline bool lacksLight(const Pilot& run, double surely) {
    return run.mean == 0.0 || run.mean + kSurely * run.meanError < surely;
}

/// Whether its paths know the light, and are so long that joining them from both ends, each vertex with each
/// and each weighed over all, would take too long.
inline bool tooLongToJoin(const Pilot& run) {
    constexpr double kKnown = 0.1, kLong = 50.0;  // rays
    const double raysPerPath = static_cast<double>(run.rays) / static_cast<double>(run.paths);
    return lightError(run) < kKnown && raysPerPath > kLong;
}

struct PilotLimits {
    std::uint64_t rays = 60'000;  ///< ends after the pass that reaches it, or as many samples of pixels
    std::uint64_t leastPasses = 8;
};

/// The same question of fewer pixels: pictures of any size are planned in the same time.
Sensor pilotSensor(const Sensor& sensor);

/// Throws std::invalid_argument with its words if the estimator refuses, and Stopped if problem.stop says so.
Pilot pilot(const Problem& problem, const Plan& plan, const PilotLimits& limits);

}  // namespace halfdisk
