#include "core/trade/trade_front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfdisk {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

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

}  // namespace

void findFronts(TradeReport& report) {
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
}

bool TradeReport::isOnFront(std::size_t cell, TradeCost cost) const {
    const std::vector<TradeStretch>& front = fronts[at(cost)];
    return std::any_of(front.begin(), front.end(),
                       [cell](const TradeStretch& stretch) { return stretch.cell == cell; });
}

std::optional<CheapestCell> cheapest(const TradeReport& report, double error, TradeCost cost,
                                     const EstimatorInfo* estimator) {
    std::optional<CheapestCell> best;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        if (!report.standsForItself(i) || (estimator && cell.setting.estimator != estimator)) continue;
        const std::optional<double> price = report.verdicts[i].law.costOf(error, cost);
        if (!price) continue;
        const auto bias2 = [&](std::size_t of) { return report.verdicts[of].law.bias2; };
        if (!best || *price < best->cost || (*price == best->cost && bias2(i) < bias2(best->cell)))
            best = CheapestCell{i, *price};
    }
    return best;
}

}  // namespace halfdisk
