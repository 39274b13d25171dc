// Do many measurements all agree with their exact answers within 3.5 standard errors? One value in 2000 lies
// beyond by chance alone, so one that does is measured again.
#pragma once

#include <vector>

#include "support.h"

namespace halfdisk::test {

/// Most of n independent events of probability p that chance brings: more have a probability below 1e-4.
std::size_t mostByChance(std::size_t n, double p);

/// Counts how often the values of a sweep lie beyond kSingle.
class Sweep {
 public:
    /// The values of one measurement that count: measured(false), unless one of them lies beyond kSingle;
    /// then measured(true), which draws other random numbers, four times as many. A bias would stand out the
    /// more.
    template <class Measured>
    std::vector<ZTest> settle(const Measured& measured) {
        const std::vector<ZTest> first = measured(false);
        ++asked_;
        values_ += first.size();
        for (const ZTest& value : first)
            if (!value.within(kSingle)) {
                ++again_;
                return measured(true);
            }
        return first;
    }

    std::size_t again() const { return again_; }
    /// Values of one measurement may all be alike (channels of a grey scene) or independent: allows for both.
    std::size_t mostAgain() const;
    std::string text() const;

 private:
    std::size_t asked_ = 0, values_ = 0, again_ = 0;
};

/// Whether the test tells a value that is five percent larger from the truth.
bool tellsFivePercent(const ZTest& test);

}  // namespace halfdisk::test
