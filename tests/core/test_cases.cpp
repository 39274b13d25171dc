// Does castRay agree with the exact answers, with every sampler, every way to count emitters, at every depth?
//
// Each value within 3.5 standard errors, or asked again (see Sweep).
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "cases.h"
#include "measure.h"
#include "sweep.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

struct Plan {
    std::vector<Sampler> samplers = {Sampler::uniform, Sampler::cosine, Sampler::stratified};
    std::vector<Emitters> emitters = {Emitters::sample, Emitters::hit, Emitters::both};
    std::uint32_t maxDepth = 2;  ///< of the depth setting
    Effort effort = {};
    double precision = 0.005;  ///< demanded, relative to the answer
};

void checkAnswer(const SegmentIndex& index, const Answer& answer, std::size_t depth, const Settings& settings,
                 const Plan& plan, Sweep& sweep) {
    const ShadedPoint at = pointOf(index, answer);
    const Rgb exact = *answer.valueAt(depth);
    // L = Le + albedo / 2 E: what the precision of L asks of E.
    const Rgb slope = quantityOf(index, answer, Rgb(1.0)) - quantityOf(index, answer, Rgb(0.0));
    Rgb scale(0.0);
    for (int c = 0; c < 3; ++c)
        if (slope[c] > 0.0) scale[c] = exact[c] / slope[c];
    const auto measured = [&](bool again) {
        Settings draws = settings;
        Effort effort = plan.effort;
        if (again) {
            draws.seed += 5000;
            effort.precision /= 2.0;
            effort.rays *= 4.0;
            effort.leastRepeats *= 4.0;
        }
        const Estimate estimate = measure(index, at, draws, scale, effort);
        CHECK(estimate.nonFinite() == 0);
        CHECK(estimate.samples.negative == 0);
        const Rgb mean = quantityOf(index, answer, estimate.repeats.mean),
                  error = slope * estimate.repeats.standardError();
        std::vector<ZTest> tests;
        for (int c = 0; c < (exact == Rgb(exact.x) ? 1 : 3); ++c)
            tests.push_back({mean[c], error[c], exact[c], answer.err});
        return tests;
    };
    for (const ZTest& test : sweep.settle(measured)) {
        CHECK_MESSAGE(test.within(kSingle), test.text());
        CHECK_MESSAGE(test.standardError <= plan.precision * test.exact, test.text());
    }
}

void checkCase(const std::string& name, const Plan& plan = {}) {
    Sweep sweep;
    const Case known = readCase(name);
    const SegmentIndex index(known.scene);
    for (std::size_t a = 0; a < known.answers.size(); ++a) {
        const Answer& answer = known.answers[a];
        for (std::size_t depth = 0; depth <= plan.maxDepth + 1; ++depth) {
            const auto setting = depthSetting(answer, depth);
            if (!setting || *setting > plan.maxDepth || !answer.valueAt(depth)) continue;
            for (const Sampler sampler : plan.samplers)
                for (const Emitters emitters : plan.emitters) {
                    if (emitters != plan.emitters.front() && index.emitters().empty())
                        continue;  // all three are one
                    INFO(fmt::format("{} answer {} depth {} {} {}", name, a, depth,
                                     nameOf(kSamplers, sampler), nameOf(kEmitters, emitters)));
                    Settings settings;
                    settings.maxDepth = *setting;
                    settings.sampler = sampler;
                    settings.emitters = emitters;
                    settings.seed = 1000 + a;
                    checkAnswer(index, answer, depth, settings, plan, sweep);
                }
        }
    }
    MESSAGE(name << ": " << sweep.text());
    CHECK(sweep.again() <= sweep.mostAgain());
}

}  // namespace

TEST_CASE("exact case 01: a light above a floor") {
    checkCase("01_segment_light");
}
TEST_CASE("exact case 03: a light behind an occluder") {
    checkCase("03_occluded_light");
}
TEST_CASE("exact case 05: white furnace") {
    checkCase("05_white_furnace");
}
TEST_CASE("exact case 09: closed room in colour") {
    checkCase("09_cornell_rgb", {.emitters = {Emitters::sample, Emitters::both}});
}
TEST_CASE("exact case 09: closed room in colour, its light met by chance") {
    checkCase("09_cornell_rgb",
              {.emitters = {Emitters::hit}, .effort = {.precision = 0.006, .rays = 3e6}, .precision = 0.01});
}
TEST_CASE("exact case 14: square of albedo 0.99") {
    checkCase("14_square_albedo_0.99");
}
TEST_CASE("exact case 16: V-groove of 60 degrees") {
    checkCase("16_vgroove_60");
}
TEST_CASE("exact case 22: box under an environment") {
    checkCase("22_environment_box");
}

TEST_CASE("exact case 20b: a light seen edge-on, by sampling it") {
    // The half-disk meets it once in 10^5 samples; the light's own pdf is high enough that `both` sees it
    // too.
    checkCase("20b_grazing", {.emitters = {Emitters::sample, Emitters::both}, .maxDepth = 0});
}

TEST_CASE("exact case 20b: met by chance it is right on average") {
    checkCase("20b_grazing", {.samplers = {Sampler::uniform, Sampler::cosine},
                              .emitters = {Emitters::hit},
                              .maxDepth = 0,
                              .effort = {.rays = 1.5e7},
                              .precision = 0.15});
}

TEST_CASE("exact case 33: one light, five places") {
    for (const char* name : {"33_overhead", "33_oblique", "33_clipped", "33_close_big"})
        checkCase(name, {.maxDepth = 0});
    checkCase("33_tiny_far", {.emitters = {Emitters::sample, Emitters::both}, .maxDepth = 0});
    checkCase("33_tiny_far", {.emitters = {Emitters::hit}, .maxDepth = 0, .precision = 0.05});
}

TEST_CASE("exact case 07: the vertices of the circle of 10 000 sides are those of the case") {
    const Case known = readCase("07_circle_10000_arc");
    REQUIRE(known.scene.segments.size() == 10'000);
    for (std::size_t k = 0; k < 10'000; ++k) {
        const Segment& side = known.scene.segments[k];
        const double angle = 2.0 * kPi * static_cast<double>(k) / 10'000.0;
        REQUIRE(glm::length(side.a - Vec2(std::cos(angle), std::sin(angle))) < 3e-15);
        REQUIRE(side.b == known.scene.segments[(k + 1) % 10'000].a);
        REQUIRE(side.emission == Rgb(k < 1250 ? 1.0 : 0.0));
    }
}

TEST_CASE("exact case 07: circle of 10 000 sides, its light met by chance") {
    // Each ray asks 10 000 walls: many slices and few repeats give the most for the time.
    const Plan direct = {.samplers = {Sampler::stratified},
                         .emitters = {Emitters::hit},
                         .maxDepth = 0,
                         .effort = {.rays = 5e4, .samplesPerBounce = 400, .pilot = 10}};
    checkCase("07_circle_10000_arc", direct);
    Plan indirect = direct;
    indirect.maxDepth = 1;
    indirect.effort.samplesPerBounce = 24;
    indirect.precision = 0.02;
    checkCase("07_circle_10000_arc", indirect);
}

TEST_CASE("exact case 07: circle of 10 000 sides, its 1250 lights sampled") {
    // (Meeting one of them as well adds so little, so rarely, that a few repeats cannot tell how little.)
    Plan plan = {.samplers = {Sampler::cosine},
                 .emitters = {Emitters::sample},
                 .maxDepth = 0,
                 .effort = {.samplesPerBounce = 1, .pilot = 2, .leastRepeats = 15.0},
                 .precision = 1e-3};
    plan.effort.precision = 1e-3;
    checkCase("07_circle_10000_arc", plan);
}
