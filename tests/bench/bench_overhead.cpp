// What does a ray of castRay cost beyond the index: sampling, shading, statistics?
#include <stdexcept>

#include "benches.h"
#include "core/estimate.h"
#include "required.h"
#include "scenes.h"
#include "timing.h"

namespace halfdisk {
namespace {

/// A ray that was cast: for a wall, or for a way to a light.
struct CastOne {
    Ray ray;
    double tMax = 0.0;  ///< of a shadow ray; 0: for a wall
    std::uint32_t lamp = kNoSegment;
};

/// Writes down the rays that castRay casts.
struct RayList : NoObserver {
    const SegmentIndex* index = nullptr;
    std::vector<ShadedPoint> gathering;  // the points whose half-disks are being gathered
    std::vector<CastOne> rays;

    void meet(const Ray& ray, const Hit&, std::uint32_t, std::uint64_t) { rays.push_back({ray}); }
    void enter(const ShadedPoint& at, std::uint32_t) { gathering.push_back(at); }
    void leave(const ShadedPoint&, const Irradiance&) { gathering.pop_back(); }
    void light(std::uint32_t, std::uint32_t, const LightSample& light, double, const Rgb&) {
        const ShadedPoint& at = gathering.back();
        if (glm::dot(at.N, light.L) <= 0.0 || light.L_i == Rgb(0.0)) return;
        rays.push_back({rayFrom(*index, at, light.L), light.distance, light.segment});
    }
};

Settings settings() {
    Settings chosen;
    chosen.samples = 16;
    chosen.maxDepth = 2;
    return chosen;
}

/// The work that is measured: so many repeats at one point.
EstimateOptions options(std::uint64_t repeats) {
    EstimateOptions chosen;
    chosen.repeats = repeats;
    return chosen;
}

std::vector<CastOne> raysOf(const SegmentIndex& index, const ShadedPoint& at, std::uint64_t repeats) {
    RayList list;
    list.index = &index;
    std::uint64_t count = 0;
    const Settings chosen = settings();
    for (std::uint64_t repeat = 0; repeat < repeats; ++repeat)
        for (std::uint32_t n = 0; n < chosen.samples; ++n)
            gatherOnce(index, at, chosen, repeat, {n, n + 1, chosen.samples}, list, count);
    if (count != list.rays.size() || count != estimateIrradiance(index, at, chosen, options(repeats)).rays)
        throw std::logic_error("not the rays that castRay casts were written down");
    return list.rays;
}

struct Costs {
    double all, index;  ///< ns per ray
    double beyond;      ///< the difference, median over turns
    std::size_t rays;
};

Costs measure(const SegmentIndex& index, Effort effort) {
    const bool full = effort == Effort::full;
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    // About 10 000 rays: they fit into the second-level cache.
    const std::uint64_t repeats = 1 + 10'000 / raysOf(index, at, 1).size();
    const std::vector<CastOne> rays = raysOf(index, at, repeats);
    std::vector<double> all, alone, beyond;
    double sum = 0.0;  // so that nothing is optimised away
    const int rounds = full ? 20 : 1;
    for (int turn = -1; turn < (full ? 21 : 2); ++turn) {
        const double start = threadSeconds();
        for (int i = 0; i < rounds; ++i)
            sum += estimateIrradiance(index, at, settings(), options(repeats)).direct.x;
        const double middle = threadSeconds();
        for (int i = 0; i < rounds; ++i)
            for (const CastOne& cast : rays)
                sum += cast.tMax == 0.0 ? index.closestHit(cast.ray).u
                                        : index.occluded(cast.ray, cast.tMax, cast.lamp);
        const double end = threadSeconds();
        if (turn < 0) continue;
        const double nanoseconds = 1e9 / (static_cast<double>(rays.size()) * rounds);
        all.push_back(nanoseconds * (middle - start));
        alone.push_back(nanoseconds * (end - middle));
        beyond.push_back(all.back() - alone.back());
    }
    if (!(sum >= 0.0)) throw std::logic_error("light is not a number");
    return {quantile(all, 0.5), quantile(alone, 0.5), quantile(beyond, 0.5), rays.size()};
}

}  // namespace

void benchOverhead(Report& report, Effort effort) {
    report.print(
        "castRay with its statistics, and the index alone on the same rays one by one: ns per ray (required "
        "beyond "
        "the index: < {:g})\n",
        kOverheadNanoseconds);
    report.print("  {:<18} {:>8} {:>8} {:>10} {:>10} {:>10}\n", "scene", "walls", "rays", "castRay", "index",
                 "beyond");
    for (const auto& [name, scene] : lessonScenes()) {
        const SegmentIndex index(scene);
        const Costs costs = measure(index, effort);
        const auto mark = report.judge("ns per ray beyond the index, " + name, costs.beyond, std::nullopt,
                                       kOverheadNanoseconds);
        report.print("  {:<18} {:>8} {:>8} {:>10.1f} {:>10.1f} {:>10.1f} {}\n", name, scene.segments.size(),
                     costs.rays, costs.all, costs.index, costs.beyond, mark);
        report.add("overhead", {{"scene", name},
                                {"walls", scene.segments.size()},
                                {"castRay", costs.all},
                                {"index", costs.index},
                                {"beyond", costs.beyond}});
    }
}

}  // namespace halfdisk
