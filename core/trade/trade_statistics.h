// What do groups of passes tell of an estimator? Its noise, and its bias with a confidence interval, against
// a truth that may be uncertain itself.
#pragma once

#include <optional>

#include "core/trade/pass_groups.h"

namespace halfdisk {

/// The truth, as far as it is known.
struct TradeReference {
    std::vector<std::uint32_t> pixels;  ///< those that are known; empty: all
    std::vector<Rgb> mean;              ///< of each of them
    std::vector<Picture> groups;        ///< a long run's own: `mean` is their mean; empty: none
    std::vector<Rgb> standardError;     ///< of a run whose groups are not known; empty: none
    double relativeError = 0.0;         ///< stated: RMS error of `mean` over its light's mean
    std::string how;                    ///< in words
    bool exact() const { return groups.empty() && standardError.empty(); }
    double light() const;  ///< mean over pixels and channels
};

/// A number and its standard error.
struct Uncertain {
    double value = 0.0, error = 0.0;
};

/// Student's t for a two-sided interval of 95 %, within 1 % from 5 degrees of freedom on.
double studentT(double degrees);

/// Squares are means over pixels and channels.
struct TradeStatistics {
    Uncertain variance;  ///< V, of one pass
    Uncertain bias2;     ///< of the picture that infinitely many passes give; may come out below 0
    double noise = 0.0;  ///< what the mean's own noise can hide of bias2: see bias2High
    Uncertain mse;       ///< of one group's mean against the reference, less the reference's own
    double mean = 0.0;   ///< of the estimate
};

/// Ends of a 95 % interval. A square's spread is largest where it is told largest: where noise made the bias
/// look small, its standard error is too small as well. Of a single number b with noise v the upper end of
/// b^2 is (|b| + 1.96 sqrt v)^2, which lies 4 to 5 v above value + t error; of many pixels v is their
/// effective noise, the root of the sum of all squared covariances.
double bias2Low(const TradeStatistics& told, std::uint64_t groups);
double bias2High(const TradeStatistics& told, std::uint64_t groups);

/// Unbiased, whatever pixels share: V from the groups' spread; bias^2 as a U-statistic, the mean over pairs
/// of different groups of the product of their differences from the reference, less the reference's own error
/// in the same way. Standard errors by the jackknife over the groups, and over the reference's. At least 4
/// groups; a reference of the same pixels.
TradeStatistics statisticsOf(const PassGroups& groups, const TradeReference& reference);

/// How the error falls: one point of the convergence curve.
struct TradeLevel {
    double passes = 0.0;
    Uncertain mse{};
    std::uint64_t rays = 0;  ///< of all groups of so many passes
};

/// Exponent p of RMSE ~ passes^p: weighted least squares of log RMSE over log passes, with its standard
/// error. Nothing with fewer than three points that are known to better than their own size. -1/2: noise
/// alone; flatter: a bias shows.
std::optional<Uncertain> exponentOf(const std::vector<TradeLevel>& levels);

}  // namespace halfdisk
