// Which numbers does the window's trade show? A row for each setting.
#include "app/csv_text.h"
#include "app/trade_words.h"

namespace halfdisk {

std::string tradeTable(const AppState& state) {
    CsvText table{"setting",
                  "estimator",
                  "refusal",
                  "passes",
                  "rays",
                  "time (s)",
                  "error (%)",
                  "bias (%)",
                  "biasLow (%)",
                  "biasHigh (%)",
                  "biasIsSure",
                  "raysTo1%",
                  "timeTo1% (s)",
                  "timesTheFrontInRays",
                  "timesTheFrontInTime",
                  "chosen",
                  "predictedRays",
                  "predictedTime (s)",
                  "predictedError (%)",
                  "measuredRays",
                  "measuredTime (s)",
                  "measuredError (%)",
                  "errorOfIt (%)"};
    const TradeSoFar* trade = tradeOf(state);
    if (!trade || !trade->refusal.empty()) return table.text();
    const TradeReport& report = trade->report;
    const std::optional<TradeChoice> choice = choiceOf(state, *trade);
    const TradeCheck* check = choice ? checkOf(*trade, *choice) : nullptr;
    const auto add = [&](const std::optional<double>& value) {
        if (value)
            table.cell(*value);
        else
            table.empty();
    };
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        const TradeVerdict& verdict = report.verdicts[i];
        table.cell(std::string_view(cell.name)).cell(cell.setting.estimator->id);
        table.cell(std::string_view(cell.refusal));
        if (!cell.measured()) {
            table.empty(20).endRow();
            continue;
        }
        table.cell(static_cast<double>(cell.passes)).cell(static_cast<double>(cell.rays));
        table.cell(cell.preparationSeconds + cell.seconds);
        for (const double share : {verdict.relativeError, verdict.bias, verdict.biasLow, verdict.biasHigh})
            table.cell(100.0 * share);
        table.cell(verdict.biased ? 1.0 : 0.0);
        for (const auto& each : {verdict.toTarget, verdict.off})
            for (const std::optional<double>& value : each) add(value);
        const bool chosen = choice && choice->cell == i;
        table.cell(chosen ? 1.0 : 0.0);
        if (chosen)
            table.cell(choice->rays).cell(choice->seconds).cell(100.0 * choice->relativeError);
        else
            table.empty(3);
        if (chosen && check && check->outcome)
            table.cell(check->outcome->rays)
                .cell(check->outcome->seconds)
                .cell(100.0 * check->outcome->relativeError.value)
                .cell(100.0 * check->outcome->relativeError.error);
        else
            table.empty(4);
        table.endRow();
    }
    return table.text();
}

}  // namespace halfdisk
