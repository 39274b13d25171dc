// What did one setting give for its budget? Measured against the reference, with what follows for other
// budgets.
#pragma once

#include "core/trade/trade_reference.h"
#include "core/trade/trade_setting.h"

namespace halfdisk {

/// One setting, measured.
struct TradeCell {
    TradeSetting setting;
    std::string name;      ///< see nameOf
    bool complete = true;  ///< it carries every kind of path that the scene has to this sensor
    std::string refusal;   ///< why nothing was measured; empty: it was
    std::uint64_t passes = 0, groups = 0;
    std::uint64_t rays = 0, cut = 0, nonFinite = 0;
    double preparationSeconds = 0.0;
    double seconds = 0.0;  ///< of the passes
    TradeStatistics statistics;
    std::vector<TradeLevel> levels;
    std::optional<Uncertain> exponent;

    bool measured() const { return refusal.empty(); }
    double raysPerPass() const { return static_cast<double>(rays) / static_cast<double>(passes); }
    double secondsPerPass() const { return seconds / static_cast<double>(passes); }
};

/// Asks `problem` (whose index and depth are the setting's) for passes until the budget is spent. Refusals of
/// estimators are part of the answer. Throws Stopped: a cell that was called off is no cell.
TradeCell measureCell(const Problem& problem, const TradeSetting& setting, std::uint32_t askedDepth,
                      const TradeReference& reference, const PassBudget& budget);

}  // namespace halfdisk
