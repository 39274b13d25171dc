// What does a trade of speed for accuracy come to? What each setting costs for each error, which of them are
// worth their price, and which nobody should choose.
#pragma once

#include <array>

#include "core/trade/trade_law.h"

namespace halfdisk {

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
    /// The first cell that did the same, ray by ray (see isSameRun): that one is judged for both, by the
    /// better of their times.
    std::optional<std::size_t> sameRunAs;
    /// By which the machine was slower than beside the cell where it was fastest: a fixed piece of work took
    /// so much longer. 1: as fast, or not known.
    double slower = 1.0;
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

struct TradeReport {
    TradeTruth truth;
    double target = 0.05;  ///< relative error
    std::vector<TradeCell> cells;
    std::vector<TradeVerdict> verdicts;               ///< of each cell
    std::array<std::vector<TradeStretch>, 2> fronts;  ///< by TradeCost, from large errors to small
    std::array<std::vector<TradeCrossing>, 2> crossings;

    /// Measured, and not the same run as one before it.
    bool standsForItself(std::size_t cell) const {
        return cells[cell].measured() && !verdicts[cell].sameRunAs;
    }
    bool isOnFront(std::size_t cell, TradeCost cost) const;
};

TradeReport tradeReport(std::vector<TradeCell> cells, const TradeTruth& truth, double target);

/// Cost of the cheapest setting of an estimator (null: of all) at an error; nothing if none reaches it.
struct CheapestCell {
    std::size_t cell = 0;
    double cost = 0.0;
};
/// Of equally cheap ones the one with less bias; of the same runs the first.
std::optional<CheapestCell> cheapest(const TradeReport& report, double error, TradeCost cost,
                                     const EstimatorInfo* estimator = nullptr);

}  // namespace halfdisk
