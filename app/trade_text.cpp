// How is a trade told: to people as a table, to machines as CSV and JSON?
#include "app/trade_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/render_result.h"
#include "core/trade/trade_choice.h"

namespace halfdisk {
namespace {

constexpr double kOnFront = 1.0 + 1e-9;

Json optionalJson(const std::optional<double>& value) {
    return value ? jsonOf(*value) : Json(nullptr);
}

Json lawJson(const TradeVerdict& verdict, std::size_t cost) {
    Json json;
    json["efficiency"] = jsonOf(verdict.efficiency[cost]);
    json["toTarget"] = optionalJson(verdict.toTarget[cost]);
    json["offAtTarget"] = optionalJson(verdict.offAtTarget[cost]);
    json["off"] = optionalJson(verdict.off[cost]);
    return json;
}

std::string percent(double share) {
    return fmt::format("{:.3g} %", 100.0 * share);
}

/// With ~ where few groups made the variance: what is rare may come dearer, or cheaper.
std::string amount(const TradeCell& cell, const std::optional<double>& value) {
    if (!value) return "never";
    constexpr double kRough = 0.3;
    const Uncertain variance = cell.statistics.variance;
    return fmt::format("{}{:.3g}", variance.error > kRough * variance.value ? "~" : "", *value);
}

std::string factor(const std::optional<double>& value) {
    if (!value) return "never";
    return *value < kOnFront ? "front" : fmt::format("{:.3g}x", *value);
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
    if (cheaper && cheaper->cell != choice->cell)
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
    const bool rays = verdict.off[0] && *verdict.off[0] < kOnFront,
               seconds = verdict.off[1] && *verdict.off[1] < kOnFront;
    if (rays && seconds) return "on the front";
    if (rays) return "on the front in rays";
    if (seconds) return "on the front in time";
    return verdict.nobody ? "nobody" : "";
}

Json reportJson(const TradeFolder& trade, const TradeReport& report) {
    Json json;
    json["question"] = trade.question;
    json["reference"] = {{"how", trade.referenceWords},
                         {"light", jsonOf(report.truth.light)},
                         {"relativeError", jsonOf(report.truth.relativeError)},
                         {"exact", report.truth.exact}};
    json["target"] = report.target;
    json["cells"] = Json::array();
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        const TradeVerdict& verdict = report.verdicts[i];
        Json item = cellJson(cell);
        if (cell.measured()) {
            item["relativeError"] = jsonOf(verdict.relativeError);
            item["rmse"] = jsonOf(verdict.rmse);
            item["relativeBias"] = {jsonOf(verdict.bias), jsonOf(verdict.biasLow), jsonOf(verdict.biasHigh)};
            item["biased"] = verdict.biased;
            item["foundNothing"] = verdict.foundNothing;
            item["passesToTarget"] = optionalJson(verdict.passesToTarget);
            item["byRays"] = lawJson(verdict, 0);
            item["bySeconds"] = lawJson(verdict, 1);
            item["bySeconds"]["nobody"] = verdict.nobody;
        }
        json["cells"].push_back(item);
    }
    for (const auto& cost : kTradeCosts) {
        const std::size_t k = at(cost.value);
        Json front = Json::array(), crossings = Json::array();
        for (const TradeStretch& stretch : report.fronts[k])
            front.push_back({{"setting", report.cells[stretch.cell].name},
                             {"fromError", stretch.fromError},
                             {"toError", stretch.toError}});
        for (const TradeCrossing& crossing : report.crossings[k])
            crossings.push_back({{"above", std::string(crossing.coarse->id)},
                                 {"below", std::string(crossing.fine->id)},
                                 {"error", jsonOf(crossing.error)},
                                 {"cost", jsonOf(crossing.cost)}});
        json[k == 0 ? "frontByRays" : "frontBySeconds"] = front;
        json[k == 0 ? "crossingsByRays" : "crossingsBySeconds"] = crossings;
    }
    return json;
}

std::string reportCsv(const TradeReport& report) {
    std::string csv =
        "setting,estimator,refusal,passes,rays,relativeError,rmse,mean,variance,varianceError,relativeBias,"
        "biasLow,"
        "biasHigh,biased,exponent,exponentError,passesToTarget,raysToTarget,offRays,offRaysAtTarget,"
        "efficiencyPerRay,"
        "preparationSeconds,seconds,secondsToTarget,offSeconds,offSecondsAtTarget,efficiencyPerSecond,"
        "nobodySeconds,precision\n";
    const auto number = [](const std::optional<double>& value) {
        return value && std::isfinite(*value) ? numberText(*value) : std::string();
    };
    const auto quoted = [](const std::string& text) {
        std::string inside;
        for (const char c : text) inside += c == '"' ? std::string(2, '"') : std::string(1, c);
        return fmt::format("\"{}\"", inside);
    };
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        const TradeVerdict& verdict = report.verdicts[i];
        csv += fmt::format("{},{},{}", quoted(cell.name), cell.setting.estimator->id, quoted(cell.refusal));
        const std::string_view precision = nameOf(kPrecisions, precisionOf(cell.setting.index));
        if (!cell.measured()) {
            csv += fmt::format("{},{}\n", std::string(25, ','), precision);
            continue;
        }
        csv += fmt::format(",{},{}", cell.passes, cell.rays);
        const auto add = [&](const std::optional<double>& value) {
            csv += ',';
            csv += number(value);
        };
        for (const double value :
             {verdict.relativeError, verdict.rmse, cell.statistics.mean, cell.statistics.variance.value,
              cell.statistics.variance.error, verdict.bias, verdict.biasLow, verdict.biasHigh})
            add(value);
        csv += verdict.biased ? ",1" : ",0";
        add(cell.exponent ? std::optional(cell.exponent->value) : std::nullopt);
        add(cell.exponent ? std::optional(cell.exponent->error) : std::nullopt);
        add(verdict.passesToTarget);
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
            if (k == 1) {
                add(cell.preparationSeconds);
                add(cell.seconds);
            }
            add(verdict.toTarget[k]);
            add(verdict.off[k]);
            add(verdict.offAtTarget[k]);
            add(verdict.efficiency[k]);
        }
        csv += fmt::format(",{},{}\n", verdict.nobody ? 1 : 0, precision);
    }
    return csv;
}

std::string reportText(const TradeFolder& trade, const TradeReport& report) {
    std::string text = fmt::format("reference: {}; its error {} of the light, {:.4g}; scattered at most {}\n",
                                   trade.referenceWords, percent(report.truth.relativeError),
                                   report.truth.light, times(report.truth.askedDepth));
    if (!(report.truth.light > 0.0))
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
                            biasWords(verdict), exponentWords(cell), amount(cell, verdict.toTarget[0]),
                            amount(cell, verdict.toTarget[1]), factor(verdict.off[0]), factor(verdict.off[1]),
                            verdictWords(report, i));
    }
    text += choiceText(report);
    for (const auto& cost : kTradeCosts) text += frontText(report, cost);
    for (const auto& cost : kTradeCosts) text += crossingsText(report, cost);
    std::string nobody, refused;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!report.cells[i].measured())
            refused += fmt::format("  {}: {}\n", report.cells[i].name, report.cells[i].refusal);
        else if (report.verdicts[i].nobody)
            nobody += fmt::format("  {}: {} at best in rays, {} in time\n", report.cells[i].name,
                                  factor(report.verdicts[i].off[0]), factor(report.verdicts[i].off[1]));
    }
    if (!nobody.empty())
        text += fmt::format("\nNobody should choose, for any error from {} to {}:\n{}",
                            percent(kMostTradeError), percent(kLeastTradeError), nobody);
    if (!refused.empty()) text += fmt::format("\nNot measured:\n{}", refused);
    return text;
}

}  // namespace halfdisk
