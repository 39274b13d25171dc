// Rows of N: one sample, and so many that a float does not notice the next one.
#include <array>

#include "core/estimate.h"
#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"
#include "core/extremes/sums.h"
#include "core/statistics.h"

namespace halfdisk {
namespace {

constexpr std::uint64_t kPeriod = 1024, kPeriods = 976'563, kSamples = kPeriod * kPeriods;  // 1 000 000 512

/// Samples between 1 and 2, over and over. Floats, so that all sums are given the same ones.
std::array<float, kPeriod> stream() {
    std::array<float, kPeriod> xs{};
    const Rng rng(5, 0);
    for (std::uint32_t i = 0; i < kPeriod; ++i) xs[i] = static_cast<float>(1.0 + rng.uniform(i, 0));
    return xs;
}

struct Moments {
    double mean = 0.0, variance = 0.0;
};

double worse(const Moments& said, const Moments& exact) {
    return std::max(std::abs(said.mean - exact.mean) / exact.mean,
                    std::abs(said.variance - exact.variance) / exact.variance);
}

Moments exactMoments(const std::array<float, kPeriod>& xs) {
    long double sum = 0, squares = 0;
    for (const float x : xs) sum += x;
    const long double mean = sum / kPeriod;
    for (const float x : xs) squares += (x - mean) * (x - mean);
    return {static_cast<double>(mean),
            static_cast<double>(squares * kPeriods / static_cast<long double>(kSamples - 1))};
}

/// All ways to add up, one sample after the other. The plain sum in float is left alone once a whole period
/// has not changed a bit of it: then no later one will, for each period adds the same numbers to the same
/// sum.
struct AllSums {
    NaiveSums<float> naive;
    WelfordSums<float> welford;
    CompensatedSum<float> sum, squares;
    NaiveSums<double> twice;
    std::uint64_t stalledAt = kSamples;  ///< where the plain sum in float stood still
};

AllSums addAll(const std::array<float, kPeriod>& xs, const StopQuestion& stop) {
    AllSums sums;
    for (std::uint64_t period = 0; period < kPeriods; ++period) {
        throwIfStopped(stop, period);
        if (sums.stalledAt == kSamples) {
            const NaiveSums<float> before = sums.naive;
            for (const float x : xs) sums.naive.add(x);
            if (sums.naive == before) sums.stalledAt = period * kPeriod;
        }
        // Together: each waits for its own last result, and meanwhile the others have the processor.
        WelfordSums<float> welford = sums.welford;
        CompensatedSum<float> sum = sums.sum, squares = sums.squares;
        NaiveSums<double> twice = sums.twice;
        for (std::uint64_t i = 0; i < kPeriod; ++i) {
            const float x = xs[i], away = x - 1.5f;
            welford.add(x, static_cast<float>(period * kPeriod + i + 1));
            sum.add(x);
            squares.add(away * away);  // about a guess of the mean: x^2 alone would lose 27 times as much
            twice.add(static_cast<double>(x));
        }
        sums.welford = welford, sums.sum = sum, sums.squares = squares, sums.twice = twice;
    }
    return sums;
}

/// What estimateIrradiance does: chunks of 1024 samples, merged in their order.
Moments productMoments(const std::array<float, kPeriod>& xs) {
    Statistics chunk, all;
    for (const float x : xs) chunk.add(Rgb(static_cast<double>(x)));
    for (std::uint64_t period = 0; period < kPeriods; ++period) all.merge(chunk);
    return {all.mean.x, all.variance().x};
}

std::string errorsOf(const Moments& said, const Moments& exact) {
    return shortText(std::abs(said.mean - exact.mean) / exact.mean) + " and " +
           shortText(std::abs(said.variance - exact.variance) / exact.variance);
}

ExtremeOutcome manySamples(const StopQuestion& stop) {
    const auto xs = stream();
    const Moments exact = exactMoments(xs);
    const AllSums sums = addAll(xs, stop);
    const auto n = static_cast<float>(kSamples);
    const double mean = static_cast<double>(sums.sum.sum) / static_cast<double>(kSamples);
    const Moments compensated{mean,
                              static_cast<double>(sums.squares.sum) / static_cast<double>(kSamples - 1) -
                                  (mean - 1.5) * (mean - 1.5)};
    const Moments naive{static_cast<double>(sums.naive.mean(n)), static_cast<double>(sums.naive.variance(n))};
    const Moments welford{static_cast<double>(sums.welford.average),
                          static_cast<double>(sums.welford.variance(n))};
    const auto all = static_cast<double>(kSamples);
    const Moments ours = productMoments(xs);
    ExtremeOutcome outcome;
    outcome.ours.error = worse(ours, exact);
    outcome.naiveFloat.error = worse(naive, exact);
    outcome.naiveDouble.error = worse({sums.twice.mean(all), sums.twice.variance(all)}, exact);
    outcome.words = "errors of mean and variance in float: naive " + errorsOf(naive, exact) +
                    " (its sums stand still from sample " + shortText(static_cast<double>(sums.stalledAt)) +
                    " on), Welford " + errorsOf(welford, exact) + ", compensated " +
                    errorsOf(compensated, exact) +
                    "; in double: Welford, in chunks that are merged (the product), " + errorsOf(ours, exact);
    return outcome;
}

ExtremeOutcome oneSample(const StopQuestion&) {
    const Scene furnace = furnaceOf(furnacePolygon(), 0.5);
    const SegmentIndex index(furnace);
    Settings settings;
    settings.samples = 1;
    settings.maxDepth = 0;
    settings.emitters = Emitters::hit;
    settings.sampler = Sampler::cosine;
    const Estimate estimate = estimateIrradiance(index, shadedPointOn(index, 0, 0.37), settings);
    ExtremeOutcome outcome;
    outcome.ours.error = std::abs(estimate.irradiance().x - 2.0) / 2.0;
    if (!isFinite(estimate.samples.variance()) || !isFinite(estimate.samples.standardError()))
        outcome.ours.counts.nonFinite = 1;
    const auto naive = [](auto sums) {
        using Real = decltype(sums.sum);
        sums.add(static_cast<Real>(2));
        ExtremeSide side;
        side.error = static_cast<double>(sums.variance(static_cast<Real>(1)));  // 0 / 0
        side.counts.nonFinite = std::isfinite(side.error) ? 0 : 1;
        return side;
    };
    outcome.naiveFloat = naive(NaiveSums<float>{});
    outcome.naiveDouble = naive(NaiveSums<double>{});
    outcome.words = "one sample knows no variance: the formula is 0 / 0, the product tells no standard error";
    return outcome;
}

// Of K merges each rounds the mean by h, and what it adds (delta times a share of both counts) by 3 h of a
// delta that is itself a rounding: K h at most, if all went one way. The squares likewise: each merge adds a
// chunk's with one rounding, K h; of the chunk's own 1024 steps 2 h each.
double samplesBound() {
    return static_cast<double>(kPeriods + 4 * kPeriod) * kRounding;
}

}  // namespace

void addSampleRows(std::vector<ExtremeCell>& cells) {
    cells.push_back({"samples:1", "one sample", "E, relative", 8.0 * std::numeric_limits<double>::epsilon(),
                     "acos, sine, a quotient and a product", oneSample});
    cells.push_back({"samples:1e9", "a thousand million samples", "mean and variance, relative",
                     samplesBound(), "a rounding for each of a million merged chunks, if all went one way",
                     manySamples});
}

}  // namespace halfdisk
