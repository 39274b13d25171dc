// How many rays a second does each estimator trace on each scene of the lessons?
#include "benches.h"
#include "core/estimators.h"
#include "core/render.h"
#include "scenes.h"
#include "timing.h"

namespace halfdisk {
namespace {

/// The irradiance on all walls: every estimator serves it.
Sensor allWalls(const Scene& scene) {
    Profile profile;
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i) profile.segments.push_back(i);
    return profile;
}

struct Speed {
    std::string refusal;       ///< empty: it did
    double raysPerSecond = 0;  ///< CPU time of the passes
    double prepared = 0;       ///< s, before the first pass
};

Speed measure(const EstimatorInfo& info, const SegmentIndex& index, double seconds) {
    const Sensor sensor = allWalls(index.scene());
    const Problem problem{.index = index, .sensor = sensor};
    const ParamValues values = initialValues(info);
    Speed speed;
    speed.refusal = refusalOf(info, problem, values);
    if (!speed.refusal.empty()) return speed;
    const double begin = threadSeconds();
    std::unique_ptr<Estimator> estimator;
    try {
        estimator = info.make(problem, values);
    } catch (const std::invalid_argument& refusal) {
        speed.refusal = refusal.what();
        return speed;
    }
    speed.prepared = threadSeconds() - begin;
    std::vector<double> speeds;
    for (std::uint64_t first = 0, turn = 0; turn < 5; ++turn) {
        const double start = threadSeconds();
        RenderOptions options;
        options.firstPass = first;
        options.passes = 1'000'000;
        options.stop = [&] { return threadSeconds() - start > seconds / 5.0; };
        const Film film = render(*estimator, sensor, options);
        first += film.passes;
        speeds.push_back(static_cast<double>(film.counts.rays) / (threadSeconds() - start));
    }
    speed.raysPerSecond = quantile(speeds, 0.5);
    return speed;
}

}  // namespace

void benchEstimators(Report& report, Effort effort) {
    const double seconds = effort == Effort::full ? 0.5 : 0.005;
    report.print(
        "Million rays a second on one core: irradiance on all walls in 64 bins, depth {}, parameters as they "
        "are\n",
        kMaxDepthInfo.initial);
    report.print("  {:<18}", "scene");
    for (const EstimatorInfo* info : estimators()) report.print(" {:>14}", info->id);
    report.print("\n");
    for (const auto& [name, scene] : lessonScenes()) {
        const SegmentIndex index(scene);
        report.print("  {:<18}", name);
        for (const EstimatorInfo* info : estimators()) {
            const Speed speed = measure(*info, index, seconds);
            nlohmann::ordered_json row{{"scene", name}, {"estimator", info->id}};
            if (speed.refusal.empty()) {
                // An estimator that casts no rays once it is prepared, such as radiosity, has no speed.
                report.print(" {:>14}", speed.raysPerSecond > 0.0
                                            ? fmt::format("{:.2f}", 1e-6 * speed.raysPerSecond)
                                            : "no rays");
                row["raysPerSecond"] = speed.raysPerSecond;
                row["prepareSeconds"] = speed.prepared;
            } else {
                report.print(" {:>14}", "refuses");
                row["refusal"] = speed.refusal;
            }
            report.add("estimators", row);
        }
        report.print("\n");
    }
}

}  // namespace halfdisk
