// Are the facts right on which plans stand: how many mirrors in a row, how many bounces, what is refused?
#include <doctest/doctest.h>

#include "core/requirements/bounce_findings.h"
#include "core/requirements/series.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

std::uint32_t addMirror(Scene& scene, Vec2 a, Vec2 b, double reflectance = 0.9) {
    const std::uint32_t wall = addWall(scene, a, b);
    scene.materials.back() = Mirror{Rgb(reflectance)};
    return wall;
}

/// Longest chain of mirrors among many rays that are sent through a scene of mirrors.
std::uint32_t longestChain(const Scene& scene) {
    const SegmentIndex index(scene);
    Random random(5);
    std::uint32_t longest = 0;
    for (int k = 0; k < 20'000; ++k) {
        Ray ray{random.pointIn(-1.0, 1.0), random.direction()};
        std::uint32_t chain = 0;
        for (Hit hit = index.closestHit(ray); hit && chain < 500; hit = index.closestHit(ray)) {
            const SurfacePoint at = surfaceAt(index, ray, hit);
            ray = leave(index, at, *sampleSurface(at, Carried::radiance, {0.5, 0.5, 0.5}), ++chain);
        }
        longest = std::max(longest, chain);
    }
    return longest;
}

RequirementsAnswer ask(const Scene& scene, std::vector<Forced> forced = {}, double tolerance = 0.01) {
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, 8};
    RequirementsAnswer answer = requirementsOf(
        {.index = index, .sensor = sensor, .tolerance = tolerance, .forced = std::move(forced)});
    return answer;
}

}  // namespace

TEST_CASE("requirements: the table is in the order of its ids, each named once") {
    for (std::size_t i = 0; i < kRequirements.size(); ++i) {
        CHECK(static_cast<std::size_t>(kRequirements[i].id) == i);
        CHECK((kRequirements[i].kind == Switch::none) == !kRequirements[i].fixed.empty());
        for (std::size_t j = 0; j < i; ++j) CHECK(kRequirements[i].name != kRequirements[j].name);
    }
}

TEST_CASE("requirements: bounds on chains of mirrors hold, and are reached within one event or so") {
    Scene none = litBox();
    CHECK(factsOf(none).longestChain == 0u);
    Scene one = none;
    addMirror(one, {-0.5, 0.4}, {0.5, 0.6});
    CHECK(factsOf(one).longestChain == 1u);
    for (const double degrees : {90.0, 45.0, 31.0, 20.0}) {
        Scene two;
        const double angle = degrees * kPi / 180.0;
        addMirror(two, {0.0, 0.0}, {1.0, 0.0});
        addMirror(two, {0.0, 0.0}, {std::cos(angle), std::sin(angle)});
        const auto bound = factsOf(two).longestChain;
        REQUIRE(bound.has_value());
        const std::uint32_t seen = longestChain(two);
        CHECK(seen <= *bound);
        CHECK(seen + 2 >= *bound);
    }
    Scene parallel;
    addMirror(parallel, {0.0, 0.0}, {1.0, 0.0});
    addMirror(parallel, {0.0, 1.0}, {1.0, 1.0});
    CHECK(!factsOf(parallel).longestChain.has_value());
    Scene glass = none;
    addMirror(glass, {-0.5, 0.4}, {0.5, 0.6});
    glass.materials.back() = Dielectric{1.5, Rgb(0.0)};
    CHECK(!factsOf(glass).longestChain.has_value());
}

TEST_CASE("requirements: the bound by albedo is the geometric series") {
    CHECK(scatteringsUntil(0.0, 0.01) == 0u);
    CHECK(!scatteringsUntil(1.0, 0.01).has_value());
    for (const double share : {0.1, 0.5, 0.9})
        for (const double tolerance : {0.1, 0.01}) {
            const auto D = scatteringsUntil(share, tolerance);
            REQUIRE(D.has_value());
            const auto left = [&](double d) { return std::pow(share, d + 1.0) / (1.0 - share); };
            CHECK(left(*D) <= tolerance * (1.0 + 1e-9));
            if (*D > 0) CHECK(left(*D - 1.0) > tolerance);
        }
}

TEST_CASE("requirements: what is not there is not modelled") {
    const RequirementsAnswer matt = ask(litBox());
    CHECK(matt.plan.maxSpecular == 0);
    CHECK(!matt.of(RequirementId::mis).on);
    CHECK(matt.of(RequirementId::lightSampling).on);
    CHECK(!matt.of(RequirementId::photonPass).on);
    CHECK(!matt.of(RequirementId::index).on);
    CHECK(matt.plan.way.unbiased);
    // Black walls: what comes straight from a lamp is all, and a formula gives it.
    Scene black = litBox();
    black.materials.front() = Diffuse{Rgb(0.0)};
    black.lights.clear();
    addWall(black, {0.5, 1.2}, {-0.5, 1.2}, Rgb(0.0), Rgb(1.0));
    const SegmentIndex blackIndex(black);
    const Sensor probe = Probe{{{0.2, 0.0}, {0.0, 1.0}, 0}};
    const RequirementsAnswer straight = requirementsOf({.index = blackIndex, .sensor = probe});
    CHECK(straight.plan.maxDepth == 0);
    CHECK(straight.plan.estimator->id == "closed-form");
    CHECK(straight.of(RequirementId::bounces).ground == Ground::proof);
    // A caustic of a light without size needs paths from the light.
    Scene mirrored = litBox();
    addMirror(mirrored, {-0.5, 0.4}, {0.5, 0.6});
    CHECK(ask(mirrored).plan.way.lightPass);
    CHECK(ask(mirrored).plan.maxSpecular == 1);
}

TEST_CASE("requirements: a scene without light asks for nothing") {
    Scene dark = litBox();
    dark.lights.clear();
    const RequirementsAnswer answer = ask(dark);
    CHECK(answer.plan.maxDepth == 0);
    for (const PathType& type : answer.pathTypes) CHECK(!type.exists);
}

TEST_CASE("requirements: what is forced is done, or refused in words") {
    const Scene scene = litBox();
    CHECK(ask(scene, {{RequirementId::bounces, 2}}).plan.maxDepth == 2);
    CHECK(ask(scene, {{RequirementId::lightPass, 1}}).plan.way.lightPass);
    CHECK(rouletteOf(ask(scene, {{RequirementId::roulette, 0}}).plan) == 0);
    CHECK(rouletteOf(ask(scene, {{RequirementId::roulette, 1}}).plan) > 0);
    CHECK(ask(scene, {{RequirementId::photonPass, 1}}).plan.estimator->id == "photon-map");
    CHECK(ask(scene, {{RequirementId::index, 1}}).plan.index == IndexMethod::tree);
    CHECK(ask(scene, {{RequirementId::bounces, 2}}).of(RequirementId::bounces).ground == Ground::force);
    CHECK_THROWS_AS(ask(scene, {{RequirementId::colour, 0}}), std::invalid_argument);
    CHECK_THROWS_AS(ask(scene, {{RequirementId::photonPass, 1}, {RequirementId::lightPass, 0}}),
                    std::invalid_argument);
}

TEST_CASE("requirements: the same question gives the same plan") {
    const Scene scene = litBox();
    const RequirementsAnswer a = ask(scene), b = ask(scene);
    CHECK(a.plan.estimator == b.plan.estimator);
    CHECK(a.plan.params == b.plan.params);
    CHECK(a.rays == b.rays);
    for (std::size_t i = 0; i < a.requirements.size(); ++i)
        CHECK(a.requirements[i].reason == b.requirements[i].reason);
}

TEST_CASE("requirements: paths that wait for lamps ask none, so that no shadow ray is cast") {
    // From a floor in the open, with a lamp above: one ray for each path and no more, at depth 0.
    Scene scene;
    addWall(scene, {0.0, 0.0}, {1.0, 0.0});
    addWall(scene, {1.0, 1.0}, {0.0, 1.0}, Rgb(0.5), Rgb(1.0));
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, 4};
    for (const Way& way : allWays()) {
        if (way.emitters != "hit") continue;
        const Plan plan{
            findEstimator(way.estimator), paramsOf(way, index, 0), 0, 0, IndexMethod::automatic, way};
        const Pilot run = pilot({.index = index, .sensor = sensor}, plan, {.rays = 4000});
        CHECK(run.rays == run.paths);
    }
}

TEST_CASE("requirements: a short run is as long as asked, for one pixel too, and ends where no ray is cast") {
    Scene scene = litBox();
    addWall(scene, {0.25, 0.0}, {0.75, 0.0});
    addWall(scene, {0.25, 0.0}, {0.75, 0.0});  // is met in place of neither: lies behind the one before
    const auto hidden = static_cast<std::uint32_t>(scene.segments.size() - 1);
    const SegmentIndex index(scene);
    const auto runOf = [&](const Sensor& sensor) {
        const Way& way = *std::find_if(allWays().begin(), allWays().end(),
                                       [](const Way& other) { return other.estimator == "path"; });
        const Plan plan{
            findEstimator(way.estimator), paramsOf(way, index, 0), 2, 0, IndexMethod::automatic, way};
        return pilot({.index = index, .sensor = sensor}, plan, {.rays = 80'000});
    };
    CHECK(runOf(Probe{{index.pointOn(0, 0.1), index.normal(0), 0}}).rays >= 80'000);
    const Pilot dark = runOf(Profile{{hidden}, 8});
    CHECK(dark.rays == 0);
    CHECK(dark.passes == 10'000);
}

TEST_CASE("requirements: a way that met no light has no noise, and is not chosen for it") {
    // A lamp of a micrometre: no path meets it by chance.
    Scene scene = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}}, Rgb(0.5));
    addWall(scene, {1.0 + 5e-7, 1.2}, {1.0 - 5e-7, 1.2}, Rgb(0.5), Rgb(4e6));
    for (const bool mirror : {false, true}) {
        if (mirror) addMirror(scene, {0.3, 0.5}, {0.3, 0.9});
        const RequirementsAnswer answer = ask(scene);
        CHECK_FALSE(answer.dark);
        CHECK(answer.plan.way.emitters != "hit");
        for (const Candidate& candidate : answer.candidates) {
            if (candidate.plan.way.emitters == "hit") CHECK(candidate.lacks);
            if (candidate.chosen) CHECK(candidate.pilot.mean > 0.1);
        }
    }
}

TEST_CASE("requirements: where no short run meets light, nothing is said to be known") {
    Scene scene = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}}, Rgb(0.5));
    addMirror(scene, {0.3, 0.5}, {0.3, 0.9});
    // A lamp in a box of its own.
    const std::vector<Vec2> box{{1.0, 0.5}, {1.0, 1.0}, {1.5, 1.0}, {1.5, 0.5}};
    for (std::size_t i = 0; i < box.size(); ++i) addWall(scene, box[i], box[(i + 1) % box.size()]);
    addWall(scene, {1.3, 0.8}, {1.2, 0.8}, Rgb(0.5), Rgb(1.0));
    const RequirementsAnswer answer = ask(scene);
    CHECK(answer.dark);
    CHECK(answer.bounces.dark);
    CHECK(answer.plan.way.estimator == "bidirectional");
    CHECK(answer.plan.maxDepth == 4 * *answer.bounces.byAlbedo);
}

TEST_CASE("requirements: what a mix mirrors is scattered later") {
    const auto room = [](double weight, double albedo, double reflectance) {
        Scene scene = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}}, Rgb(0.5));
        scene.materials[0] = Mix{Diffuse{Rgb(albedo)}, Mirror{Rgb(reflectance)}, weight};
        addWall(scene, {1.1, 1.4}, {0.9, 1.4}, Rgb(0.0), Rgb(4.0));
        return scene;
    };
    // Mirrored again and again, half of it each time: in the end all is scattered.
    CHECK(factsOf(room(0.5, 1.0, 1.0)).mostAlbedo == doctest::Approx(1.0));
    CHECK(factsOf(room(0.5, 0.9, 0.8)).mostAlbedo == doctest::Approx(0.45 / (1.0 - 0.4)));
    const Scene scene = room(0.5, 0.97, 0.99);
    const SegmentIndex index(scene);
    const Sensor sensor = EyeStrip{{{0.2, 0.2}, glm::normalize(Vec2(1.0, 0.36)), 1.0}, 8};
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    CHECK(answer.plan.maxDepth > 32);
    const Problem problem{.index = index, .sensor = sensor, .seed = 7};
    const auto upTo = [&](std::uint32_t depth) {
        Plan plan = answer.series->plan;
        plan.maxDepth = depth;
        return pilot(problem, plan, {.rays = 0, .leastPasses = 4000});
    };
    const Pilot all = upTo(300);
    const BeyondDepth planned = shareBeyond(answer.plan.maxDepth, all, upTo(answer.plan.maxDepth));
    CHECK(planned.share - 3.0 * planned.standardError <= kInitialTolerance);
    const BeyondDepth once = shareBeyond(28, all, upTo(28));
    CHECK(once.share - 3.0 * once.standardError > kInitialTolerance);
}

TEST_CASE("requirements: between depths that were measured, and beyond, light falls by the same share") {
    BounceFindings bounces;
    bounces.tolerance = 0.01;
    bounces.measured = {{2, 0.4, 0.02}, {4, 0.1, 0.01}, {8, 0.05, 0.005}};
    CHECK(shareBeyondDepth(bounces, 4)->share == 0.1);
    CHECK(shareBeyondDepth(bounces, 3)->share == doctest::Approx(0.2));
    CHECK(shareBeyondDepth(bounces, 3)->depth == 3);
    CHECK(shareBeyondDepth(bounces, 12)->share == doctest::Approx(0.025));
    CHECK(shareBeyondDepth(bounces, 12)->standardError == doctest::Approx(0.0025));
    // What was enough is not made smaller.
    bounces.tolerance = 0.1;
    CHECK(shareBeyondDepth(bounces, 12)->depth == 8);
    CHECK_FALSE(shareBeyondDepth(BounceFindings{}, 3));
}
