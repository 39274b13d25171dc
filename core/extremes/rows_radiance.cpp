// Rows of radiance: light so faint or so bright that its square is no longer a float.
#include <algorithm>

#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"
#include "core/extremes/sums.h"
#include "core/statistics.h"

namespace halfdisk {
namespace {

constexpr std::uint64_t kFlips = 1000;

/// Relative error of the variance of samples that are 0 and L in turns: L^2 / 4 n / (n - 1).
double varianceError(double said, double radiance) {
    const double ratio = said / radiance / radiance;  // L^2 itself may be no number
    const double exact = 0.25 * static_cast<double>(kFlips) / static_cast<double>(kFlips - 1);
    return std::abs(ratio - exact) / exact;
}

double productVariance(double radiance) {
    Statistics statistics;
    for (std::uint64_t i = 0; i < kFlips; ++i) statistics.add(Rgb(i % 2 == 0 ? 0.0 : radiance));
    return statistics.variance().x;
}

template <class Real>
ExtremeSide naiveSide(double radiance) {
    NaiveSums<Real> sums;
    for (std::uint64_t i = 0; i < kFlips; ++i) sums.add(i % 2 == 0 ? Real(0) : static_cast<Real>(radiance));
    const auto variance = static_cast<double>(sums.variance(static_cast<Real>(kFlips)));
    ExtremeSide side;
    side.counts.nonFinite = std::isfinite(variance) ? 0 : 1;
    side.error = varianceError(variance, radiance);
    return side;
}

// The furnace's own bound for E. Of the variance: Welford's n steps, each with a few roundings of the sum so
// far.
ExtremeCell cell(double radiance) {
    return {"radiance:" + powerText(radiance),
            "radiance of " + powerText(radiance) + " W/(m rad)",
            "E and variance, relative",
            4.0 * kFlips * kRounding,
            "4 roundings for each of 1000 samples; no square leaves the range of double",
            [radiance](const StopQuestion& stop) {
                FurnaceQuestion question;
                question.emission = radiance;
                const Scene furnace = furnaceOf(furnacePolygon(), question.albedo, radiance);
                ExtremeOutcome outcome;
                outcome.ours.error = std::max(furnaceError(furnace, question, stop),
                                              varianceError(productVariance(radiance), radiance));
                outcome.naiveFloat = naiveSide<float>(radiance);
                outcome.naiveDouble = naiveSide<double>(radiance);
                return outcome;
            }};
}

}  // namespace

void addRadianceRows(std::vector<ExtremeCell>& cells) {
    for (const double radiance : {1e-30, 1e-15, 1e15, 1e30}) cells.push_back(cell(radiance));
}

}  // namespace halfdisk
