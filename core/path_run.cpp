#include "path_run.h"

#include <stdexcept>

namespace halfdisk {
namespace {

/// The parameter that says how many paths of light one pass has; null: a pass is one path.
double* pathsOfLight(const EstimatorInfo& info, ParamValues& params) {
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (info.params[i].name == "paths" || info.params[i].name == "photons") return &params[i];
    return nullptr;
}

}  // namespace

PathRun recordPaths(const EstimatorInfo& info, const SegmentIndex& index, const Sensor& sensor,
                    std::uint32_t pixel, const Settings& settings, ParamValues params,
                    const StopQuestion& stop, std::size_t eventLimit) {
    PathRun run;
    double* lightPaths = pathsOfLight(info, params);
    if (lightPaths) *lightPaths = settings.samples;
    const std::uint32_t passes = lightPaths ? 1 : settings.samples;

    const std::uint32_t pixels = pixelCount(sensor);
    PathRecorder recorder(eventLimit, pixels > 1 ? std::optional(pixel) : std::nullopt);
    const Problem problem{.index = index,
                          .sensor = sensor,
                          .maxDepth = settings.maxDepth,
                          .maxSpecular = settings.maxSpecular,
                          .seed = settings.seed,
                          .stop = stop,
                          .record = &recorder};
    run.refusal = refusalOf(info, problem, params);
    if (!run.refusal.empty()) return run;
    std::unique_ptr<Estimator> estimator;
    try {
        estimator = info.make(problem, params);
    } catch (const std::invalid_argument& refusal) {  // found on the way
        run.refusal = refusal.what();
        return run;
    }
    Statistics values;
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
        Picture picture(pixels, Rgb(0.0));
        estimator->addPass(pass, picture, run.counts);
        values.add(picture[pixel]);
    }
    run.divisor = passes;
    run.estimate = values.mean;
    if (passes > 1) run.standardError = values.standardError();
    run.record = recorder.take();
    return run;
}

}  // namespace halfdisk
