// What does a trade of speed for accuracy come to? What each setting costs for each error, which of them are
// worth their price, and which nobody should choose.
#include "core/trade/trade_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/render.h"

namespace halfdisk {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

std::size_t at(TradeCost cost) {
    return static_cast<std::size_t>(cost);
}

/// Whether theory gives it no bias at all: nothing is left out, and the scene is the one that is asked for.
bool claimsNone(const TradeCell& cell, const TradeTruth& truth) {
    const TradeSetting& setting = cell.setting;
    return cell.complete && setting.estimator->bias.empty() && setting.maxDepth == truth.askedDepth &&
           setting.facets == 1.0;
}

/// Its law if V and bias^2 are so many standard errors off.
TradeLaw lawOf(const TradeCell& cell, const TradeTruth& truth, bool biased, double standardErrors) {
    const TradeStatistics& measured = cell.statistics;
    const double light2 = truth.light * truth.light;
    TradeLaw law;
    const double spread = standardErrors * measured.variance.error;
    law.variance = std::max(measured.variance.value + spread, 0.05 * measured.variance.value) / light2;
    if (biased || !claimsNone(cell, truth))
        law.bias2 = std::max(0.0, measured.bias2.value + standardErrors * measured.bias2.error) / light2;
    law.preparation[at(TradeCost::seconds)] = cell.preparationSeconds;
    law.perPass[at(TradeCost::rays)] = cell.raysPerPass();
    law.perPass[at(TradeCost::seconds)] = cell.secondsPerPass();
    return law;
}

TradeLaw carefulLaw(const TradeCell& cell, const TradeTruth& truth, bool biased) {
    TradeLaw law = lawOf(cell, truth, biased, 1.0);
    if (biased || !claimsNone(cell, truth))
        law.bias2 = std::max(0.0, bias2High(cell.statistics, cell.groups)) / (truth.light * truth.light);
    return law;
}

bool isBiased(const TradeCell& cell, const TradeTruth& truth) {
    const Uncertain bias2 = cell.statistics.bias2;
    const double own = truth.exact ? truth.relativeError * truth.light : 0.0;
    return bias2.value > kSureBias * bias2.error && bias2.value > own * own;
}

TradeVerdict verdictOf(const TradeCell& cell, const TradeTruth& truth, double target) {
    TradeVerdict verdict;
    const Uncertain bias2 = cell.statistics.bias2;
    const double light = truth.light, passes = static_cast<double>(cell.passes);
    const auto share = [&](double square) { return std::sqrt(std::max(0.0, square)) / light; };
    verdict.foundNothing = !(cell.statistics.mean > 0.0);
    verdict.biased = isBiased(cell, truth);
    verdict.bias = share(bias2.value);
    verdict.biasLow = share(bias2Low(cell.statistics, cell.groups));
    verdict.biasHigh = share(bias2High(cell.statistics, cell.groups));
    verdict.law = lawOf(cell, truth, verdict.biased, 0.0);
    verdict.careful = carefulLaw(cell, truth, verdict.biased);
    verdict.relativeError = std::sqrt(verdict.law.bias2 + verdict.law.variance / passes);
    verdict.rmse = verdict.relativeError * light;
    verdict.mse = verdict.rmse * verdict.rmse;
    verdict.passesToTarget = verdict.law.passesTo(target);
    for (const auto& cost : kTradeCosts) {
        const std::size_t i = at(cost.value);
        const double spent = verdict.law.preparation[i] + passes * verdict.law.perPass[i];
        verdict.efficiency[i] = verdict.mse > 0.0 && spent > 0.0 ? 1.0 / (verdict.mse * spent) : kNever;
        verdict.toTarget[i] = verdict.law.costOf(target, cost.value);
    }
    return verdict;
}

double costOrNever(const TradeLaw& law, double error, TradeCost cost) {
    return law.costOf(error, cost).value_or(kNever);
}

/// By error, the least cost of all; of the laws of cells that were measured.
std::vector<double> envelope(const std::vector<std::optional<TradeLaw>>& laws, TradeCost cost) {
    std::vector<double> least;
    for (const double error : tradeErrors()) {
        least.push_back(kNever);
        for (const auto& law : laws)
            if (law) least.back() = std::min(least.back(), costOrNever(*law, error, cost));
    }
    return least;
}

/// Least factor over all errors that it reaches; nothing: it reaches none.
std::optional<double> leastFactor(const TradeLaw& law, const std::vector<double>& front, TradeCost cost) {
    const std::vector<double> errors = tradeErrors();
    double least = kNever;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const std::optional<double> price = law.costOf(errors[i], cost);
        if (price && front[i] < kNever) least = std::min(least, front[i] > 0.0 ? *price / front[i] : 1.0);
    }
    return least < kNever ? std::optional(least) : std::nullopt;
}

std::vector<TradeStretch> stretchesOf(const TradeReport& report, TradeCost cost) {
    std::vector<TradeStretch> stretches;
    std::vector<double> errors = tradeErrors();
    for (auto error = errors.rbegin(); error != errors.rend(); ++error) {
        const std::optional<CheapestCell> best = cheapest(report, *error, cost);
        if (!best) break;
        if (stretches.empty() || stretches.back().cell != best->cell)
            stretches.push_back({best->cell, *error, *error});
        stretches.back().toError = *error;
    }
    return stretches;
}

/// Where log(a / b) changes its sign between two neighbouring errors.
std::vector<TradeCrossing> crossingsOf(const TradeReport& report, const EstimatorInfo& a,
                                       const EstimatorInfo& b, TradeCost cost) {
    std::vector<TradeCrossing> crossings;
    struct Point {
        double error, a, b;
    };
    std::optional<Point> before;
    const std::vector<double> errors = tradeErrors();
    for (auto error = errors.rbegin(); error != errors.rend(); ++error) {
        const auto ofA = cheapest(report, *error, cost, &a), ofB = cheapest(report, *error, cost, &b);
        if (!ofA && !ofB) break;
        const Point here{*error, ofA ? ofA->cost : kNever, ofB ? ofB->cost : kNever};
        if (here.a == here.b) continue;
        if (before && (before->a < before->b) != (here.a < here.b)) {
            const double from = std::log(before->a / before->b), to = std::log(here.a / here.b);
            // Where one of them ends, it ends between the two.
            const double share = std::isfinite(from) && std::isfinite(to) ? from / (from - to) : 1.0;
            const auto between = [&](double x, double y) { return x * std::pow(y / x, share); };
            const bool aFirst = before->a < before->b;
            const double later = aFirst ? here.b : here.a, earlier = aFirst ? before->b : before->a;
            crossings.push_back({aFirst ? &a : &b, aFirst ? &b : &a, between(before->error, here.error),
                                 std::isfinite(earlier) ? between(earlier, later) : later});
        }
        before = here;
    }
    return crossings;
}

std::vector<const EstimatorInfo*> estimatorsOf(const TradeReport& report) {
    std::vector<const EstimatorInfo*> found;
    for (const TradeCell& cell : report.cells)
        if (cell.measured() && std::find(found.begin(), found.end(), cell.setting.estimator) == found.end())
            found.push_back(cell.setting.estimator);
    return found;
}

void judge(TradeReport& report) {
    std::vector<std::optional<TradeLaw>> laws, dear;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        const bool measured = cell.measured();
        laws.push_back(measured ? std::optional(report.verdicts[i].law) : std::nullopt);
        dear.push_back(measured ? std::optional(lawOf(cell, report.truth, report.verdicts[i].biased, 2.0))
                                : std::nullopt);
    }
    for (const auto& cost : kTradeCosts) {
        const std::size_t k = at(cost.value);
        const std::vector<double> front = envelope(laws, cost.value), sure = envelope(dear, cost.value);
        const std::optional<CheapestCell> atTarget = cheapest(report, report.target, cost.value);
        for (std::size_t i = 0; i < report.cells.size(); ++i) {
            if (!laws[i]) continue;
            TradeVerdict& verdict = report.verdicts[i];
            verdict.off[k] = leastFactor(*laws[i], front, cost.value);
            if (atTarget && verdict.toTarget[k] && atTarget->cost > 0.0)
                verdict.offAtTarget[k] = *verdict.toTarget[k] / atTarget->cost;
            const TradeLaw cheap = lawOf(report.cells[i], report.truth, verdict.biased, -2.0);
            const double margin = cost.value == TradeCost::seconds ? kSureTime : 1.0;
            verdict.dominated[k] = leastFactor(cheap, sure, cost.value).value_or(kNever) > margin;
            verdict.nobody = verdict.dominated[0] && verdict.dominated[1];
        }
    }
}

}  // namespace

std::vector<double> tradeErrors() {
    constexpr int kPerDecade = 20;
    std::vector<double> errors;
    const int steps =
        static_cast<int>(std::lround(kPerDecade * std::log10(kMostTradeError / kLeastTradeError)));
    for (int i = 0; i <= steps; ++i)
        errors.push_back(kLeastTradeError * std::pow(10.0, static_cast<double>(i) / kPerDecade));
    return errors;
}

std::optional<double> TradeLaw::passesTo(double error) const {
    const double left = error * error - bias2;
    if (!(left > 0.0)) return std::nullopt;
    return std::max(1.0, variance / left);
}

std::optional<double> TradeLaw::costOf(double error, TradeCost cost) const {
    const std::optional<double> passes = passesTo(error);
    if (!passes) return std::nullopt;
    return preparation[at(cost)] + *passes * perPass[at(cost)];
}

std::optional<double> TradeLaw::errorFor(double budget, TradeCost cost) const {
    const double left = budget - preparation[at(cost)];
    if (!(left >= perPass[at(cost)])) return std::nullopt;
    const double passes = perPass[at(cost)] > 0.0 ? left / perPass[at(cost)] : 1.0;
    return std::sqrt(bias2 + variance / passes);
}

TradeReport tradeReport(std::vector<TradeCell> cells, const TradeTruth& truth, double target) {
    TradeReport report;
    report.truth = truth;
    report.target = target;
    report.cells = std::move(cells);
    report.verdicts.resize(report.cells.size());
    if (!(truth.light > 0.0)) return report;  // in the dark no error is relative to anything
    for (std::size_t i = 0; i < report.cells.size(); ++i)
        if (report.cells[i].measured()) report.verdicts[i] = verdictOf(report.cells[i], truth, target);
    judge(report);
    const std::vector<const EstimatorInfo*> estimators = estimatorsOf(report);
    for (const auto& cost : kTradeCosts) {
        report.fronts[at(cost.value)] = stretchesOf(report, cost.value);
        std::vector<TradeCrossing>& all = report.crossings[at(cost.value)];
        for (std::size_t a = 0; a < estimators.size(); ++a)
            for (std::size_t b = a + 1; b < estimators.size(); ++b)
                for (const TradeCrossing& crossing :
                     crossingsOf(report, *estimators[a], *estimators[b], cost.value))
                    all.push_back(crossing);
        std::stable_sort(all.begin(), all.end(),
                         [](const TradeCrossing& x, const TradeCrossing& y) { return x.error > y.error; });
    }
    return report;
}

std::optional<CheapestCell> cheapest(const TradeReport& report, double error, TradeCost cost,
                                     const EstimatorInfo* estimator) {
    std::optional<CheapestCell> best;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        if (!cell.measured() || (estimator && cell.setting.estimator != estimator)) continue;
        const std::optional<double> price = report.verdicts[i].law.costOf(error, cost);
        if (price && (!best || *price < best->cost)) best = CheapestCell{i, *price};
    }
    return best;
}

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
            if (!report.cells[i].measured() || report.cells[i].setting.estimator == butNot) continue;
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
        choice.runnerUpFactor = own > 0.0 ? *valueOf(*choice.runnerUp) / own : kNever;
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
        const auto start = std::chrono::steady_clock::now();
        const auto estimator = setting.estimator->make(again, setting.params);
        RenderOptions options;
        options.passes = choice.passes;
        options.threads = threads;
        const Film film = render(*estimator, problem.sensor, options);
        if (film.passes < choice.passes) throw Stopped();
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        groups.means.push_back(chosenPixels(film.pixels.mean, reference.pixels));
        outcome.rays += static_cast<double>(film.counts.rays) / static_cast<double>(runs);
        outcome.seconds += spent.count() / static_cast<double>(runs);
    }
    const Uncertain mse = statisticsOf(groups, reference).mse;
    const double light = reference.light(), root = std::sqrt(std::max(0.0, mse.value));
    outcome.relativeError = {root / light, root > 0.0 ? 0.5 * mse.error / (root * light) : 0.0};
    return outcome;
}

}  // namespace halfdisk
