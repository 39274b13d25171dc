// Which setting for a wish, and was what it promised kept?
#pragma once

#include "core/trade/trade_report.h"

namespace halfdisk {

/// "I want 1 %" for the least cost, or "I have so much" for the least error.
struct TradeWish {
    TradeCost cost = TradeCost::seconds;
    std::optional<double> relativeError;  ///< this, or
    double budget = 0.0;                  ///< so much
};
struct TradeChoice {
    std::size_t cell = 0;
    std::uint64_t passes = 0;
    double rays = 0.0, seconds = 0.0, relativeError = 0.0;  ///< predicted
    std::optional<std::size_t> runnerUp;                    ///< the best of another estimator
    double runnerUpFactor = 1.0;                            ///< by which that one costs more, or errs more
};
/// Ranked by the careful laws, so that a setting is chosen for an error only if its bias is known to be
/// smaller; predicted by the laws themselves. Nothing if no setting can.
std::optional<TradeChoice> choose(const TradeReport& report, const TradeWish& wish);

/// Does what was chosen, with another seed, and tells what then happened. Throws Stopped.
struct TradeOutcome {
    double rays = 0.0, seconds = 0.0;
    Uncertain relativeError;  ///< root mean square over `runs` runs, less the reference's own part
    std::uint64_t runs = 0;
};
TradeOutcome checkChoice(const Problem& problem, const TradeReport& report, const TradeChoice& choice,
                         const TradeReference& reference, std::uint64_t runs, unsigned threads);

}  // namespace halfdisk
