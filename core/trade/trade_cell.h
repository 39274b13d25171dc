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
    double seconds = 0.0;       ///< of the passes
    double secondsError = 0.0;  ///< its standard error, by how groups of passes differ
    double paceSeconds = 0.0;  ///< paceSeconds() before and after, times GroupedPasses::waiting; 0: not known
    /// What paths that chance has not met yet may bring the light, W/(m rad) or W/m: so rare ones, once in a
    /// third of the passes, are missed one time in twenty. See unseenLight.
    double unseen = 0.0;
    TradeStatistics statistics;
    std::vector<TradeLevel> levels;
    std::optional<Uncertain> exponent;

    bool measured() const { return refusal.empty(); }
    double raysPerPass() const { return static_cast<double>(rays) / static_cast<double>(passes); }
    double secondsPerPass() const { return seconds / static_cast<double>(passes); }
};

/// Whether two settings came to the same light, ray by ray: to the last bit of their noise. One that has a
/// bias may, and did something else.
bool isSameLight(const TradeCell& a, const TradeCell& b);

/// Whether two settings did the same, with the same index, though they are called differently: roulette from
/// the 5th scattering on, and from the 17th, of paths that end at the 2nd. Only their times differ, by
/// chance.
bool isSameRun(const TradeCell& a, const TradeCell& b);

/// Asks `problem` (whose index and depth are the setting's) for passes until the budget is spent. Refusals of
/// estimators are part of the answer. Throws Stopped: a cell that was called off is no cell.
TradeCell measureCell(const Problem& problem, const TradeSetting& setting, std::uint32_t askedDepth,
                      const TradeReference& reference, const PassBudget& budget);

}  // namespace halfdisk
