// What is the light at a point, how sure are we, and what did it cost? Many samples of castRay, on any number
// of threads.
#pragma once

#include <atomic>
#include <optional>

#include "as_printed.h"
#include "cast_ray.h"
#include "cover.h"
#include "statistics.h"

namespace halfdisk {

/// Result of R repeats of N samples each.
struct Estimate {
    Statistics repeats;  ///< of the R means of E, W / m
    Statistics samples;  ///< of every first-bounce sample's own estimate of E
    Rgb direct{0.0};     ///< mean, light that was never scattered
    Rgb indirect{0.0};   ///< mean, light that was
    std::uint64_t rays = 0;

    Rgb irradiance() const { return samples.mean; }
    std::uint64_t nonFinite() const { return samples.nonFinite; }
};

struct EstimateOptions {
    std::uint64_t firstRepeat = 0;  ///< repeat r draws other random numbers than repeat s
    std::uint64_t repeats = 1;
    unsigned threads = 1;
    const std::atomic<bool>* cancelled = nullptr;  ///< may be set at any time: the result is then incomplete
};

/// Sees only whether the work is called off.
struct CancelObserver : NoObserver {
    const std::atomic<bool>* cancelled;
    bool keepGoing() const { return !cancelled->load(std::memory_order_relaxed); }
};

/// Irradiance at `at` by castRay, or by its as-printed twin if any defect is switched on. The same bits for
/// any number of threads: chunks of a fixed size are added up in their order.
Estimate estimateIrradiance(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                            const EstimateOptions& options = {});

/// One pass over the samples in `range` of one repeat, seen by `observer`, at a place that is not covered.
/// Adds the rays cast to `rays`.
template <class Observer>
Irradiance gatherInOpen(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                        std::uint64_t repeat, SampleRange range, Observer& observer, std::uint64_t& rays) {
    const auto gather = [&](auto tracer) {
        const Irradiance gathered = tracer.gatherLight(at, 0, Rng(settings.seed, repeat), range);
        rays += tracer.rays;
        return gathered;
    };
    if (settings.defects == DefectSet{}) return gather(CastRay<Observer>{{index, settings, observer}});
    return gather(AsPrinted<Observer>{{index, settings, observer}});
}

/// The same anywhere: behind another wall (cover.h) nothing arrives.
template <class Observer>
Irradiance gatherOnce(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                      std::uint64_t repeat, SampleRange range, Observer& observer, std::uint64_t& rays) {
    if (isCovered(index, at)) return {};
    return gatherInOpen(index, at, settings, repeat, range, observer, rays);
}

/// Upper bound on the rays of one repeat: every ray meets a wall and every light is asked. Infinity past
/// 1e300.
double raysPerRepeat(const SegmentIndex& index, const Settings& settings);

/// The point of a probe: `normal` empty takes the front of the wall that P lies on.
/// P counts as on a wall within 1e-9 of the scene's extent. Empty if neither a wall nor a normal is there.
std::optional<ShadedPoint> shadedPointAt(const SegmentIndex& index, Vec2 P, std::optional<Vec2> normal);

/// A point of a wall, by the wall's parameter t in 0 ... 1, on its front.
ShadedPoint shadedPointOn(const SegmentIndex& index, std::uint32_t segment, double t);

/// Radiance that a wall sends out when E arrives: emission + albedo / 2 E (as printed: albedo / pi).
Rgb outgoingRadiance(const SegmentIndex& index, const ShadedPoint& at, const Rgb& irradiance,
                     DefectSet defects = {});

}  // namespace halfdisk
