// What does a trade of speed for accuracy come to? What each setting costs for each error, which of them are
// worth their price, and which nobody should choose.
#pragma once

#include <array>

#include "core/trade/trade_cell.h"
#include "core/trade/trade_cost.h"

namespace halfdisk {

/// Relative errors (RMSE over the light's mean) at which settings are compared: a factor of 10^(1/20) apart.
inline constexpr double kLeastTradeError = 1e-3, kMostTradeError = 1.0;
std::vector<double> tradeErrors();

/// The law of one setting: RMSE^2 = bias^2 + V / passes. Where an estimator says that it has no bias, and
/// carries every path, one counts only if it is sure (kSureBias standard errors, and more than an exact
/// reference's own error); else what was measured counts.
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
inline constexpr double kSureTime = 1.25;  ///< times vary by so much from run to run

/// What is said of one cell; empty for those that were refused.
struct TradeVerdict {
    TradeLaw law;
    TradeLaw careful;     ///< the same with the upper ends of what is not known: by it settings are chosen
    bool biased = false;  ///< for sure: see TradeLaw
    double bias = 0.0;    ///< relative: sqrt of bias^2 where that is above zero
    double biasLow = 0.0, biasHigh = 0.0;  ///< 95 %
    double relativeError = 0.0;            ///< of all passes of the budget together
    double rmse = 0.0, mse = 0.0;          ///< of them, in the sensor's unit
    std::array<double, 2> efficiency{};    ///< 1 / (MSE cost), MSE in the sensor's unit
    std::optional<double> passesToTarget;
    std::array<std::optional<double>, 2> toTarget;     ///< cost
    std::array<std::optional<double>, 2> offAtTarget;  ///< as a factor of the cheapest there
    /// Least factor over all errors by which it is dearer than the cheapest: 1 is on the front. Nothing: it
    /// reaches none of the errors.
    std::array<std::optional<double>, 2> off;
    bool foundNothing = false;  ///< black, though there is light: too rare for the budget, or never found
    /// Off by more than the confidence intervals for every error: by that cost another one is always better.
    std::array<bool, 2> dominated{};
    bool nobody = false;  ///< dominated in both costs
};

/// Errors between which one setting is the cheapest.
struct TradeStretch {
    std::size_t cell = 0;
    double fromError = 0.0, toError = 0.0;  ///< from > to
};

/// Where the best of two estimators' settings cost the same.
struct TradeCrossing {
    const EstimatorInfo *coarse = nullptr, *fine = nullptr;  ///< cheaper above that error, and below
    double error = 0.0, cost = 0.0;
};

/// What the cells are held against, in numbers.
struct TradeTruth {
    double light = 0.0;          ///< mean of the reference's pixels
    double relativeError = 0.0;  ///< of the reference
    bool exact = false;
    std::uint32_t askedDepth = 0;
};

struct TradeReport {
    TradeTruth truth;
    double target = 0.05;  ///< relative error
    std::vector<TradeCell> cells;
    std::vector<TradeVerdict> verdicts;               ///< of each cell
    std::array<std::vector<TradeStretch>, 2> fronts;  ///< by TradeCost, from large errors to small
    std::array<std::vector<TradeCrossing>, 2> crossings;
};

TradeReport tradeReport(std::vector<TradeCell> cells, const TradeTruth& truth, double target);

/// Cost of the cheapest setting of an estimator (null: of all) at an error; nothing if none reaches it.
struct CheapestCell {
    std::size_t cell = 0;
    double cost = 0.0;
};
std::optional<CheapestCell> cheapest(const TradeReport& report, double error, TradeCost cost,
                                     const EstimatorInfo* estimator = nullptr);

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
