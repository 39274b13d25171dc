// Rows of roughness: a lobe as narrow as they come, and the broadest one.
#include <algorithm>

#include "core/extremes/rows.h"
#include "core/materials/glossy.h"
#include "core/rng.h"

namespace halfdisk {
namespace {

/// Integral of cos^n for a whole even n: pi times (2k - 1) / 2k up to k = n / 2. In long double off by 5e5
/// roundings of 2^-64 for n = 1e6: 3e-14.
long double trueIntegral(std::uint64_t n) {
    long double product = 3.14159265358979323846264338327950288L;
    for (std::uint64_t k = 1; k <= n / 2; ++k)
        product *= (2.0L * static_cast<long double>(k) - 1.0L) / (2.0L * static_cast<long double>(k));
    return product;
}

/// sqrt(pi) Gamma((n + 1) / 2) / Gamma(n / 2 + 1), as it stands in books.
template <class Real>
ExtremeSide naiveIntegral(double exponent, double exact) {
    const auto n = static_cast<Real>(exponent);
    const Real value = std::sqrt(static_cast<Real>(kPi)) * std::tgamma((n + 1) / 2) / std::tgamma(n / 2 + 1);
    ExtremeSide side;
    side.counts.nonFinite = std::isfinite(value) ? 0 : 1;
    side.error = std::abs(static_cast<double>(value) - exact) / exact;
    return side;
}

/// Draws at all slants; those that are not finite or weigh less than nothing count.
std::uint64_t badDraws(const Glossy& wall) {
    const Vec2 N(0.0, 1.0);
    const Rng rng(6, 0);
    std::uint64_t bad = 0;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
        const double angle = i % 4 == 3 ? std::pow(10.0, -10.0 * rng.uniform(i, 0)) : kPi * rng.uniform(i, 0);
        const double u = i % 8 == 1 ? 1.1e-16 : i % 8 == 5 ? 1.0 - 1.2e-16 : rng.uniform(i, 1);
        const auto way = sampleGlossy(wall, N, Vec2(std::cos(angle), std::sin(angle)), u, rng.uniform(i, 2));
        if (!way) continue;
        const bool good = isFinite(way->direction) && isFinite(way->weight) && way->weight.x >= 0.0 &&
                          std::isfinite(way->pdfAngle) && std::abs(glm::length(way->direction) - 1.0) < 1e-12;
        bad += good ? 0 : 1;
    }
    return bad;
}

// lobeIntegral: 24 steps of two roundings each and a series good to 1e-13 (glossy.h).
ExtremeCell cell(double roughness) {
    return {"roughness:" + shortText(roughness),
            "a glossy wall of roughness " + shortText(roughness),
            "lobe's integral, relative",
            2e-13 + 64.0 * kRounding,
            "a series good to 1e-13 and 24 steps of two roundings",
            [roughness](const StopQuestion&) {
                const double exponent = exponentOfRoughness(roughness);
                const double exact = static_cast<double>(trueIntegral(static_cast<std::uint64_t>(exponent)));
                ExtremeOutcome outcome;
                outcome.ours.error = std::abs(lobeIntegral(exponent) - exact) / exact;
                outcome.ours.counts.rays = 20'000;
                outcome.ours.counts.nonFinite = badDraws({Rgb(1.0), exponent});
                outcome.naiveFloat = naiveIntegral<float>(exponent, exact);
                outcome.naiveDouble = naiveIntegral<double>(exponent, exact);
                if (exponent == kMostExponent)
                    outcome.words =
                        "limited to the exponent 1e6, a lobe of 0.001 rad; a true mirror is a Mirror";
                return outcome;
            }};
}

}  // namespace

void addLobeRows(std::vector<ExtremeCell>& cells) {
    for (const double roughness : {0.0, 1.0}) cells.push_back(cell(roughness));
}

}  // namespace halfdisk
