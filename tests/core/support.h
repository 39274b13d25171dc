// When do numbers agree? Test statistics with their tail probabilities, and random numbers that are not the
// program's own.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/statistics.h"

namespace halfdisk::test {

/// Threshold of a single z-test: a right program fails it with probability 4.7e-4 (two-sided).
inline constexpr double kSingle = 3.5;
/// Threshold in a sweep of up to about 1000 comparisons: 6.8e-6 each, so below 1 % for the whole sweep
/// (Bonferroni).
inline constexpr double kSweep = 4.5;

/// P(X > x) for a standard normal X, two-sided: P(|X| > |z|).
double normalTail(double z);

/// P(X > x) for a chi-square X with `dof` degrees of freedom: the regularised upper incomplete gamma Q(dof/2,
/// x/2).
double chiSquareTail(double x, double dof);

/// Pearson's statistic of observed counts against expected ones, as a tail probability with (cells - 1)
/// degrees.
double chiSquareTest(const std::vector<std::uint64_t>& observed, const std::vector<double>& expected);

/// How far a measured mean lies from the truth, in standard errors. `err` (absolute) is what the truth itself
/// may be off by.
struct ZTest {
    double mean, standardError, exact, err;
    double z() const;  ///< infinite where an error remains and nothing can excuse it
    bool within(double threshold) const { return std::abs(z()) <= threshold; }
    std::string text() const;
};

/// One colour channel of a mean over independent repeats.
ZTest zTest(const Statistics& repeats, double exact, double err = 0.0, int channel = 0);

/// Uniform numbers from the C++ library, independent of the program's own generator.
class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// In the open interval (from, to).
    double in(double from, double to) {
        return from + (to - from) * ((static_cast<double>(engine_() >> 12) + 0.5) * 0x1p-52);
    }
    std::int64_t integer(std::int64_t from, std::int64_t to) {
        return from + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(to - from + 1));
    }
    Vec2 pointIn(double from, double to) {
        const double x = in(from, to);
        return {x, in(from, to)};
    }
    Vec2 direction() {
        const double angle = in(0.0, 2.0 * kPi);
        return {std::cos(angle), std::sin(angle)};
    }

 private:
    std::mt19937_64 engine_;
};

}  // namespace halfdisk::test
