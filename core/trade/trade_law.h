// What does a setting cost for an error? The law of its noise and its bias.
#pragma once

#include <optional>
#include <vector>

#include "core/trade/trade_cell.h"
#include "core/trade/trade_cost.h"

namespace halfdisk {

constexpr std::size_t at(TradeCost cost) {
    return static_cast<std::size_t>(cost);
}

/// What the cells are held against, in numbers.
struct TradeTruth {
    double light = 0.0;          ///< mean of the reference's pixels
    double relativeError = 0.0;  ///< of the reference
    bool exact = false;
    std::uint32_t askedDepth = 0;

    /// No error is relative to it: none, or so little that its square is no number.
    bool isDark() const { return !(light > 1e-150); }
};

/// Relative errors (RMSE over the light's mean) at which settings are compared: a factor of 10^(1/20) apart.
inline constexpr double kLeastTradeError = 1e-3, kMostTradeError = 1.0;
std::vector<double> tradeErrors();

/// The law of one setting: RMSE^2 = bias^2 + V / passes. Where an estimator says that it has no bias, and
/// carries every path, one counts only if it is sure (kSureBias standard errors, more than an exact
/// reference's own error, and than light that was not found yet); else what was measured counts.
struct TradeLaw {
    double bias2 = 0.0, variance = 0.0;     ///< as shares of the squared light
    double preparation[2]{}, perPass[2]{};  ///< by TradeCost

    /// Passes (one at least, not rounded) until the relative error is `error`; nothing: never.
    std::optional<double> passesTo(double error) const;
    std::optional<double> costOf(double error, TradeCost cost) const;
    /// The relative error for such a cost; nothing if it is too little for one pass.
    std::optional<double> errorFor(double budget, TradeCost cost) const;
};

inline constexpr double kSureBias = 4.0;   ///< standard errors: of a hundred settings none by chance
inline constexpr double kSureTime = 1.25;  ///< times vary by so much from run to run, at the same pace

/// Whether what looks like a bias for sure may be light that chance has not found yet, in few passes of an
/// estimator that leaves none out: where all of them missed it they agree, and their spread tells nothing.
/// It then counts as noise.
bool mayBeUnseen(const TradeCell& cell, const TradeTruth& truth);

/// Whether a bias is sure: see kSureBias, and not mayBeUnseen.
bool isBiased(const TradeCell& cell, const TradeTruth& truth);

/// The law of a measured cell if V, bias^2 and the seconds of a pass are so many standard errors off.
TradeLaw lawOf(const TradeCell& cell, const TradeTruth& truth, bool biased, double standardErrors);

/// The same with the upper ends of what is not known.
TradeLaw carefulLaw(const TradeCell& cell, const TradeTruth& truth, bool biased);

}  // namespace halfdisk
