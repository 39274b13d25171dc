// How is time measured? In CPU time, which other programs on the machine hardly disturb, and in turns.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/trade/pace.h"

namespace halfdisk {

/// CPU time that all threads of the program have used, s.
double processSeconds();

/// The q-quantile (0 ... 1) of `values`, by nearest rank. `values` must not be empty.
double quantile(std::vector<double> values, double q);

/// One of several ways to do the same work: does items first ... first + count - 1 of it.
using Contender = std::function<void(std::size_t first, std::size_t count)>;

struct ContestOptions {
    std::size_t items = 1;     ///< in all; a turn takes some of them, one after the other, over and over
    std::size_t block = 1;     ///< `items` is a multiple of it, and what a turn takes too
    int turns = 11;            ///< of each contender
    double turnSeconds = 0.0;  ///< about, unless a block takes longer
};

/// CPU seconds per item of every contender in every turn.
class Contest {
 public:
    /// The contenders take turns, each beginning every so many rounds; turn k is on the same items for all.
    Contest(const std::vector<Contender>& contenders, const ContestOptions& options);

    double secondsPerItem(std::size_t contender) const { return quantile(seconds_[contender], 0.5); }

    /// How many times as fast as `other` a contender is: the median over pairs of the same turn.
    double speedOver(std::size_t contender, std::size_t other) const;

 private:
    std::vector<std::vector<double>> seconds_;  // [contender][turn]
};

}  // namespace halfdisk
