#include "core/trade/trade_law.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

/// Whether theory gives it no bias at all: nothing is left out, and the scene is the one that is asked for.
bool claimsNone(const TradeCell& cell, const TradeTruth& truth) {
    const TradeSetting& setting = cell.setting;
    return cell.complete && setting.estimator->bias.empty() && setting.maxDepth == truth.askedDepth &&
           setting.facets == 1.0 && precisionOf(setting.index) == Precision::twice;
}

/// Whether the spread of the groups leaves no doubt that their mean is another one.
bool looksBiased(const TradeCell& cell, const TradeTruth& truth) {
    const Uncertain bias2 = cell.statistics.bias2;
    const double own = truth.exact ? truth.relativeError * truth.light : 0.0;
    return bias2.value > kSureBias * bias2.error && bias2.value > own * own;
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

TradeLaw lawOf(const TradeCell& cell, const TradeTruth& truth, bool biased, double standardErrors) {
    const TradeStatistics& measured = cell.statistics;
    const double light2 = truth.light * truth.light;
    TradeLaw law;
    const double spread = standardErrors * measured.variance.error;
    law.variance = std::max(measured.variance.value + spread, 0.05 * measured.variance.value) / light2;
    // What all passes missed is noise: one that had met it would have brought that much more.
    if (mayBeUnseen(cell, truth))
        law.variance =
            std::max(law.variance, static_cast<double>(cell.passes) * measured.bias2.value / light2);
    if (biased || !claimsNone(cell, truth))
        law.bias2 = std::max(0.0, measured.bias2.value + standardErrors * measured.bias2.error) / light2;
    law.preparation[at(TradeCost::seconds)] = cell.preparationSeconds;
    law.perPass[at(TradeCost::rays)] = cell.raysPerPass();
    const double time = cell.secondsPerPass(),
                 timeError = cell.secondsError / static_cast<double>(cell.passes);
    law.perPass[at(TradeCost::seconds)] = std::max(time + standardErrors * timeError, 0.05 * time);
    return law;
}

TradeLaw carefulLaw(const TradeCell& cell, const TradeTruth& truth, bool biased) {
    TradeLaw law = lawOf(cell, truth, biased, 1.0);
    if (biased || !claimsNone(cell, truth)) {
        const double own = truth.exact ? truth.relativeError : 0.0;
        const double bias = std::sqrt(std::max(0.0, bias2High(cell.statistics, cell.groups))) / truth.light;
        law.bias2 = (bias + own) * (bias + own);
    }
    return law;
}

bool mayBeUnseen(const TradeCell& cell, const TradeTruth& truth) {
    return claimsNone(cell, truth) && looksBiased(cell, truth) &&
           cell.statistics.bias2.value <= cell.unseen * cell.unseen;
}

bool isBiased(const TradeCell& cell, const TradeTruth& truth) {
    return looksBiased(cell, truth) && !mayBeUnseen(cell, truth);
}

}  // namespace halfdisk
