// What does a ray cost, and what does castRay's observer cost when nobody observes?
#include "benches.h"
#include "core/cast_ray.h"
#include "core/estimate.h"
#include "required.h"
#include "scenes.h"
#include "timing.h"
#include "unobserved_cast_ray.h"

namespace halfdisk {
namespace {

struct Run {
    double seconds = 0.0;
    std::uint64_t rays = 0;
    Rgb sum{0.0};  // so that nothing is optimised away, and both do the same
};

/// `repeats` runs of one of the two twins.
template <template <class> class Twin>
Run measure(const SegmentIndex& index, const Settings& settings, int repeats) {
    Run run;
    NoObserver observer;
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    const double start = threadSeconds();
    for (int repeat = 0; repeat < repeats; ++repeat) {
        Twin<NoObserver> twin{{index, settings, observer}};
        run.sum += twin.gatherLight(at, 0, Rng(settings.seed, static_cast<std::uint64_t>(repeat)),
                                    SampleRange::all(settings.samples))
                       .total();
        run.rays += twin.rays;
    }
    run.seconds = threadSeconds() - start;
    return run;
}

struct Comparison {
    double ratio;  ///< median over the pairs of observed / unobserved
    double nanosecondsPerRay;
};

Comparison compare(const SegmentIndex& index, Effort effort) {
    Settings settings;
    settings.samples = 32;
    settings.maxDepth = 2;
    const bool full = effort == Effort::full;
    const int pairs = full ? 41 : 3, repeats = full ? 12 : 1;
    std::vector<double> ratios, perRay;
    for (int pair = -1; pair < pairs; ++pair) {  // the first warms up
        // Each goes first in every other pair, so that neither always finds the other's caches.
        Run observed, unobserved;
        if (pair % 2 == 0) observed = measure<CastRay>(index, settings, repeats);
        unobserved = measure<UnobservedCastRay>(index, settings, repeats);
        if (pair % 2 != 0) observed = measure<CastRay>(index, settings, repeats);
        if (observed.sum != unobserved.sum || observed.rays != unobserved.rays)
            throw std::logic_error("castRay and its unobserved twin do not compute the same");
        if (pair < 0) continue;
        ratios.push_back(observed.seconds / unobserved.seconds);
        perRay.push_back(1e9 * observed.seconds / static_cast<double>(observed.rays));
    }
    return {quantile(ratios, 0.5), quantile(perRay, 0.5)};
}

}  // namespace

void benchObserver(Report& report, Effort effort) {
    report.print(
        "castRay with NoObserver against the same source without observer: observer ratio (required: < 1.02),"
        " and ns per ray\n");
    report.print("  {:<24} {:>8} {:>10} {:>12}\n", "scene", "walls", "ratio", "per ray");
    for (const auto& [name, scene] : lessonScenes()) {
        const SegmentIndex index(scene);
        const Comparison result = compare(index, effort);
        const auto mark = report.judge("observer ratio, " + name, result.ratio, std::nullopt, kObserverRatio);
        report.print("  {:<24} {:>8} {:>10.4f} {:>9.1f} ns  {}\n", name, scene.segments.size(), result.ratio,
                     result.nanosecondsPerRay, mark);
        report.add("observer", {{"scene", name},
                                {"walls", scene.segments.size()},
                                {"ratio", result.ratio},
                                {"nanosecondsPerRay", result.nanosecondsPerRay}});
    }
}

}  // namespace halfdisk
