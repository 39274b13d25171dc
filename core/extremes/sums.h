// How are many samples added up? The ways that there are, side by side, in any number type.
#pragma once

#include <cmath>
#include <cstdint>

namespace halfdisk {

template <class Real>
struct NaiveSums {
    Real sum = 0, squares = 0;
    void add(Real x) {
        sum += x;
        squares += x * x;
    }
    Real mean(Real n) const { return sum / n; }
    /// As every table of formulas has it: the difference of two large numbers.
    Real variance(Real n) const { return (squares - sum * sum / n) / (n - 1); }
    bool operator==(const NaiveSums&) const = default;
};

/// Welford (1962): the product's, in any type.
template <class Real>
struct WelfordSums {
    Real average = 0, squares = 0;
    void add(Real x, Real n) {
        const Real delta = x - average;
        average += delta / n;
        squares += delta * (x - average);
    }
    Real variance(Real n) const { return squares / (n - 1); }
    bool operator==(const WelfordSums&) const = default;
};

/// Kahan (1965): what a sum lost is kept, and added to the next term.
template <class Real>
struct CompensatedSum {
    Real sum = 0, lost = 0;
    void add(Real x) {
        const Real y = x - lost, t = sum + y;
        lost = (t - sum) - y;
        sum = t;
    }
};

}  // namespace halfdisk
