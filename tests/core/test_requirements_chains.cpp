// Are chains of mirrors and glass followed as far as they bring light, where geometry has no bound?
#include <doctest/doctest.h>

#include "core/render.h"
#include "core/requirements/requirements.h"
#include "core/requirements/series.h"
#include "core/requirements/specular_findings.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// A lamp and a matt plate in a box of mirrors that lose nothing; light goes round until it meets the plate.
/// With a bead of glass it does so for long. The plate is wall 0.
Scene mirrorBox(bool bead) {
    Scene scene;
    addWall(scene, {0.2, 0.1}, {0.5, 0.1});
    scene.materials.back() = Diffuse{Rgb(0.8)};
    scene.segments[addWall(scene, {1.05, 1.9}, {0.95, 1.9})].emission = Rgb(1.0);
    const auto add = [&](const std::vector<Vec2>& corners, const Material& material) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            addWall(scene, corners[i], corners[(i + 1) % corners.size()]);
            scene.materials.back() = material;
        }
    };
    add({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, Mirror{Rgb(1.0)});
    std::vector<Vec2> around;
    constexpr int kFacets = 16;
    for (int k = 0; k < kFacets; ++k) {
        const double angle = -2.0 * kPi * k / kFacets;
        around.push_back(Vec2(0.3, 1.7) + 0.05 * Vec2(std::cos(angle), std::sin(angle)));
    }
    if (bead) add(around, Dielectric{1.5, Rgb(0.0)});
    return scene;
}

constexpr std::uint64_t kPasses = 20'000;

Statistics lightBy(const Plan& plan, const SegmentIndex& index, const Sensor& sensor) {
    const Problem problem{index, sensor, plan.maxDepth, plan.maxSpecular, 77};
    const auto estimator = plan.estimator->make(problem, plan.params);
    RenderOptions options;
    options.passes = kPasses;
    return render(*estimator, sensor, options).pixels[0];
}

/// By how many standard errors, and as which share of the truth, the plan brings less.
struct Lack {
    double share = 0.0, sure = 0.0;
};

Lack lackOf(const Plan& plan, const Statistics& truth, const SegmentIndex& index, const Sensor& sensor) {
    const Statistics found = lightBy(plan, index, sensor);
    const double less = truth.mean.x - found.mean.x;
    return {less / truth.mean.x, less / std::hypot(truth.standardError().x, found.standardError().x)};
}

}  // namespace

TEST_CASE("requirements: chains in glass between mirrors are followed as far as they bring light") {
    const Sensor sensor = Profile{{0}, 1};
    for (const bool bead : {false, true}) {
        CAPTURE(bead);
        const Scene scene = mirrorBox(bead);
        const SegmentIndex index(scene);
        const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
        CHECK(answer.plan.maxSpecular > 100);
        const Requirement& told = answer.of(RequirementId::specular);
        CHECK(told.ground == Ground::measurement);
        CHECK(told.number == answer.plan.maxSpecular);
        REQUIRE(!answer.specular.measured.empty());
        CHECK(answer.specular.measured.front().share > 0.05);

        Plan deepest = answer.plan;
        deepest.maxSpecular = static_cast<std::uint32_t>(kMaxSpecularInfo.most);
        const Statistics truth = lightBy(deepest, index, sensor);
        CHECK(lackOf(answer.plan, truth, index, sensor).share < 2.0 * kInitialTolerance);
        // The usual number is told from the truth.
        Plan usual = answer.plan;
        usual.maxSpecular = static_cast<std::uint32_t>(kMaxSpecularInfo.initial);
        const Lack robbed = lackOf(usual, truth, index, sensor);
        CHECK(robbed.share > 0.05);
        CHECK(robbed.sure > 4.0);
    }
}

namespace {

/// A lamp at the far end of two mirrors that face each other, seen at an angle: all of its light comes by
/// many mirrors, 85 of them in the middle of the picture.
Scene mirrorTube(double reflectance) {
    Scene scene;
    addWall(scene, {0.0, 0.0}, {0.2, 0.0});
    const std::uint32_t lamp = addWall(scene, {0.15, 20.0}, {0.05, 20.0});
    scene.segments[lamp].emission = Rgb(4.0);
    for (const auto& [a, b] : {std::pair(Vec2(0.2, 0.0), Vec2(0.2, 20.0)), {Vec2(0.0, 20.0), Vec2(0.0)}}) {
        addWall(scene, a, b);
        scene.materials.back() = Mirror{Rgb(reflectance)};
    }
    return scene;
}

}  // namespace

TEST_CASE("requirements: chains between mirrors that absorb are followed as far as they bring light") {
    const Scene scene = mirrorTube(0.9);
    const SegmentIndex index(scene);
    const Sensor sensor = EyeStrip{{{0.1, 1.5}, glm::normalize(Vec2(0.577, 1.0)), 10.0 * kPi / 180.0}, 4};
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    // Of what sets out 0.9^44 < 1 % is left; but all that arrives has come by more of them.
    CHECK(answer.specular.measured.front().depth == 44);
    CHECK(answer.specular.measured.front().share > 0.5);
    CHECK(answer.of(RequirementId::specular).ground == Ground::measurement);
    const Problem problem{.index = index, .sensor = sensor, .seed = 5};
    const auto upTo = [&](std::uint32_t events) {
        Plan plan = answer.plan;
        plan.maxSpecular = events;
        return pilot(problem, plan, {.rays = 0, .leastPasses = 2000});
    };
    const Pilot all = upTo(static_cast<std::uint32_t>(kMaxSpecularInfo.most));
    const auto missing = [&](std::uint32_t events) { return shareBeyond(events, all, upTo(events)); };
    const BeyondDepth planned = missing(answer.plan.maxSpecular), bound = missing(44);
    CHECK(planned.share <= kInitialTolerance);
    CHECK(bound.share - 4.0 * bound.standardError > 0.5);
}

// Unfolded, the lamps are half of a line at a height of 18.5 m, so that every angle above the horizontal
// brings the same light, after 18.5 m / (0.2 m tan) mirrors: the lowest ones after more than are ever
// followed.
TEST_CASE("requirements: light of chains that are too long for any number of events is estimated, and told") {
    Scene scene = mirrorTube(1.0);
    for (const std::uint32_t matt : {0, 1}) scene.materials[matt] = Diffuse{Rgb(0.0)};
    const SegmentIndex index(scene);
    constexpr double kFan = 40.0 * kPi / 180.0;
    const Sensor sensor = EyeStrip{{{0.1, 1.5}, {std::cos(kFan / 2.0), std::sin(kFan / 2.0)}, kFan}, 8};
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    CHECK(answer.plan.maxSpecular == kMaxSpecularInfo.most);
    for (const BeyondDepth& beyond : answer.specular.measured) {
        const double truth = std::min(1.0, std::atan(18.5 / (0.2 * beyond.depth)) / kFan);
        CAPTURE(beyond.depth);
        CAPTURE(truth);
        CHECK(std::abs(beyond.share - truth) < 4.0 * beyond.standardError);
    }
    const BeyondDepth& last = answer.specular.measured.back();
    CHECK(last.depth == kMaxSpecularInfo.most);
    CHECK(last.share > 4.0 * last.standardError);
    CHECK(answer.of(RequirementId::specular).reason.find("some light is missing") != std::string::npos);
}

TEST_CASE("requirements: a kaleidoscope of more images than can be followed is measured") {
    Scene scene;
    addWall(scene, {2.2, -0.5}, {2.2, 0.5}, Rgb(0.5), Rgb(1.0));
    for (const auto& [a, b] : {std::pair(Vec2(0.0), Vec2(2.0, 0.0)), {{2.0, 0.0105}, {0.0, 0.007}}}) {
        addWall(scene, a, b);
        scene.materials.back() = Mirror{Rgb(1.0)};
    }
    const SegmentIndex index(scene);
    const Sensor sensor = EyeStrip{{{1.0, 0.005}, glm::normalize(Vec2(0.2, 1.0)), 1.0}, 4};
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    REQUIRE(answer.facts.longestChain);
    CHECK(*answer.facts.longestChain > kMaxSpecularInfo.most);
    CHECK(answer.plan.maxSpecular <= kMaxSpecularInfo.most);
    CHECK(answer.of(RequirementId::specular).ground == Ground::measurement);
}

TEST_CASE("requirements: chains beyond the longest bring as much, path by path, as the last that ended") {
    Pilot half, all;
    half.totals = {1.0, 2.0, 3.0};
    all.totals = {1.5, 2.5, 3.5};
    half.cut = 50;
    all.cut = 25;
    CHECK(endlessChains(all, half).light == doctest::Approx(0.5));
    CHECK(endlessChains(all, half).standardError == doctest::Approx(0.0));
    all.cut = 10;
    CHECK(endlessChains(all, half).light == doctest::Approx(0.5 * 10.0 / 40.0));
    all.totals[0] += 0.9;
    CHECK(endlessChains(all, half).light == doctest::Approx(0.8 * 10.0 / 40.0));
    CHECK(endlessChains(all, half).standardError == doctest::Approx(0.3 * 10.0 / 40.0));
    // None of them ended, so that nothing is known of what they bring.
    all.cut = 50;
    CHECK(endlessChains(all, half).light == 0.0);
    CHECK(endlessChains(all, half).standardError == 0.0);
}

// A lamp deep in a slit between two mirrors: paths from the eye hardly ever come so far, and the few that do
// say little about what their light becomes in the room.
TEST_CASE("requirements: light that few paths meet is followed by a way that meets it, as deep as it goes") {
    Scene scene = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}}, Rgb(0.5));
    addWall(scene, {1.9, 0.6}, {1.9, 0.62}, Rgb(0.0), Rgb(30.0));
    for (const double height : {0.6, 0.62}) {
        addWall(scene, {0.4, height}, {1.9, height}, Rgb(0.0), Rgb(0.0), true);
        scene.materials.back() = Mirror{Rgb(0.9)};
    }
    const SegmentIndex index(scene);
    const Sensor sensor = EyeStrip{{{0.3, 0.3}, glm::normalize(Vec2(1.0, 0.5)), kPi / 3.0}, 16};
    for (const std::uint64_t seed : {1u, 2u}) {
        const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor, .seed = seed});
        REQUIRE(answer.series);
        CHECK(answer.series->plan.way.estimator == "bidirectional");
        const auto upTo = [&](std::uint32_t depth) {
            Plan plan = answer.series->plan;
            plan.maxDepth = depth;
            return pilot({.index = index, .sensor = sensor, .seed = 77}, plan,
                         {.rays = 0, .leastPasses = 600});
        };
        const Pilot all = upTo(answer.series->deepest);
        const auto missing = [&](std::uint32_t depth) { return shareBeyond(depth, all, upTo(depth)); };
        const BeyondDepth planned = missing(answer.plan.maxDepth), early = missing(3);
        CAPTURE(answer.plan.maxDepth);
        CHECK(planned.share - 3.0 * planned.standardError <= kInitialTolerance);
        CHECK(early.share - 3.0 * early.standardError > 2.0 * kInitialTolerance);
    }
}

TEST_CASE("requirements: where no path tried is longer, the usual number of glass events does") {
    Scene scene = litBox();
    std::vector<Vec2> corners{{-0.2, 0.4}, {-0.2, 0.6}, {0.2, 0.6}, {0.2, 0.4}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        addWall(scene, corners[i], corners[(i + 1) % corners.size()]);
        scene.materials.back() = Dielectric{1.1, Rgb(50.0)};  // hardly anything comes back from inside
    }
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, 4};
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    CHECK(answer.plan.maxSpecular == kMaxSpecularInfo.initial);
    CHECK(answer.specular.measured.size() <= 1);
}

namespace {

/// Totals of three runs, `third` deep each: what a third brings is `ratio` of what the third before brought.
std::array<Pilot, 3> fallingRuns(double ratio, double noise) {
    std::array<Pilot, 3> runs;
    Random random(3);
    for (int pass = 0; pass < 1000; ++pass) {
        double total = 0.0, brings = 8.0;
        for (Pilot& run : runs) {
            run.totals.push_back(total += brings * random.in(1.0 - noise, 1.0 + noise));
            brings *= ratio;
        }
    }
    for (Pilot& run : runs) {
        for (const double total : run.totals) run.mean += total / 1000.0;
    }
    return runs;
}

/// A matt room with a bulb and a mirror: only photons carry all of its light to an eye.
Scene bulbAndMirror() {
    Scene scene;
    const Vec2 corners[] = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}};
    addWall(scene, {0.0, 1.0}, {0.0, 0.1});
    scene.materials.back() = Mirror{Rgb(0.95)};
    for (int i = 0; i < 4; ++i) {
        addWall(scene, corners[i], corners[(i + 1) % 4]);
        scene.materials.back() = Diffuse{Rgb(0.7)};
    }
    scene.lights.emplace_back(PointLight{{1.0, 1.0}, Rgb(1.0)});
    return scene;
}

}  // namespace

TEST_CASE("requirements: light beyond the deepest paths is what falling on would bring") {
    for (const double ratio : {0.1, 0.5, 0.9}) {
        const auto runs = fallingRuns(ratio, 0.0);
        const double beyond = 8.0 * std::pow(ratio, 3.0) / (1.0 - ratio);
        const Tail tail = tailOf(runs[2], runs[1], runs[0], 1.0);
        CHECK(tail.light == doctest::Approx(beyond));
        CHECK(tail.standardError == doctest::Approx(0.0).epsilon(1e-9));
        // Walls that keep less make it less.
        const double kept = 0.8 * ratio;
        CHECK(tailOf(runs[2], runs[1], runs[0], kept).light ==
              doctest::Approx(8.0 * ratio * ratio * kept / (1.0 - kept)));
        const auto noisy = fallingRuns(ratio, 0.5);
        const Tail unsure = tailOf(noisy[2], noisy[1], noisy[0], 0.95);
        CHECK(unsure.standardError > 0.0);
        CHECK(std::abs(unsure.light - beyond) < 5.0 * unsure.standardError);
    }
    Pilot still;
    still.totals = {1.0, 1.0};
    CHECK(tailOf(still, still, still, 0.9).light == 0.0);
}

TEST_CASE("requirements: where only photons carry all light, no more than the tolerance is left out") {
    const Scene scene = bulbAndMirror();
    const SegmentIndex index(scene);
    const Sensor sensor = EyeStrip{{{0.3, 0.9}, glm::normalize(Vec2(1.0, -0.5)), 1.4}, 8};
    for (const double tolerance : {0.1, 0.01}) {
        const RequirementsAnswer answer = requirementsOf({index, sensor, tolerance});
        REQUIRE(answer.plan.way.photonPass);
        const Problem problem{.index = index, .sensor = sensor, .seed = 99};
        const auto upTo = [&](std::uint32_t depth) {
            Plan plan = answer.plan;
            plan.maxDepth = depth;
            return pilot(problem, plan, {.rays = 0, .leastPasses = 24});
        };
        const Pilot all = upTo(60);
        const auto missing = [&](std::uint32_t depth) { return shareBeyond(depth, all, upTo(depth)); };
        const BeyondDepth planned = missing(answer.plan.maxDepth);
        INFO("depth " << planned.depth << ": " << planned.share << " of " << tolerance);
        CHECK(planned.share - 3.0 * planned.standardError <= tolerance);
        // Two scatterings fewer would be told.
        const BeyondDepth fewer = missing(answer.plan.maxDepth - 2);
        CHECK(fewer.share - 3.0 * fewer.standardError > tolerance);
    }
}
