// Would these tests notice? Estimators that are wrong on purpose, held against the same answers by the same
// z-test.
#include <doctest/doctest.h>

#include <functional>

#include "cases.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

using Distortion = std::function<Rgb(const Irradiance&)>;

/// Means of 2 samples each, distorted.
Statistics distorted(const SegmentIndex& index, const ShadedPoint& at, Settings settings,
                     const Distortion& distortion) {
    settings.samples = 2;
    Statistics repeats;
    NoObserver observer;
    std::uint64_t rays = 0;
    for (std::uint64_t repeat = 0; repeat < 200'000; ++repeat)
        repeats.add(distortion(gatherOnce(index, at, settings, repeat, SampleRange::all(2), observer, rays)));
    return repeats;
}

Rgb asItIs(const Irradiance& E) {
    return E.total();
}

}  // namespace

TEST_CASE("controls: 1 % too bright, a lost path and a light counted twice are all rejected") {
    const Case known = readCase("22_environment_box");
    const SegmentIndex index(known.scene);
    const Answer& answer = known.answers.back();  // irradiance at a free point
    REQUIRE(answer.query == "irradiance");
    const ShadedPoint at = pointOf(index, answer);
    const double exact = answer.valueAt(2)->x;
    Settings settings;
    settings.maxDepth = 2;
    settings.sampler = Sampler::cosine;
    CHECK(zTest(distorted(index, at, settings, asItIs), exact).within(kSingle));
    const auto rejected = [&](const Distortion& distortion, const Settings& with) {
        return !zTest(distorted(index, at, with, distortion), exact).within(kSweep);
    };
    CHECK(rejected([](const Irradiance& E) { return 1.01 * E.total(); }, settings));
    CHECK(rejected([](const Irradiance& E) { return 0.99 * E.total(); }, settings));
    CHECK(rejected([](const Irradiance& E) { return E.direct; }, settings));
    Settings shallow = settings;
    shallow.maxDepth = 1;  // loses what was scattered twice
    CHECK(rejected(asItIs, shallow));
}

TEST_CASE("controls: a light both sampled and met is too bright") {
    const Case known = readCase("01_segment_light");
    const SegmentIndex index(known.scene);
    const Answer& answer = known.answers.back();
    const ShadedPoint at = pointOf(index, answer);
    Settings settings;
    settings.maxDepth = 0;
    settings.emitters = Emitters::sample;
    const Statistics sampled = distorted(index, at, settings, asItIs);
    settings.emitters = Emitters::hit;
    const Statistics met = distorted(index, at, settings, asItIs);
    const double exact = answer.valueAt(0)->x;
    CHECK(zTest(sampled, exact).within(kSingle));
    CHECK(zTest(met, exact).within(kSingle));
    const double error = std::hypot(sampled.standardError().x, met.standardError().x);
    CHECK_FALSE(ZTest{sampled.mean.x + met.mean.x, error, exact, 0.0}.within(kSweep));
}

TEST_CASE("controls: E at the wrong depth is rejected") {
    const Case known = readCase("05_white_furnace");
    const SegmentIndex index(known.scene);
    const Answer& answer = known.answers.front();
    Settings settings;
    settings.maxDepth = 2;  // gives L at depth 3
    settings.emitters = Emitters::hit;
    const Statistics E = distorted(index, pointOf(index, answer), settings, asItIs);
    const auto test = [&](std::size_t depth) {
        return ZTest{quantityOf(index, answer, E.mean).x, 0.35 * E.standardError().x,
                     answer.valueAt(depth)->x, 0.0};
    };
    CHECK(test(3).within(kSingle));
    CHECK_FALSE(test(2).within(kSweep));
}
