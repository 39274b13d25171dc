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

/// The largest difference, as a share of the brightest E.
double worstChange(const std::vector<double>& home, const std::vector<double>& there) {
    double brightest = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < home.size(); ++i) {
        brightest = std::max(brightest, home[i]);
        worst = std::max(worst, std::abs(there[i] - home[i]));
    }
    return brightest > 0.0 ? worst / brightest : worst;
}

ExtremeOutcome sceneOutcome(const Scene& scene, const Placement& placement, const StopQuestion& stop) {
    ExtremeOutcome outcome;
    SurveyRays rays;
    rays.count =
        std::min<std::uint64_t>(20'000, 1 + 20'000'000 / std::max<std::size_t>(1, scene.segments.size() * 3));
    outcome.ours.counts = surveyOurs(scene, placement, rays, stop);
    const auto home = irradiances(scene, outcome.ours.counts.nonFinite, stop);
    const auto there = irradiances(placed(scene, placement), outcome.ours.counts.nonFinite, stop);
    outcome.ours.error = worstChange(home, there);
    outcome.naiveFloat.counts =
        surveyNaive(scene, placement, rays, Precision::single, EpsilonPolicy::fixed, 1e-4, stop);
    outcome.naiveDouble.counts =
        surveyNaive(scene, placement, rays, Precision::twice, EpsilonPolicy::fixed, 1e-4, stop);
    outcome.naiveFloat.error = outcome.naiveFloat.counts.lostShare();
    outcome.naiveDouble.error = outcome.naiveDouble.counts.lostShare();
    return outcome;
}

/// All that has a place, pushed along x and y by so many of its heights and widths above the middle.
Scene sheared(const Scene& scene, double alongX, double alongY) {
    Scene copy = scene;
    const Vec2 middle = boxOf(scene).middle();
    const auto push = [&](Vec2& p) {
        const Vec2 from = p - middle;
        p += Vec2(alongX * from.y, alongY * from.x);
    };
    for (Segment& wall : copy.segments) push(wall.a), push(wall.b);
    for (DeltaLight& light : copy.lights)
        if (auto* bulb = std::get_if<PointLight>(&light)) push(bulb->position);
    return copy;
}

// Nothing that brings much light is nearer than a thousandth of the scene's size s: E changes by 1000 / s for
// each metre that anything moves. But round mirrors and glass magnify, each event anew, and so do mirrors
// that face each other: what that comes to no formula tells, so it is measured. The scene is sheared by
// little more than rounding would, and what then becomes of the light, path by path, is divided by it.
double gainOf(const Scene& scene) {
    constexpr double kLeast = 1e3;
    if (!traitsOf(scene).specular) return kLeast;
    constexpr double kShear = 1e-11;  // far above rounding, far below what makes paths go elsewhere
    std::uint64_t nonFinite = 0;
    const std::vector<double> home = irradiances(scene, nonFinite, {});
    double gain = kLeast;
    for (const auto& [x, y] : {std::pair{1.0, 0.6}, {-0.7, 1.0}, {0.5, -1.0}})
        gain = std::max(
            gain,
            worstChange(home, irradiances(sheared(scene, kShear * x, kShear * y), nonFinite, {})) / kShear);
    return gain;
}

// Every coordinate is rounded to h of its size, h = 2^-53: of the scene's size s that is h (1 + offset); a
// path has some 30 such roundings. A ray that passes an edge on the other side than at home would be seen as
// 1 % and more: at 16 places times 64 paths that happens once in 1e4 scenes.
double sceneBound(double offset, double gain) {
    return 32.0 * kRounding * (1.0 + offset) * gain;
}

/// Sizes of the scene that it stands away from the origin by itself: what is rounded at home.
double ownOffset(const Scene& scene) {
    const SceneBox box = boxOf(scene);
    const Vec2 farthest = glm::max(glm::abs(box.least), glm::abs(box.most));
    return std::max(farthest.x, farthest.y) / sizeOf(scene);
}

}  // namespace

std::vector<ExtremeCell> extremeCellsOf(const Scene& scene) {
    std::vector<ExtremeCell> cells;
    const auto shared = std::make_shared<const Scene>(scene);
    const double gain = gainOf(scene);
    const std::string why = "32 roundings of coordinates, each times " + shortText(gain) +
                            (traitsOf(scene).specular ? ": what mirrors and glass make of one, by measurement"
                                                      : ": distances of 1/1000 of the scene");
    const auto add = [&](std::string id, std::string title, Placement placement) {
        cells.push_back({std::move(id), std::move(title), "E, of the brightest; naive: rays lost",
                         sceneBound(ownOffset(*shared) + placement.offset, gain), why,
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
