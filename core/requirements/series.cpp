#include "core/requirements/series.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/requirements/words.h"

namespace halfdisk {

Difference differenceOf(const Pilot& all, const Pilot& upTo) {
    double mean = 0.0, squares = 0.0;
    const double n = static_cast<double>(all.totals.size());
    for (std::size_t k = 0; k < all.totals.size(); ++k) mean += (all.totals[k] - upTo.totals[k]) / n;
    for (std::size_t k = 0; k < all.totals.size(); ++k) {
        const double off = all.totals[k] - upTo.totals[k] - mean;
        squares += off * off;
    }
    return {mean, std::sqrt(squares / (n - 1.0) / n)};
}

namespace {

/// Differences of runs need less than a picture: fewer photons, more passes.
ParamValues shortParams(const Way& way, const SegmentIndex& index) {
    constexpr double kPhotons = 10000.0;
    const EstimatorInfo& info = *findEstimator(way.estimator);
    ParamValues params = paramsOf(way, index, 4);
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (info.params[i].name == "photons") params[i] = kPhotons;
    return params;
}

/// All ways that find all light, each as deep as it can be followed; photons only where nothing else does.
std::vector<Series> allSeries(const RequirementsQuestion& question) {
    struct Depth {
        std::string_view estimator;
        bool mis;
        std::uint32_t deepest;
    };
    constexpr std::array kDepths{Depth{"path", true, 48}, Depth{"light", false, 48},
                                 Depth{"bidirectional", true, 15}, Depth{"photon-map", true, 24}};
    std::vector<Series> all;
    for (const auto& [id, mis, deepest] : kDepths)
        for (const Way& way : allWays())
            if (way.estimator == id && way.mis == mis && (way.unbiased || all.empty()) &&
                isComplete(way, question.index, question.sensor, deepest))
                all.push_back(
                    {{findEstimator(id), shortParams(way, question.index), deepest,
                      static_cast<std::uint32_t>(kMaxSpecularInfo.initial), IndexMethod::automatic, way},
                     deepest});
    return all;
}

}  // namespace

std::optional<Series> seriesOf(const RequirementsQuestion& question, const SceneTraits& traits,
                               std::uint64_t& rays) {
    std::vector<Series> all = allSeries(question);
    if (all.empty()) return std::nullopt;
    if (!traits.specular || !traits.area) all.resize(1);
    std::vector<Pilot> runs;
    double surely = 0.0;
    for (const Series& series : all) {
        const bool joins = series.plan.way.estimator == "bidirectional";
        if (joins && std::any_of(runs.begin(), runs.end(), tooLongToJoin)) break;
        runs.push_back(deepestRun(question, series, rays));
        surely = std::max(surely, surelyBrought(runs.back()));
    }
    std::size_t best = 0;
    constexpr double kClearly = 0.5;  // the others are less deep, or dearer
    for (std::size_t k = 0; k < runs.size(); ++k)
        if (!lacksLight(runs[k], surely) &&
            (lacksLight(runs[best], surely) || lightError(runs[k]) < kClearly * lightError(runs[best])))
            best = k;
    constexpr double kMost = 8.0;
    const double ratio = lightError(runs[best]) / question.tolerance;
    all[best].rays *= std::clamp(ratio * ratio, 1.0, kMost);
    return all[best];
}

Pilot deepestRun(const RequirementsQuestion& question, const Series& series, std::uint64_t& rays) {
    const Problem problem{
        .index = question.index, .sensor = question.sensor, .seed = question.seed, .stop = question.stop};
    Pilot run = pilot(problem, series.plan,
                      {.rays = static_cast<std::uint64_t>(question.effort * series.rays), .leastPasses = 16});
    rays += run.rays;
    return run;
}

Tail tailOf(const Pilot& all, const Pilot& twoThirds, const Pilot& third, double mostRatio) {
    const Difference last = differenceOf(all, twoThirds), before = differenceOf(twoThirds, third);
    constexpr double kEndless = 0.999;
    const double bound = std::min(mostRatio, kEndless);
    const auto tail = [&](double light, double lightBefore) {
        if (!(light > 0.0)) return 0.0;
        const double ratio = lightBefore > 0.0 ? std::min(light / lightBefore, bound) : bound;
        return light * ratio / (1.0 - ratio);
    };
    const double likely = tail(last.mean, before.mean);
    const double most =
        tail(last.mean + kSureErrors * last.standardError, before.mean - kSureErrors * before.standardError);
    return {likely, (most - likely) / kSureErrors};
}

BeyondDepth shareBeyond(std::uint32_t events, const Pilot& all, const Pilot& upTo, const Tail& tail) {
    const double light = all.mean + tail.light;
    if (!(light > 0.0)) return {events, 0.0, 0.0};
    const Difference missing = differenceOf(all, upTo);
    return {events, std::max(0.0, missing.mean + tail.light) / light,
            (missing.standardError + tail.standardError) / light};
}

std::string shareWords(const BeyondDepth& beyond, double tolerance) {
    std::string text = words::percent(beyond.share);
    // An error is told that is more than this of the share, or of what may be missing.
    constexpr double kOfShare = 0.01, kOfTolerance = 1e-3;
    if (beyond.standardError <= std::max(kOfShare * beyond.share, kOfTolerance * tolerance))
        return text + " of the light";
    text += words::joined(" (± ", words::percent(beyond.standardError), ") of the light");
    if (isEnough(beyond, tolerance))
        text += words::joined(", with two standard errors added ", words::percent(mayMiss(beyond)));
    return text;
}

std::string_view lackWords(const BeyondDepth& beyond, double tolerance) {
    return beyond.share > tolerance ? "some light is missing" : "some light may be missing";
}

}  // namespace halfdisk
