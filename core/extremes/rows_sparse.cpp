// Rows of next to nothing: a scene of one segment, of none, and without light.
#include <algorithm>

#include "core/estimate.h"
#include "core/estimators.h"
#include "core/exact.h"
#include "core/extremes/furnace.h"
#include "core/extremes/naive_lamp.h"
#include "core/extremes/rows.h"
#include "core/render.h"

namespace halfdisk {
namespace {

const ShadedPoint kFreePoint{{0.2, 0.0}, {0.0, 1.0}};

/// One lamp from 0.7 to -0.3, one metre above the point.
ExtremeOutcome oneSegment(const StopQuestion&) {
    Scene scene = furnaceOf({{0.9, 1.0}, {-0.1, 1.0}}, 0.5);
    scene.segments.resize(1);
    scene.segmentNames.resize(1);
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    const long double right = 0.9L - 0.2L, left = -0.1L - 0.2L;
    const double exact =
        static_cast<double>(right / std::sqrt(right * right + 1) - left / std::sqrt(left * left + 1));
    ExtremeOutcome outcome;
    outcome.ours.error = std::abs(directIrradiance(visibility, kFreePoint).x - exact) / exact;
    outcome.naiveFloat.error = naiveLampError<float>(kFreePoint.P, scene.segments[0], exact);
    outcome.naiveDouble.error = naiveLampError<double>(kFreePoint.P, scene.segments[0], exact);
    return outcome;
}

/// Greatest error of all estimators that take the scene, for E at the free point.
ExtremeOutcome byAllEstimators(const Scene& scene, double exact, const StopQuestion& stop) {
    const SegmentIndex index(scene);
    const Sensor sensor = Probe{kFreePoint};
    ExtremeOutcome outcome;
    outcome.naiveFloat.asked = outcome.naiveDouble.asked = false;
    for (const EstimatorInfo* info : estimators()) {
        const Problem problem{.index = index, .sensor = sensor, .maxDepth = 0, .stop = stop};
        ParamValues params = initialValues(*info);
        for (std::size_t i = 0; i < params.size(); ++i) {
            if (info->params[i].name == "photons") params[i] = 100.0;
            if (info->params[i].name == "sampler") params[i] = static_cast<double>(Sampler::cosine);
        }
        if (const std::string why = refusalOf(*info, problem, params); !why.empty()) continue;
        const auto estimator = info->make(problem, params);
        RenderOptions options;
        options.passes = 4000;
        const Film film = render(*estimator, sensor, options);
        throwIfStopped(stop);
        const Statistics E = film.pixels[0];
        outcome.ours.counts.nonFinite += film.counts.nonFinite + (isFinite(E.mean) ? 0u : 1u);
        outcome.words += (outcome.words.empty() ? "asked: " : ", ") + std::string(info->id);
        // What is drawn has noise; 5 standard errors and rounding are excused.
        const double off = std::max(0.0, std::abs(E.mean.x - exact) - 5.0 * E.standardError().x);
        outcome.ours.error = std::max(outcome.ours.error, off / std::max(exact, 1e-300));
    }
    return outcome;
}

}  // namespace

void addSparseRows(std::vector<ExtremeCell>& cells) {
    cells.push_back({"segments:1", "a scene of one segment, a lamp", "E, relative", 16.0 * kRounding,
                     "angles are quotients, and E a product of sines", oneSegment});
    cells.push_back({"segments:0", "a scene without segments, under an even sky", "E, relative",
                     64.0 * kRounding, "5 standard errors are excused, and some roundings",
                     [](const StopQuestion& stop) {
                         Scene scene;
                         scene.environment = Rgb(1.0);
                         return byAllEstimators(scene, 2.0, stop);
                     }});
    cells.push_back(
        {"light:none", "a closed room without light", "E", 0.0, "a sum of zeros",
         [](const StopQuestion& stop) {
             return byAllEstimators(furnaceOf({{-1.0, -1.0}, {2.0, -1.0}, {0.0, 2.0}}, 0.5, 0.0), 0.0, stop);
         }});
}

}  // namespace halfdisk
