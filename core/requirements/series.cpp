#include "core/requirements/series.h"

#include <algorithm>
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

}  // namespace

std::optional<Series> seriesOf(const RequirementsQuestion& question, std::uint32_t maxSpecular) {
    const auto with = [&](std::string_view id, bool mis, std::uint32_t deepest) -> std::optional<Series> {
        for (const Way& way : allWays())
            if (way.estimator == id && way.mis == mis &&
                isComplete(way, question.index, question.sensor, deepest))
                return Series{{findEstimator(id), shortParams(way, question.index), deepest, maxSpecular,
                               IndexMethod::automatic, way},
                              deepest};
        return std::nullopt;
    };
    if (auto path = with("path", true, 48)) return path;
    if (auto light = with("light", false, 48)) return light;
    if (auto joined = with("bidirectional", true, 15)) return joined;
    return with("photon-map", true, 24);
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
    constexpr double kTold = 0.01;  // of the share
    if (beyond.standardError <= kTold * beyond.share) return text + " of the light";
    text += words::joined(" (± ", words::percent(beyond.standardError), ") of the light");
    if (isEnough(beyond, tolerance))
        text += words::joined(", with two standard errors added ", words::percent(mayMiss(beyond)));
    return text;
}

std::string_view lackWords(const BeyondDepth& beyond, double tolerance) {
    return beyond.share > tolerance ? "some light is missing" : "some light may be missing";
}

}  // namespace halfdisk
