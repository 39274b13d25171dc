#include "app/trade_data.h"

#include <fmt/format.h>

#include <cmath>

#include "app/render_result.h"

namespace halfdisk {
namespace {

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

}  // namespace

Json reportJson(const TradeFolder& trade, const TradeReport& report) {
    Json json;
    json["question"] = trade.question;
    json["reference"] = {{"how", trade.referenceWords},
                         {"light", jsonOf(report.truth.light)},
                         {"relativeError", jsonOf(report.truth.relativeError)},
                         {"exact", report.truth.exact},
                         {"spread", trade.truthSpread}};
    json["missing"] = missingSettings(trade);
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
            item["bySeconds"]["slower"] = verdict.slower;
            item["sameRunAs"] =
                verdict.sameRunAs ? Json(report.cells[*verdict.sameRunAs].name) : Json(nullptr);
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
        "nobodySeconds,secondsError,secondsSlower,sameRunAs,precision\n";
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
            csv += fmt::format("{},{}\n", std::string(28, ','), precision);
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
        csv += verdict.nobody ? ",1" : ",0";
        add(cell.secondsError);
        add(verdict.slower);
        csv += fmt::format(",{},{}\n", verdict.sameRunAs ? quoted(report.cells[*verdict.sameRunAs].name) : "",
                           precision);
    }
    return csv;
}

}  // namespace halfdisk
