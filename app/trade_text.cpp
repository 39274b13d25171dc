// How is a trade told to people? As a table, and what follows from it.
#include "app/trade_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/trade/trade_choice.h"

namespace halfdisk {
namespace {

std::string percent(double share) {
    return fmt::format("{:.3g} %", 100.0 * share);
}

/// With ~ where few groups made the variance: what is rare may come dearer, or cheaper. And where the time
/// itself is not known better.
std::string amount(const TradeReport& report, std::size_t i, TradeCost cost) {
    const TradeCell& cell = report.cells[i];
    const TradeVerdict& verdict = report.verdicts[i];
    const std::optional<double>& value = verdict.toTarget[at(cost)];
    if (!value) return verdict.biasLow < report.target ? "unknown" : "never";
    constexpr double kRough = 0.3;
    const Uncertain variance = cell.statistics.variance;
    const bool rough = variance.error > kRough * variance.value || mayBeUnseen(cell, report.truth) ||
                       (cost == TradeCost::seconds &&
                        (cell.secondsError > kRough * cell.seconds || verdict.slower > kSureTime));
    return fmt::format("{}{:.3g}", rough ? "~" : "", *value);
}

std::string factor(const TradeReport& report, std::size_t i, TradeCost cost) {
    const std::optional<double>& value = report.verdicts[i].off[at(cost)];
    if (!value) return "never";
    return report.isOnFront(i, cost) ? "front" : fmt::format("{:.3g}x", *value);
}

/// Empty, or that times of some settings are those of a slower machine, or of this one when it was busy.
std::string paceText(const TradeReport& report) {
    std::string names;
    double most = 1.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!(report.verdicts[i].slower > kSureTime)) continue;
        most = std::max(most, report.verdicts[i].slower);
        constexpr std::size_t kNamed = 4;
        if (++count <= kNamed) names += fmt::format("{}{}", count > 1 ? ", " : "", report.cells[i].name);
        if (count == kNamed + 1) names += ", ...";
    }
    if (count == 0) return {};
    return fmt::format(
        "\nTimes (~): the machine was up to {:.2g} times slower than at its best beside {} of {} settings "
        "({}): it was busy, or it is another one. What such times cannot tell is left open\n",
        most, count, report.cells.size(), names);
}

std::string biasWords(const TradeVerdict& verdict) {
    return fmt::format("{:.2g} [{:.2g}, {:.2g}]{}", 100.0 * verdict.bias, 100.0 * verdict.biasLow,
                       100.0 * verdict.biasHigh, verdict.biased ? "*" : "");
}

std::string exponentWords(const TradeCell& cell) {
    if (!cell.exponent) return "-";
    return fmt::format("{:.2f}({:.2f})", cell.exponent->value, cell.exponent->error);
}

std::string costWords(double value, TradeCost cost) {
    return cost == TradeCost::rays ? fmt::format("{:.3g} rays", value) : fmt::format("{:.3g} s", value);
}

/// The cells in the order in which they reach the target, refused ones last.
std::vector<std::size_t> orderOf(const TradeReport& report) {
    std::vector<std::size_t> order(report.cells.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto rank = [&](std::size_t i) {
        if (!report.cells[i].measured()) return 2e300;
        return report.verdicts[i].toTarget[0].value_or(1e300);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    return order;
}

std::string frontText(const TradeReport& report, const Named<TradeCost>& cost) {
    const auto& stretches = report.fronts[at(cost.value)];
    if (stretches.empty()) return {};
    std::string text = fmt::format("\nThe front, by {}: the cheapest for an error of\n", cost.name);
    for (const TradeStretch& stretch : stretches) {
        const auto price = [&](double error) {
            return costWords(*report.verdicts[stretch.cell].law.costOf(error, cost.value), cost.value);
        };
        text += fmt::format("  {:>7} ... {:<7}  {}  ({} ... {})\n", percent(stretch.fromError),
                            percent(stretch.toError), report.cells[stretch.cell].name,
                            price(stretch.fromError), price(stretch.toError));
    }
    return text;
}

std::string crossingsText(const TradeReport& report, const Named<TradeCost>& cost) {
    const auto& crossings = report.crossings[at(cost.value)];
    if (crossings.empty()) return {};
    std::string text = fmt::format("\nWhere the best of two estimators cross, by {}:\n", cost.name);
    for (const TradeCrossing& crossing : crossings)
        text += fmt::format("  at {:>7} and {:<14} {} is cheaper above, {} below\n", percent(crossing.error),
                            costWords(crossing.cost, cost.value), crossing.coarse->id, crossing.fine->id);
    return text;
}

/// What to choose for the target.
std::string times(std::uint32_t count) {
    return fmt::format("{} time{}", count, count == 1 ? "" : "s");
}

std::string choiceText(const TradeReport& report) {
    const auto choice = choose(report, {TradeCost::rays, report.target});
    const std::string wish = percent(report.target);
    if (!choice) return fmt::format("\nFor {}: no setting is known to reach it\n", wish);
    std::string text = fmt::format("\nFor {}: {}, {} pass{}, about {:.3g} rays and {:.3g} s", wish,
                                   report.cells[choice->cell].name, choice->passes,
                                   choice->passes == 1 ? "" : "es", choice->rays, choice->seconds);
    if (choice->runnerUp)
        text += fmt::format("; the best of another estimator, {}, takes {:.3g} times the rays",
                            report.cells[*choice->runnerUp].name, choice->runnerUpFactor);
    const auto cheaper = cheapest(report, report.target, TradeCost::rays);
    const bool trusted =
        cheaper && report.verdicts[cheaper->cell].careful.costOf(report.target, TradeCost::rays).has_value();
    if (cheaper && cheaper->cell != choice->cell && !trusted)
        text += fmt::format(
            "\n  ({} would take {:.3g} rays, but is not trusted: with what is not known yet, its "
            "bias may be {})",
            report.cells[cheaper->cell].name, cheaper->cost,
            percent(report.verdicts[cheaper->cell].biasHigh));
    return text + '\n';
}

}  // namespace

TradeReport reportOf(const TradeFolder& trade) {
    std::vector<TradeCell> cells;
    for (const auto& numbered : trade.cells) cells.push_back(numbered.second);
    return tradeReport(std::move(cells), trade.truth, trade.target);
}

std::string verdictWords(const TradeReport& report, std::size_t cell) {
    if (!report.cells[cell].measured()) return "refused";
    const TradeVerdict& verdict = report.verdicts[cell];
    if (verdict.foundNothing) return "found no light";
    if (verdict.sameRunAs) return "the same run as " + report.cells[*verdict.sameRunAs].name;
    const TradeSetting& setting = report.cells[cell].setting;
    const bool endless = setting.estimator->endless && setting.estimator->endless(setting.params);
    const bool rays = report.isOnFront(cell, TradeCost::rays),
               seconds = report.isOnFront(cell, TradeCost::seconds);
    std::string words = rays && seconds  ? "on the front"
                        : rays           ? "on the front in rays"
                        : seconds        ? "on the front in time"
                        : verdict.nobody ? "nobody"
                                         : "";
    if (endless)
        words += fmt::format("{}has all bounces, not {}", words.empty() ? "" : "; ", report.truth.askedDepth);
    return words;
}

std::string reportText(const TradeFolder& trade, const TradeReport& report) {
    std::string text = fmt::format("reference: {}; its error {} of the light, {:.4g}; scattered at most {}\n",
                                   trade.referenceWords, percent(report.truth.relativeError),
                                   report.truth.light, times(report.truth.askedDepth));
    if (trade.truthSpread > 0.0)
        text += fmt::format("the parts had references of their own, which differ by {} at most\n",
                            percent(trade.truthSpread));
    if (report.truth.isDark())
        return text + "no light reaches the sensor: no error is relative to anything\n";
    std::size_t width = 20;
    for (const TradeCell& cell : report.cells) width = std::max(width, cell.name.size());
    const std::string target = percent(report.target);
    text +=
        fmt::format("\n{:<{}} {:>9} {:>8} {:>8} {:>20} {:>11} {:>9} {:>8} {:>7} {:>7}  {}\n", "", width, "",
                    "", "error", "bias, % [95 %]", "falls as", "rays to", "s to", "off in", "off in", "");
    text +=
        fmt::format("{:<{}} {:>9} {:>8} {:>8} {:>20} {:>11} {:>9} {:>8} {:>7} {:>7}  {}\n", "setting", width,
                    "rays", "s", "%", "* = sure", "passes^", target, target, "rays", "time", "verdict");
    for (const std::size_t i : orderOf(report)) {
        const TradeCell& cell = report.cells[i];
        const TradeVerdict& verdict = report.verdicts[i];
        if (!cell.measured()) continue;
        text += fmt::format("{:<{}} {:>9.3g} {:>8.3g} {:>8.3g} {:>20} {:>11} {:>9} {:>8} {:>7} {:>7}  {}\n",
                            cell.name, width, static_cast<double>(cell.rays),
                            cell.preparationSeconds + cell.seconds, 100.0 * verdict.relativeError,
                            biasWords(verdict), exponentWords(cell), amount(report, i, TradeCost::rays),
                            amount(report, i, TradeCost::seconds), factor(report, i, TradeCost::rays),
                            factor(report, i, TradeCost::seconds), verdictWords(report, i));
    }
    text += paceText(report);
    text += choiceText(report);
    for (const auto& cost : kTradeCosts) text += frontText(report, cost);
    for (const auto& cost : kTradeCosts) text += crossingsText(report, cost);
    std::string nobody, refused;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!report.cells[i].measured())
            refused += fmt::format("  {}: {}\n", report.cells[i].name, report.cells[i].refusal);
        else if (report.verdicts[i].nobody && report.standsForItself(i))
            nobody += fmt::format("  {}: {} at best in rays, {} in time\n", report.cells[i].name,
                                  factor(report, i, TradeCost::rays), factor(report, i, TradeCost::seconds));
    }
    if (!nobody.empty())
        text += fmt::format("\nNobody should choose, for any error from {} to {}:\n{}",
                            percent(kMostTradeError), percent(kLeastTradeError), nobody);
    if (!refused.empty()) text += fmt::format("\nNot measured:\n{}", refused);
    return text;
}

std::string missingText(const TradeFolder& trade) {
    const std::vector<std::string> missing = missingSettings(trade);
    if (missing.empty()) return {};
    return fmt::format("\nMissing, {} of {} settings: {}\n", missing.size(),
                       missing.size() + trade.cells.size(), fmt::join(missing, ", "));
}

}  // namespace halfdisk
