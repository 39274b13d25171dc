// How is a trade drawn? The front of all settings, and how their errors fall; for files and for the window.
#pragma once

#include <optional>

#include "app/plot.h"
#include "core/trade/trade_choice.h"

namespace halfdisk {

/// Of an estimator, the same in all plots.
ImU32 tradeColor(const Palette& palette, const EstimatorInfo& info);

/// What the window marks.
struct TradeMarks {
    std::optional<std::size_t> onStage;     ///< makes the pictures: a frame round it
    std::optional<TradeWish> wish{};        ///< a line
    std::optional<TradeChoice> choice{};    ///< its setting in bold, and a cross where it is to arrive
    std::optional<TradeOutcome> outcome{};  ///< where it arrived, with its standard error
};

/// Error over cost, both logarithmic: a line for each setting, a dot where it stands after its budget (a ring
/// where by that cost another one is always better), and the front as a broad line below all of them.
Plot drawTradeFront(const Ui& ui, const TradeReport& report, TradeCost cost, ImVec2 size,
                    const TradeMarks& marks = {});

/// Where a cell's dot is, pixels; perhaps beside the plot.
ImVec2 tradeDot(const Plot& plot, const TradeReport& report, std::size_t cell, TradeCost cost);

/// The cell whose dot is nearest to a place on the screen, within `reach` pixels.
std::optional<std::size_t> tradeCellAt(const Plot& plot, const TradeReport& report, TradeCost cost,
                                       ImVec2 place, float reach);

/// The cells that drawConvergence shows: of each estimator the one that is the cheapest at the target, or
/// else erred least.
std::vector<std::size_t> bestCells(const TradeReport& report);

/// RMSE over rays as measured, group size by group size, with standard errors, and the fitted power of each
/// estimator's best setting.
Plot drawConvergence(const Ui& ui, const TradeReport& report, ImVec2 size);

}  // namespace halfdisk
