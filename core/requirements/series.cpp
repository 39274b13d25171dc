#include "core/requirements/series.h"

#include <algorithm>

#include "core/requirements/words.h"

namespace halfdisk {

std::optional<Series> seriesOf(const RequirementsQuestion& question, std::uint32_t maxSpecular) {
    const auto with = [&](std::string_view id, bool mis, std::uint32_t deepest) -> std::optional<Series> {
        for (const Way& way : allWays())
            if (way.estimator == id && way.mis == mis &&
                isComplete(way, question.index, question.sensor, deepest))
                return Series{{findEstimator(id), paramsOf(way, question.index, 4), deepest, maxSpecular,
                               IndexMethod::automatic, way},
                              deepest};
        return std::nullopt;
    };
    if (auto path = with("path", true, 48)) return path;
    if (auto light = with("light", false, 32)) return light;
    if (auto joined = with("bidirectional", true, 10)) return joined;
    return with("photon-map", true, 8);
}

BeyondDepth shareBeyond(std::uint32_t events, const Pilot& all, const Pilot& upTo) {
    double mean = 0.0, squares = 0.0;
    const double n = static_cast<double>(all.totals.size());
    for (std::size_t k = 0; k < all.totals.size(); ++k) mean += (all.totals[k] - upTo.totals[k]) / n;
    for (std::size_t k = 0; k < all.totals.size(); ++k) {
        const double off = all.totals[k] - upTo.totals[k] - mean;
        squares += off * off;
    }
    if (!(all.mean > 0.0)) return {events, 0.0, 0.0};
    return {events, std::max(0.0, mean / all.mean), std::sqrt(squares / (n - 1.0) / n) / all.mean};
}

std::string shareWords(const BeyondDepth& beyond, double tolerance) {
    std::string text = words::percent(beyond.share);
    if (!(beyond.standardError > 0.0)) return text + " of the light";
    text += words::joined(" (± ", words::percent(beyond.standardError), ") of the light");
    if (isEnough(beyond, tolerance))
        text += words::joined(", with two standard errors added ", words::percent(mayMiss(beyond)));
    return text;
}

}  // namespace halfdisk
