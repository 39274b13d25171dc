// Do single samples vary as much as theory says? Case 33: the exact variances of four estimators.
//
// The variance of each of 200 batches is an unbiased estimate of the truth; their spread gives its standard
// error.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "cases.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

struct Estimator {
    const char* name;
    Sampler sampler;
    Emitters emitters;
};

const std::vector<Estimator> kEstimators = {
    {"uniform", Sampler::uniform, Emitters::hit},
    {"cosine", Sampler::cosine, Emitters::hit},
    {"light", Sampler::cosine, Emitters::sample},
    {"mis_balance", Sampler::cosine, Emitters::both},
};

struct Batches {
    Statistics means, variances;
};

Batches run(const SegmentIndex& index, const ShadedPoint& at, const Estimator& estimator) {
    Settings settings;
    settings.samples = 5000;
    settings.maxDepth = 0;
    settings.seed = 33;
    settings.sampler = estimator.sampler;
    settings.emitters = estimator.emitters;
    Batches batches;
    for (std::uint64_t k = 0; k < 200; ++k) {
        const Estimate e = estimateIrradiance(index, at, settings, {.firstRepeat = k, .threads = 2});
        batches.means.add(e.samples.mean);
        batches.variances.add(e.samples.variance());
    }
    return batches;
}

void checkVariances(const std::string& name) {
    const Case known = readCase(name);
    const SegmentIndex index(known.scene);
    const Answer& answer = known.answers.front();
    for (const Estimator& estimator : kEstimators) {
        const double exact = answer.numbers.at(estimator.name);
        const Batches batches = run(index, pointOf(index, answer), estimator);
        // The tabulated bound is absolute; where the variance is smaller still, its digits are good all the
        // same.
        const ZTest variance = zTest(batches.variances, exact, std::min(answer.err, 1e-5 * exact));
        const ZTest mean = zTest(batches.means, answer.depth.front().x, answer.err);
        INFO(name << " " << estimator.name);
        CHECK_MESSAGE(variance.within(kSingle), variance.text());
        CHECK_MESSAGE(mean.within(kSingle), mean.text());
        // The test is sharp enough to see a variance that is off by a quarter.
        CHECK(zTest(batches.variances, 1.25 * exact).within(kSweep) == false);
    }
}

}  // namespace

TEST_CASE("variance: light overhead") {
    checkVariances("33_overhead");
}
TEST_CASE("variance: light at the side") {
    checkVariances("33_oblique");
}
TEST_CASE("variance: light cut by the horizon") {
    checkVariances("33_clipped");
}
TEST_CASE("variance: small light far away") {
    checkVariances("33_tiny_far");
}
TEST_CASE("variance: large light close by") {
    checkVariances("33_close_big");
}

TEST_CASE("variance: the standard error of the mean is that of repeated runs") {
    const Case known = readCase("33_overhead");
    const SegmentIndex index(known.scene);
    const Answer& answer = known.answers.front();
    Settings settings;
    settings.samples = 16;
    settings.emitters = Emitters::hit;
    settings.maxDepth = 0;
    const Estimate e = estimateIrradiance(index, pointOf(index, answer), settings, {.repeats = 20'000});
    // Independent samples: the variance of a mean of N is 1 / N of theirs. The relative error of a variance
    // from R values is about sqrt(2 / R) = 1 %.
    CHECK(e.repeats.variance().x * 16.0 == doctest::Approx(answer.numbers.at("uniform")).epsilon(0.035));
    CHECK(e.samples.variance().x == doctest::Approx(answer.numbers.at("uniform")).epsilon(0.035));
    // Stratified samples vary less together than they do alone.
    settings.sampler = Sampler::stratified;
    const Estimate s = estimateIrradiance(index, pointOf(index, answer), settings, {.repeats = 20'000});
    CHECK(s.repeats.variance().x < 0.5 * e.repeats.variance().x);
}
