// Rows of a scene of one's own: as it is, against itself scaled and moved.
#include <algorithm>
#include <memory>

#include "core/estimate.h"
#include "core/estimators.h"
#include "core/extremes/rows.h"
#include "core/render.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kMostPlaces = 16;

/// E at the middles of up to 16 walls, by `path`: the same random numbers wherever the scene stands.
std::vector<double> irradiances(const Scene& scene, std::uint64_t& nonFinite, const StopQuestion& stop) {
    const SegmentIndex index(scene);
    const EstimatorInfo& path = *findEstimator("path");
    const auto walls = static_cast<std::uint32_t>(scene.segments.size());
    const std::uint32_t step = std::max(1u, walls / kMostPlaces);
    std::vector<double> Es;
    for (std::uint32_t wall = 0; wall < walls; wall += step) {
        const Sensor sensor = Probe{shadedPointOn(index, wall, 0.4637)};
        const Problem problem{.index = index, .sensor = sensor, .maxDepth = 2, .stop = stop};
        const auto estimator = path.make(problem, initialValues(path));
        RenderOptions options;
        options.passes = 64;
        const Film film = render(*estimator, sensor, options);
        throwIfStopped(stop);
        nonFinite += film.counts.nonFinite;
        const Rgb mean = film.pixels[0].mean;
        Es.push_back((mean.x + mean.y + mean.z) / 3.0);
    }
    return Es;
}

ExtremeOutcome sceneOutcome(const Scene& scene, const Placement& placement, const StopQuestion& stop) {
    ExtremeOutcome outcome;
    SurveyRays rays;
    rays.count =
        std::min<std::uint64_t>(20'000, 1 + 20'000'000 / std::max<std::size_t>(1, scene.segments.size() * 3));
    outcome.ours.counts = surveyOurs(scene, placement, rays, stop);
    const auto home = irradiances(scene, outcome.ours.counts.nonFinite, stop);
    const auto there = irradiances(placed(scene, placement), outcome.ours.counts.nonFinite, stop);
    double brightest = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < home.size(); ++i) {
        brightest = std::max(brightest, home[i]);
        worst = std::max(worst, std::abs(there[i] - home[i]));
    }
    outcome.ours.error = brightest > 0.0 ? worst / brightest : worst;
    outcome.naiveFloat.counts =
        surveyNaive(scene, placement, rays, Precision::single, EpsilonPolicy::fixed, 1e-4, stop);
    outcome.naiveDouble.counts =
        surveyNaive(scene, placement, rays, Precision::twice, EpsilonPolicy::fixed, 1e-4, stop);
    outcome.naiveFloat.error = outcome.naiveFloat.counts.lostShare();
    outcome.naiveDouble.error = outcome.naiveDouble.counts.lostShare();
    return outcome;
}

// Every coordinate is rounded to h of its size, h = 2^-53: of the scene's size s that is h (1 + offset).
// Light changes by 1 / r for each metre that anything moves; nothing that brings much light is nearer than a
// thousandth of s, and a path has some 30 such roundings. A ray that passes an edge on the other side than at
// home would be seen as 1 % and more: at 16 places times 64 paths that happens once in 1e4 scenes.
double sceneBound(double offset) {
    return 32.0 * kRounding * (1.0 + offset) / 1e-3;
}

}  // namespace

std::vector<ExtremeCell> extremeCellsOf(const Scene& scene) {
    std::vector<ExtremeCell> cells;
    const auto shared = std::make_shared<const Scene>(scene);
    const auto add = [&](std::string id, std::string title, Placement placement) {
        cells.push_back({std::move(id), std::move(title), "E, of the brightest; naive: rays lost",
                         sceneBound(placement.offset),
                         "32 roundings of coordinates, at distances of 1/1000 of the scene",
                         [shared, placement](const StopQuestion& stop) {
                             return sceneOutcome(*shared, placement, stop);
                         }});
    };
    for (const double scale : {1e-6, 1e-3, 1e3, 1e6})
        add("scale:" + powerText(scale), "the scene scaled by " + powerText(scale), {scale, 0.0});
    for (const double offset : {1.0, 1e3, 1e5})
        add("offset:" + powerText(offset), "the scene " + powerText(offset) + " times its size away",
            {1.0, offset});
    return cells;
}

}  // namespace halfdisk
