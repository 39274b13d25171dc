#include "core/trade/trade_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/render.h"
#include "core/stopwatch.h"

namespace halfdisk {

std::optional<TradeChoice> choose(const TradeReport& report, const TradeWish& wish) {
    // What is made as small as it can be: cost for an error, or error for a cost.
    const auto valueOf = [&](std::size_t i) {
        const TradeLaw& law = report.verdicts[i].careful;
        if (wish.relativeError) return law.costOf(*wish.relativeError, wish.cost);
        return law.errorFor(wish.budget, wish.cost);
    };
    const auto bestOf = [&](const EstimatorInfo* butNot) {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < report.cells.size(); ++i) {
            if (!report.standsForItself(i) || report.cells[i].setting.estimator == butNot) continue;
            const std::optional<double> value = valueOf(i);
            if (value && (!best || *value < *valueOf(*best))) best = i;
        }
        return best;
    };
    const std::optional<std::size_t> best = bestOf(nullptr);
    if (!best) return std::nullopt;
    const TradeLaw& law = report.verdicts[*best].law;
    TradeChoice choice;
    choice.cell = *best;
    const std::size_t k = at(wish.cost);
    double passes = 1.0;
    if (wish.relativeError) {
        passes = std::ceil(*law.passesTo(*wish.relativeError));
    } else if (law.perPass[k] > 0.0) {
        passes = std::max(1.0, std::floor((wish.budget - law.preparation[k]) / law.perPass[k]));
    }
    constexpr double kMostPasses = 1e15;
    passes = std::min(passes, kMostPasses);
    choice.passes = static_cast<std::uint64_t>(passes);
    choice.rays = passes * law.perPass[at(TradeCost::rays)];
    choice.seconds = law.preparation[at(TradeCost::seconds)] + passes * law.perPass[at(TradeCost::seconds)];
    choice.relativeError = std::sqrt(law.bias2 + law.variance / passes);
    choice.runnerUp = bestOf(report.cells[*best].setting.estimator);
    if (choice.runnerUp) {
        const double own = *valueOf(*best);
        choice.runnerUpFactor =
            own > 0.0 ? *valueOf(*choice.runnerUp) / own : std::numeric_limits<double>::infinity();
    }
    return choice;
}

TradeOutcome checkChoice(const Problem& problem, const TradeReport& report, const TradeChoice& choice,
                         const TradeReference& reference, std::uint64_t runs, unsigned threads) {
    const TradeSetting& setting = report.cells[choice.cell].setting;
    TradeOutcome outcome;
    outcome.runs = runs;
    PassGroups groups;
    groups.each = choice.passes;
    for (std::uint64_t run = 0; run < runs; ++run) {
        Problem again = problem;
        again.seed = problem.seed + 1 + run;
        const Stopwatch watch;
        const auto estimator = setting.estimator->make(again, setting.params);
        RenderOptions options;
        options.passes = choice.passes;
        options.threads = threads;
        const Film film = render(*estimator, problem.sensor, options);
        if (film.passes < choice.passes) throw Stopped();
        const double spent = watch.seconds();
        groups.means.push_back(chosenPixels(film.pixels.mean, reference.pixels));
        outcome.rays += static_cast<double>(film.counts.rays) / static_cast<double>(runs);
        outcome.seconds += spent / static_cast<double>(runs);
    }
    const Uncertain mse = statisticsOf(groups, reference).mse;
    const double light = reference.light(), root = std::sqrt(std::max(0.0, mse.value));
    outcome.relativeError = {root / light, root > 0.0 ? 0.5 * mse.error / (root * light) : 0.0};
    return outcome;
}

}  // namespace halfdisk
