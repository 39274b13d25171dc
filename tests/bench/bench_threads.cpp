// How much faster are two threads, and all, than one?
#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

#include "benches.h"
#include "core/estimate.h"
#include "core/estimators.h"
#include "core/render.h"
#include "required.h"
#include "scenes.h"
#include "timing.h"

namespace halfdisk {
namespace {

/// What other programs ask of the machine besides, as told by the system; 0 if it doesn't tell.
double loadAverage() {
    double load = 0.0;
    return getloadavg(&load, 1) == 1 ? load : 0.0;
}

/// Does a fixed piece of work, `size` times, on so many threads.
using Work = std::function<void(std::uint64_t size, unsigned threads)>;

double wallSeconds(const Work& work, std::uint64_t size, unsigned threads) {
    const auto start = std::chrono::steady_clock::now();
    work(size, threads);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Scaling {
    double speedup;   ///< wall time of one thread / of many, median of pairs
    double costlier;  ///< CPU time of many threads / of one: what no idle core can win back
};

Scaling compare(const Work& work, unsigned threads, double seconds, int pairs) {
    std::uint64_t size = 1;
    while (wallSeconds(work, size, 1) < 0.5 * seconds) size *= 2;
    std::vector<double> speedups, costs;
    for (int pair = 0; pair < pairs; ++pair) {
        double wall[2], cpu[2];
        for (int k = 0; k < 2; ++k) {
            const int which = (k + pair) % 2;
            const double start = processSeconds();
            wall[which] = wallSeconds(work, size, which == 0 ? 1 : threads);
            cpu[which] = processSeconds() - start;
        }
        speedups.push_back(wall[0] / wall[1]);
        costs.push_back(cpu[1] / cpu[0]);
    }
    return {quantile(speedups, 0.5), quantile(costs, 0.5)};
}

Work castRayWork(const SegmentIndex& index) {
    return [&index](std::uint64_t size, unsigned threads) {
        Settings settings;
        settings.samples = 16;
        settings.maxDepth = 2;
        EstimateOptions options;
        options.repeats = 64 * size;
        options.threads = threads;
        estimateIrradiance(index, shadedPointOn(index, 0, 0.4), settings, options);
    };
}

/// Passes over the scene's walls by an estimator; none if it refuses.
std::optional<Work> passes(const SegmentIndex& index, std::string_view id,
                           std::vector<std::unique_ptr<Sensor>>& sensors) {
    Profile profile;
    for (std::uint32_t i = 0; i < index.scene().segments.size(); ++i) profile.segments.push_back(i);
    sensors.push_back(std::make_unique<Sensor>(profile));
    const Sensor& sensor = *sensors.back();
    const EstimatorInfo& info = *findEstimator(id);
    const Problem problem{.index = index, .sensor = sensor};
    const ParamValues values = initialValues(info);
    if (!refusalOf(info, problem, values).empty()) return std::nullopt;
    const std::shared_ptr<Estimator> estimator = info.make(problem, values);
    return [estimator, &sensor](std::uint64_t size, unsigned threads) {
        RenderOptions options;
        options.passes = 64 * size;
        options.threads = threads;
        render(*estimator, sensor, options);
    };
}

void benchOne(Report& report, const std::string& scene, std::string_view what, const Work& work,
              Effort effort) {
    const bool full = effort == Effort::full;
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    report.print("  {:<18} {:<12}", scene, what);
    nlohmann::ordered_json row{{"scene", scene}, {"work", what}};
    for (const unsigned threads : std::set<unsigned>{2, std::max(2u, cores)}) {
        const Scaling scaling = compare(work, threads, full ? 0.25 : 0.005, full ? 5 : 1);
        std::string_view mark;
        if (threads == 2 && cores >= 2)
            mark = report.judge(fmt::format("speedup by two threads, {}, {}", scene, what), scaling.speedup,
                                kSpeedupOnTwoCores);
        report.print("   {} threads: {:.2f}x {:<6} (CPU time x {:.2f})", threads, scaling.speedup, mark,
                     scaling.costlier);
        row["speedup"][std::to_string(threads)] = scaling.speedup;
        row["cpuTime"][std::to_string(threads)] = scaling.costlier;
    }
    report.print("\n");
    report.add("threads", row);
}

}  // namespace

void benchThreads(Report& report, Effort effort) {
    const double load = loadAverage();
    report.print(
        "Scaling with threads, by wall time (required on two cores: >= {:g}); load average {:.1f}{}\n",
        kSpeedupOnTwoCores, load, load > 1.5 ? ": other programs are running, which spoils it" : "");
    report.add("load", load);
    for (const auto& [name, scene] : lessonScenes()) {
        if (effort == Effort::quick && name != "small_room") continue;
        const SegmentIndex index(scene);
        benchOne(report, name, "castRay", castRayWork(index), effort);
        for (const std::string_view id : {"path", "light", "photon-map"}) {
            std::vector<std::unique_ptr<Sensor>> sensors;
            if (const auto work = passes(index, id, sensors)) benchOne(report, name, id, *work, effort);
        }
    }
}

}  // namespace halfdisk
