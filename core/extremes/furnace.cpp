#include "furnace.h"

#include <algorithm>

#include "core/estimate.h"
#include "core/estimators.h"
#include "core/exact.h"
#include "core/render.h"

namespace halfdisk {
namespace {

ParamValues paramsByChance(const EstimatorInfo& path) {
    ParamValues params = initialValues(path);
    for (std::size_t i = 0; i < path.params.size(); ++i) {
        if (path.params[i].name == "emitters") params[i] = static_cast<double>(Emitters::hit);
        if (path.params[i].name == "roulette") params[i] = 0.0;
    }
    return params;
}

template <class Real>
double naiveError(const Scene& furnace, const FurnaceQuestion& question, EpsilonPolicy policy,
                  const StopQuestion& stop) {
    const NaiveRoom<Real> room(furnace, policy);
    const auto walls = std::min<std::uint64_t>(question.walls, room.walls.size());
    const auto emission = static_cast<Real>(question.emission), albedo = static_cast<Real>(question.albedo);
    const double exact =
        2.0 * closedRoomRadiance(question.emission, question.albedo, static_cast<int>(question.depth));
    const Rng rng(1, 0);
    Real sum = 0;
    for (std::uint64_t n = 0; n < question.paths; ++n) {
        throwIfStopped(stop, n);
        const Rng mine = rng.child(static_cast<std::uint32_t>(n));
        auto wall = static_cast<std::uint32_t>(n % walls);
        NaivePoint<Real> P = room.pointOn(wall, static_cast<Real>(mine.uniform(0, 1)));
        Real throughput = 1, L = 0;
        for (std::uint32_t k = 0; k <= question.depth; ++k) {
            // In proportion to the cosine; 2 is the integral of it.
            const auto theta = static_cast<Real>(std::acos(1.0 - 2.0 * mine.uniform(k, 0)));
            const NaiveRay<Real> ray = room.rayFrom(wall, P, theta);
            const NaiveHit<Real> hit = room.closestHit(ray);
            if (hit.segment == kNoSegment || !hit.front) break;
            L += throughput * emission;
            throughput *= albedo;
            P = {ray.origin.x + hit.t * ray.direction.x, ray.origin.y + hit.t * ray.direction.y};
            wall = hit.segment;
        }
        sum += 2 * L;
    }
    const double mean = static_cast<double>(sum / static_cast<Real>(question.paths));
    return std::abs(mean - exact) / exact;
}

}  // namespace

Scene furnaceOf(const std::vector<Vec2>& points, double albedo, double emission) {
    Scene scene;
    scene.materials.emplace_back(Diffuse{Rgb(albedo)});
    scene.materialNames.emplace_back("wall");
    for (std::size_t i = 0; i < points.size(); ++i) {
        Segment wall;
        wall.a = points[i];
        wall.b = points[(i + 1) % points.size()];
        wall.emission = Rgb(emission);
        scene.segments.push_back(wall);
        scene.segmentNames.push_back("wall." + std::to_string(i));
    }
    return scene;
}

std::vector<Vec2> furnacePolygon() {
    return {{0.0, 0.0}, {2.0, -0.3}, {3.1, 1.0}, {2.2, 1.2}, {2.5, 2.6}, {-0.4, 1.9}};
}

double furnaceError(const Scene& furnace, const FurnaceQuestion& question, const StopQuestion& stop) {
    const SegmentIndex index(furnace);
    const EstimatorInfo& path = *findEstimator("path");
    const double exact =
        2.0 * closedRoomRadiance(question.emission, question.albedo, static_cast<int>(question.depth));
    const auto walls =
        static_cast<std::uint32_t>(std::min<std::size_t>(question.walls, furnace.segments.size()));
    double worst = 0.0;
    for (std::uint32_t wall = 0; wall < walls; ++wall) {
        const Sensor sensor = Probe{shadedPointOn(index, wall, 0.37)};
        const Problem problem{.index = index, .sensor = sensor, .maxDepth = question.depth, .stop = stop};
        const auto estimator = path.make(problem, paramsByChance(path));
        RenderOptions options;
        options.passes = std::max<std::uint64_t>(1, question.paths / walls);
        const Film film = render(*estimator, sensor, options);
        throwIfStopped(stop);
        const double error = std::abs(film.pixels[0].mean.x - exact) / exact;
        worst = film.counts.nonFinite > 0 ? kInfinity : std::max(worst, error);
    }
    return worst;
}

double naiveFurnaceError(const Scene& furnace, const FurnaceQuestion& question, Precision precision,
                         EpsilonPolicy policy, const StopQuestion& stop) {
    return precision == Precision::single ? naiveError<float>(furnace, question, policy, stop)
                                          : naiveError<double>(furnace, question, policy, stop);
}

ExtremeOutcome furnaceOutcome(const Scene& furnace, const Placement& placement,
                              const FurnaceQuestion& question, const SurveyRays& rays,
                              const StopQuestion& stop) {
    const Scene there = placed(furnace, placement);
    const auto naive = [&](Precision precision) {
        return ExtremeSide{
            naiveFurnaceError(there, question, precision, EpsilonPolicy::fixed, stop),
            surveyNaive(furnace, placement, rays, precision, EpsilonPolicy::fixed, 1e-4, stop)};
    };
    ExtremeOutcome outcome;
    outcome.ours = {furnaceError(there, question, stop), surveyOurs(furnace, placement, rays, stop)};
    outcome.naiveFloat = naive(Precision::single);
    outcome.naiveDouble = naive(Precision::twice);
    return outcome;
}

// With h = epsilon / 2: the k-th term of a path is a product of k + 2 factors, off by (k + 2) h, added with
// one more rounding of at most the sum, so all D + 1 terms together are off by no more than (2 D + 3) h of
// the sum. The exact value, and the division by it, are as good. The mean of n values that are all alike but
// for this never leaves their range by more than a rounding a step of what is left of their differences: 4 h.
// A single path of n that loses as little as its last bounce takes a^D / n of the sum: 1e-5 and more in all
// rows.
double furnaceBound(std::uint32_t depth) {
    return (4.0 * depth + 16.0) * std::numeric_limits<double>::epsilon() / 2.0;
}

}  // namespace halfdisk
