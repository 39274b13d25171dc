#include "support.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace halfdisk::test {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

// DLMF 8.11.4: gamma(a, x) = x^a e^-x sum of x^k / (a (a+1) ... (a+k)). Converges fast for x < a + 1.
double lowerGammaSeries(double a, double x) {
    double term = 1.0 / a, sum = term;
    for (double k = a + 1.0; term > sum * kEpsilon; k += 1.0) sum += term *= x / k;
    return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// DLMF 8.9.2 by the modified Lentz method. Converges fast for x > a + 1.
double upperGammaFraction(double a, double x) {
    constexpr double kTiny = 1e-300;
    double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, h = d;
    for (int i = 1; i < 100'000; ++i) {
        const double an = -i * (i - a);
        b += 2.0;
        d = an * d + b;
        if (std::abs(d) < kTiny) d = kTiny;
        c = b + an / c;
        if (std::abs(c) < kTiny) c = kTiny;
        d = 1.0 / d;
        h *= d * c;
        if (std::abs(d * c - 1.0) < kEpsilon) break;
    }
    return h * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double normalTail(double z) {
    return std::erfc(std::abs(z) / std::sqrt(2.0));
}

double chiSquareTail(double x, double dof) {
    const double a = dof / 2.0, half = x / 2.0;
    if (half <= 0.0) return 1.0;
    return half < a + 1.0 ? 1.0 - lowerGammaSeries(a, half) : upperGammaFraction(a, half);
}

double chiSquareTest(const std::vector<std::uint64_t>& observed, const std::vector<double>& expected) {
    double statistic = 0.0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double off = static_cast<double>(observed[i]) - expected[i];
        statistic += off * off / expected[i];
    }
    return chiSquareTail(statistic, static_cast<double>(observed.size()) - 1.0);
}

double ZTest::z() const {
    // The sum of many terms rounds as well: a variance of 0 allows for that much and no more.
    constexpr double kRounding = 1e-12;
    const double off = std::abs(mean - exact) - err - kRounding * std::abs(exact);
    if (off <= 0.0) return 0.0;
    if (!(standardError > 0.0)) return std::numeric_limits<double>::infinity();
    return mean < exact ? -off / standardError : off / standardError;
}

std::string ZTest::text() const {
    return fmt::format("mean {:.9g} +- {:.3g}, exact {:.9g}: {:+.2f} standard errors", mean, standardError,
                       exact, z());
}

ZTest zTest(const Statistics& repeats, double exact, double err, int channel) {
    return {repeats.mean[channel], repeats.standardError()[channel], exact, err};
}

}  // namespace halfdisk::test
