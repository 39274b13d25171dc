// Does the plan ever drop a path that carries light? 200 random scenes, each against bidirectional paths with
// everything on; and plans that are robbed of a part, which must be rejected.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/render.h"
#include "core/requirements/requirements.h"
#include "random_scenes.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr double kTolerance = 0.02;
constexpr std::uint32_t kBins = 6;
constexpr std::uint32_t kScenes = 200, kCases = 10;

Film run(const SegmentIndex& index, const Sensor& sensor, const Plan& plan, std::uint64_t seed,
         std::uint64_t passes) {
    const Problem problem{index, sensor, plan.maxDepth, plan.maxSpecular, seed};
    RenderOptions options;
    options.passes = passes;
    options.threads = 2;
    return render(*plan.estimator->make(problem, plan.params), sensor, options);
}

double grey(const Rgb& c) {
    return (c.x + c.y + c.z) / 3.0;
}

/// How far the films' bins, and all of them together, lie apart in standard errors, less what the tolerance
/// allows. Values of a channel are not told apart: what is lost is lost in grey too.
double worstZ(const Film& film, const Film& truth) {
    double mean = 0.0, sum = 0.0, square = 0.0, worst = 0.0;
    for (const Statistics& pixel : truth.pixels) mean += grey(pixel.mean) / kBins;
    const double allowed = 1.5 * kTolerance * mean;
    for (std::uint32_t i = 0; i < kBins; ++i) {
        const Statistics a = film.pixels[i], b = truth.pixels[i];
        const double difference = grey(a.mean) - grey(b.mean);
        // Channels of a path are alike: the mean of their errors bounds the error of their mean.
        const double error = std::hypot(grey(a.standardError()), grey(b.standardError()));
        sum += difference / kBins;
        square += error * error / (kBins * kBins);
        if (error > 0.0) worst = std::max(worst, (std::abs(difference) - 2.0 * allowed) / error);
    }
    if (square > 0.0) worst = std::max(worst, (std::abs(sum) - allowed) / std::sqrt(square));
    return worst;
}

/// 200 scenes of 7 comparisons: a right plan fails with probability below 1e-3 in all of them (Bonferroni:
/// 7e-7 each, two-sided), and skewed noise, whose tails are longer, is measured again, longer.
constexpr double kRejected = 5.0;
/// What the same robbery of everything on shows so clearly must be seen in the plan.
constexpr double kClear = 12.0;

struct Robbery {
    const char* what;
    bool (*concerns)(const RequirementsAnswer&);
    void (*rob)(Plan&);
};

constexpr Robbery kRobberies[] = {
    {"mirrors and glass", [](const RequirementsAnswer& a) { return a.plan.maxSpecular > 0; },
     [](Plan& plan) { plan.maxSpecular = 0; }},
    {"all bounces", [](const RequirementsAnswer& a) { return a.plan.maxDepth > 0; },
     [](Plan& plan) { plan.maxDepth = 0; }},
    {"all bounces but one", [](const RequirementsAnswer& a) { return a.plan.maxDepth > 1; },
     [](Plan& plan) { plan.maxDepth = 1; }},
};

struct Tally {
    int robbed = 0, clear = 0;
};

void checkScene(std::uint64_t seed, Tally& tally) {
    const Scene scene = randomScene(seed);
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, kBins};
    const RequirementsQuestion question{
        .index = index, .sensor = sensor, .tolerance = kTolerance, .effort = 0.15};
    const RequirementsAnswer answer = requirementsOf(question);
    CHECK_MESSAGE(answer.loses.empty(), answer.loses);
    CHECK(answer.plan.way.unbiased);

    // More scatterings than the plan's, so that what it leaves out would show if it were more than the
    // tolerance.
    const Plan everything = everythingOn(index, sensor, answer.plan.maxDepth + 4,
                                         static_cast<std::uint32_t>(kMaxSpecularInfo.most));
    Film plan = run(index, sensor, answer.plan, 11, 3000), truth = run(index, sensor, everything, 12, 1500);
    double z = worstZ(plan, truth);
    if (z > kRejected - 1.5) {
        plan = run(index, sensor, answer.plan, 13, 24'000);
        truth = run(index, sensor, everything, 14, 12'000);
        z = worstZ(plan, truth);
    }
    CHECK_MESSAGE(z < kRejected,
                  fmt::format("seed {}: {} loses light, z = {:.1f}", seed, answer.plan.estimator->id, z));

    for (const Robbery& robbery : kRobberies) {
        if (!robbery.concerns(answer)) continue;
        Plan robbed = answer.plan, all = everything;
        robbery.rob(robbed);
        robbery.rob(all);
        ++tally.robbed;
        if (worstZ(run(index, sensor, all, 15, 1500), truth) < kClear) continue;  // there was nothing to take
        ++tally.clear;
        const double zRobbed = worstZ(run(index, sensor, robbed, 16, 3000), truth);
        CHECK_MESSAGE(zRobbed > kRejected, fmt::format("seed {}: nobody notices that {} are gone, z = {:.1f}",
                                                       seed, robbery.what, zRobbed));
    }
    // Paths from the sensor alone, where light of lights without size comes through mirrors or glass.
    const SceneTraits& has = answer.facts.traits;
    if (!has.delta || !has.specular) return;
    Plan back = answer.plan;
    back.estimator = findEstimator("path");
    back.params = initialValues(*back.estimator);
    ++tally.robbed;
    const Plan& whole = answer.plan;
    // The oracle: forward and backward paths of the same number of scatterings.
    Plan joined = everythingOn(index, sensor, whole.maxDepth, whole.maxSpecular);
    const Film lacking = run(index, sensor, back, 17, 3000);
    if (worstZ(lacking, run(index, sensor, joined, 18, 1500)) < kClear) return;
    ++tally.clear;
    CHECK_MESSAGE(answer.plan.way.lightPass,
                  fmt::format("seed {}: caustics need paths from the lights", seed));
    CHECK(worstZ(lacking, truth) > kRejected);
}

void checkCase(std::uint32_t which) {
    Tally tally;
    for (std::uint32_t k = which * kScenes / kCases; k < (which + 1) * kScenes / kCases; ++k)
        checkScene(1000 + k, tally);
    MESSAGE(fmt::format("{} robbed plans, {} of them clearly darker, all of these rejected", tally.robbed,
                        tally.clear));
    CHECK(tally.clear > 10);
}

}  // namespace

TEST_CASE("random scenes 0 to 19: no path that carries light is dropped") {
    checkCase(0);
}
TEST_CASE("random scenes 20 to 39: no path that carries light is dropped") {
    checkCase(1);
}
TEST_CASE("random scenes 40 to 59: no path that carries light is dropped") {
    checkCase(2);
}
TEST_CASE("random scenes 60 to 79: no path that carries light is dropped") {
    checkCase(3);
}
TEST_CASE("random scenes 80 to 99: no path that carries light is dropped") {
    checkCase(4);
}
TEST_CASE("random scenes 100 to 119: no path that carries light is dropped") {
    checkCase(5);
}
TEST_CASE("random scenes 120 to 139: no path that carries light is dropped") {
    checkCase(6);
}
TEST_CASE("random scenes 140 to 159: no path that carries light is dropped") {
    checkCase(7);
}
TEST_CASE("random scenes 160 to 179: no path that carries light is dropped") {
    checkCase(8);
}
TEST_CASE("random scenes 180 to 199: no path that carries light is dropped") {
    checkCase(9);
}
