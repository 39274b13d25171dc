// What does a trade of speed for accuracy come to? What each setting costs for each error, which of them are
// worth their price, and which nobody should choose.
#include "core/trade/trade_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/trade/trade_front.h"

namespace halfdisk {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// What follows from one cell alone.
void fillVerdict(TradeVerdict& verdict, const TradeCell& cell, const TradeTruth& truth, double target) {
    const Uncertain bias2 = cell.statistics.bias2;
    const double light = truth.light, passes = static_cast<double>(cell.passes);
    const auto share = [&](double square) { return std::sqrt(std::max(0.0, square)) / light; };
    verdict.foundNothing = !(cell.statistics.mean > 0.0);
    verdict.biased = isBiased(cell, truth);
    verdict.bias = share(bias2.value);
    // Where the truth is exact, its own error is not in the spread.
    const double own = truth.exact ? truth.relativeError : 0.0;
    verdict.biasLow =
        mayBeUnseen(cell, truth) ? 0.0 : std::max(0.0, share(bias2Low(cell.statistics, cell.groups)) - own);
    verdict.biasHigh = share(bias2High(cell.statistics, cell.groups)) + own;
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
}

/// What the same run comes to, whatever it is called.
void judgeLike(TradeVerdict& verdict, const TradeVerdict& first) {
    verdict.law = first.law;
    verdict.careful = first.careful;
    verdict.passesToTarget = first.passesToTarget;
    verdict.toTarget = first.toTarget;
    verdict.off = first.off;
    verdict.offAtTarget = first.offAtTarget;
    verdict.dominated = first.dominated;
    verdict.nobody = first.nobody;
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

/// What came to the same light, ray by ray, with a coarser scene or less precision has no more bias than with
/// the scene itself.
void findSameLight(std::vector<TradeCell>& timed) {
    for (TradeCell& cell : timed)
        for (const TradeCell& other : timed) {
            if (!isSameLight(cell, other)) continue;
            // Where two numbers of facets are the same, nothing is round.
            if (cell.setting.facets != other.setting.facets) cell.setting.facets = 1.0;
            if (precisionOf(other.setting.index) == Precision::twice)
                cell.setting.index = other.setting.index;
        }
}

/// Those that did the same are one, and of its times the better ones were less disturbed. Returns the cells
/// with these times.
std::vector<TradeCell> findSameRuns(TradeReport& report) {
    std::vector<TradeCell> timed = report.cells;
    findSameLight(timed);
    for (std::size_t i = 0; i < timed.size(); ++i)
        for (std::size_t first = 0; first < i && !report.verdicts[i].sameRunAs; ++first) {
            if (report.verdicts[first].sameRunAs || !isSameRun(report.cells[first], report.cells[i]))
                continue;
            report.verdicts[i].sameRunAs = first;
            TradeCell& one = timed[first];
            one.preparationSeconds = std::min(one.preparationSeconds, timed[i].preparationSeconds);
            if (timed[i].secondsPerPass() >= one.secondsPerPass()) continue;
            const double passes = static_cast<double>(one.passes) / static_cast<double>(timed[i].passes);
            one.seconds = passes * timed[i].seconds;
            one.secondsError = passes * timed[i].secondsError;
            one.paceSeconds = timed[i].paceSeconds;
        }
    return timed;
}

void findPace(TradeReport& report, const std::vector<TradeCell>& timed) {
    double fastest = kNever;
    for (const TradeCell& cell : timed)
        if (cell.paceSeconds > 0.0) fastest = std::min(fastest, cell.paceSeconds);
    for (std::size_t i = 0; i < timed.size(); ++i)
        if (timed[i].paceSeconds > 0.0) report.verdicts[i].slower = timed[i].paceSeconds / fastest;
}

/// The law at its best: what is not known was against it, and the machine as fast as it ever was.
TradeLaw cheapLaw(const TradeCell& cell, const TradeTruth& truth, const TradeVerdict& verdict) {
    TradeLaw law = lawOf(cell, truth, verdict.biased, -2.0);
    // The system may have run something else meanwhile, on one of the cores, for some of its time slices.
    constexpr double kSlices = 0.05;
    double& perPass = law.perPass[at(TradeCost::seconds)];
    perPass = std::max(perPass - kSlices / static_cast<double>(cell.passes), 0.05 * perPass);
    law.preparation[at(TradeCost::seconds)] /= verdict.slower;
    perPass /= verdict.slower;
    return law;
}

void judge(TradeReport& report, const std::vector<TradeCell>& timed) {
    std::vector<std::optional<TradeLaw>> laws, dear;
    for (std::size_t i = 0; i < timed.size(); ++i) {
        const TradeCell& cell = timed[i];
        const bool measured = cell.measured() && !report.verdicts[i].sameRunAs;
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
            const TradeLaw cheap = cheapLaw(timed[i], report.truth, verdict);
            const double margin = cost.value == TradeCost::seconds ? kSureTime : 1.0;
            verdict.dominated[k] = leastFactor(cheap, sure, cost.value).value_or(kNever) > margin;
            verdict.nobody = verdict.dominated[0] && verdict.dominated[1];
        }
    }
}

}  // namespace

TradeReport tradeReport(std::vector<TradeCell> cells, const TradeTruth& truth, double target) {
    TradeReport report;
    report.truth = truth;
    report.target = target;
    report.cells = std::move(cells);
    report.verdicts.resize(report.cells.size());
    if (truth.isDark()) return report;
    const std::vector<TradeCell> timed = findSameRuns(report);
    findPace(report, timed);
    for (std::size_t i = 0; i < timed.size(); ++i)
        if (timed[i].measured()) fillVerdict(report.verdicts[i], timed[i], truth, target);
    judge(report, timed);
    for (TradeVerdict& verdict : report.verdicts)
        if (verdict.sameRunAs) judgeLike(verdict, report.verdicts[*verdict.sameRunAs]);
    findFronts(report);
    return report;
}

}  // namespace halfdisk
