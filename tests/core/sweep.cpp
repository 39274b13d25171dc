#include "sweep.h"

#include <fmt/format.h>

#include <cmath>

namespace halfdisk::test {
namespace {

constexpr double kFalseAlarm = 1e-4;

}  // namespace

std::size_t mostByChance(std::size_t n, double p) {
    // P(X > k) is what is left of 1 after the terms 0 ... k; each follows from the one before.
    const auto of = static_cast<double>(n);
    double term = std::exp(of * std::log1p(-p)), left = 1.0 - term;
    std::size_t k = 0;
    for (; left > kFalseAlarm && k < n; ++k) {
        const auto before = static_cast<double>(k);
        term *= (of - before) / (before + 1.0) * p / (1.0 - p);
        left -= term;
    }
    return k;
}

std::size_t Sweep::mostAgain() const {
    if (asked_ == 0) return 0;
    const double each = static_cast<double>(values_) / static_cast<double>(asked_);
    return mostByChance(asked_, each * normalTail(kSingle));
}

std::string Sweep::text() const {
    return fmt::format("{} of {} measurements ({} values) asked again; chance allows {}", again_, asked_,
                       values_, mostAgain());
}

bool tellsFivePercent(const ZTest& test) {
    return !ZTest{1.05 * test.mean, 1.05 * test.standardError, test.exact, test.err}.within(kSingle);
}

}  // namespace halfdisk::test
