// Do the closed forms of direct light hold where nothing is in the way, and are they refused elsewhere?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstring>

#include "core/estimate.h"
#include "core/estimators/all.h"
#include "core/unoccluded.h"
#include "rooms.h"
#include "run_estimator.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// A few walls, most of which emit, and lights; an environment in one of four.
Scene randomScene(Random& random) {
    Scene scene;
    const auto walls = random.integer(1, 3);
    for (int k = 0; k < walls; ++k) {
        const Vec2 a = random.pointIn(-2.0, 2.0);
        addWall(scene, a, a + random.in(0.2, 1.5) * random.direction(), Rgb(0.5),
                Rgb(random.in(0.0, 1.0) < 0.8 ? random.in(0.1, 3.0) : 0.0), random.in(0.0, 1.0) < 0.3);
    }
    if (random.in(0.0, 1.0) < 0.5) scene.lights.emplace_back(PointLight{random.pointIn(-2.0, 2.0), Rgb(0.7)});
    if (random.in(0.0, 1.0) < 0.5) scene.lights.emplace_back(DirectionalLight{random.direction(), Rgb(0.4)});
    if (random.in(0.0, 1.0) < 0.25) {
        scene.environment.radiance = Rgb(0.5);
        for (auto n = random.integer(0, 4); n > 0; --n)
            scene.environment.strip.emplace_back(random.in(0.0, 2.0));
    }
    return scene;
}

Scene lampOverFloor() {
    Scene scene;
    addWall(scene, {-1.0, 0.0}, {1.0, 0.0}, Rgb(0.8));
    addWall(scene, {0.5, 2.0}, {-0.5, 2.0}, Rgb(0.0), Rgb(3.0));
    scene.segmentNames = {"floor", "lamp"};
    return scene;
}

void addScreen(Scene& scene, Vec2 a, Vec2 b) {
    addWall(scene, a, b);
    scene.segmentNames.back() = "screen";
}

std::string refusal(const Scene& scene, const Sensor& sensor, std::uint32_t depth = 0) {
    const SegmentIndex index(scene);
    return refusalOf(kClosedFormEstimator, {.index = index, .sensor = sensor, .maxDepth = depth}, {});
}

}  // namespace

TEST_CASE("closed form: equals direct light where it claims to, and only there") {
    Random random(8);
    int open = 0, hidden = 0;
    ArcMemory memory;
    for (int trial = 0; trial < 4000; ++trial) {
        const Scene scene = randomScene(random);
        const SegmentIndex index(scene);
        const Visibility visibility(index);
        const ShadedPoint at = random.in(0.0, 1.0) < 0.5
                                   ? shadedPointOn(index, 0, random.in(0.0, 1.0))
                                   : ShadedPoint{random.pointIn(-2.0, 2.0), random.direction()};
        const double exact = directIrradiance(visibility, at).x, formula = unoccludedIrradiance(index, at).x;
        INFO(fmt::format("trial {}: {} and {}", trial, formula, exact));
        if (obstacleAt(visibility, at, memory)) {
            ++hidden;
            // What stands in the way may shine as bright as what it hides; it cannot add light but by its own
            // form, which is in the sum already.
            CHECK(formula > exact);
        } else {
            ++open;
            CHECK(std::abs(formula - exact) <= 1e-12 * (1.0 + exact));
        }
    }
    CHECK(open > 1000);
    CHECK(hidden > 500);
}

TEST_CASE("closed form: fluence is half of the irradiance summed over all normals") {
    Random random(9);
    int open = 0;
    ArcMemory memory;
    for (int trial = 0; trial < 40; ++trial) {
        const Scene scene = randomScene(random);
        const SegmentIndex index(scene);
        const Visibility visibility(index);
        const Vec2 P = random.pointIn(-2.0, 2.0);
        if (obstacleAround(visibility, P, memory)) continue;
        ++open;
        constexpr int kNormals = 20'000;
        double sum = 0.0;
        for (int k = 0; k < kNormals; ++k) {
            const double angle = 2.0 * kPi * (k + 0.5) / kNormals;
            sum += unoccludedIrradiance(index, {P, {std::cos(angle), std::sin(angle)}}).x;
        }
        CHECK(unoccludedFluence(index, P).x == doctest::Approx(sum * kPi / kNormals).epsilon(1e-6));
    }
    CHECK(open > 10);
}

TEST_CASE("closed form: constant sky, and one of quarters") {
    Environment sky{Rgb(0.7)};
    CHECK(environmentIrradiance(sky, {0.6, 0.8}).x == doctest::Approx(1.4).epsilon(1e-15));
    sky.strip = {Rgb(1.0), Rgb(0.0), Rgb(0.0), Rgb(0.0)};  // between +x and +y
    CHECK(environmentIrradiance(sky, {0.0, 1.0}).x == doctest::Approx(0.7).epsilon(1e-14));
    CHECK(environmentIrradiance(sky, {0.0, -1.0}).x == doctest::Approx(0.0));
    CHECK(environmentIrradiance(sky, {std::sqrt(0.5), std::sqrt(0.5)}).x ==
          doctest::Approx(0.7 * std::sqrt(2.0)).epsilon(1e-14));
    sky.strip = {Rgb(0.25)};
    CHECK(environmentIrradiance(sky, {-1.0, 0.0}).x == doctest::Approx(0.35).epsilon(1e-14));

    Scene scene;
    scene.environment = Rgb(0.7);
    const SegmentIndex index(scene);
    CHECK(unoccludedFluence(index, {3.0, 4.0}).x == doctest::Approx(1.4 * kPi).epsilon(1e-14));
    scene.environment.strip = {Rgb(0.5), Rgb(0.0), Rgb(1.0)};
    CHECK(unoccludedFluence(index, {3.0, 4.0}).x == doctest::Approx(0.7 * kPi).epsilon(1e-14));
}

TEST_CASE("closed form: a wall in the way is named, and the place") {
    Scene scene = lampOverFloor();
    const SegmentIndex open(scene);
    const Sensor probe = Probe{shadedPointOn(open, 0, 0.5)}, profile = Profile{{0}, 4};
    CHECK(refusal(scene, probe).empty());
    CHECK(refusal(scene, profile).empty());
    CHECK(refusal(scene, probe, 1) == "closed-form is direct light alone: ask for depth 0, not 1");

    Scene beside = scene;
    addScreen(beside, {0.6, 1.0}, {0.9, 1.5});
    CHECK(refusal(beside, probe).empty());
    CHECK(refusal(beside, profile) ==
          "closed-form is for light with nothing in its way: \"screen\" hides a part of \"lamp\" from "
          "(0.75, 0), in "
          "pixel 3");

    addScreen(scene, {0.1, 1.0}, {0.2, 1.0});
    CHECK(
        refusal(scene, probe) ==
        "closed-form is for light with nothing in its way: \"screen\" hides a part of \"lamp\" from (0, 0)");
    const Sensor eye = EyeStrip{{.position = {0.0, 0.5}, .direction = {0.0, -1.0}, .fov = 0.2}, 2};
    CHECK(refusal(scene, eye).find("\"screen\" hides a part of \"lamp\" from (") != std::string::npos);
    const Sensor field = Field{{-0.2, 0.2}, {0.2, 0.4}, 2, 2};
    CHECK(refusal(scene, field).find("\"screen\" hides a part of \"lamp\" from (") != std::string::npos);
}

TEST_CASE("closed form: lights of no size, and the sky, are hidden too") {
    Scene scene;
    addWall(scene, {-1.0, 0.0}, {1.0, 0.0});
    scene.lights.emplace_back(PointLight{{0.0, 2.0}, Rgb(1.0)});
    const ShadedPoint at{{0.0, 0.0}, {0.0, 1.0}, 0};
    CHECK(refusal(scene, Probe{at}).empty());
    Scene screened = scene;
    addScreen(screened, {-0.1, 1.0}, {0.1, 1.0});
    CHECK(refusal(screened, Probe{at}).find("\"screen\" hides a part of a point light") != std::string::npos);
    screened.lights = {DirectionalLight{{0.0, -1.0}, Rgb(1.0)}};
    CHECK(refusal(screened, Probe{at}).find("\"screen\" hides a part of a directional light") !=
          std::string::npos);
    screened.lights.clear();
    CHECK(refusal(screened, Probe{at}).empty());
    screened.environment = Rgb(1.0);
    CHECK(refusal(screened, Probe{at}).find("\"screen\" hides a part of the environment") !=
          std::string::npos);
    scene.environment = Rgb(1.0);
    CHECK(refusal(scene, Probe{at}).empty());
}

TEST_CASE("closed form: an eye sees lamps, the sky, and diffuse walls in direct light") {
    Scene scene = lampOverFloor();
    const SegmentIndex index(scene);
    const auto seen = [&](Vec2 direction) {
        return runEstimator(kClosedFormEstimator, index, Look{{0.0, 1.0}, direction}, {.maxDepth = 0})
            .pixels[0]
            .mean.x;
    };
    CHECK(seen({0.0, 1.0}) == 3.0);
    CHECK(seen({1.0, 0.0}) == 0.0);
    const double E = 3.0 * 2.0 * 0.5 / std::hypot(0.5, 2.0);
    CHECK(seen({0.0, -1.0}) == doctest::Approx(0.4 * E).epsilon(1e-12));

    scene.materials[0] = Mirror{};
    CHECK(refusal(scene, Look{{0.0, 1.0}, {0.0, -1.0}}) ==
          "closed-form is for light with nothing in its way: \"floor\" is a mirror");
}

TEST_CASE("closed form: a place that only a later pass finds hidden is counted, not shown") {
    Scene scene = lampOverFloor();
    // Its shadow, from 0.1 to 0.4, lies between the places that are tried beforehand.
    scene.lights.emplace_back(PointLight{{0.0, 1.0}, Rgb(1.0)});
    scene.segments[1].emission = Rgb(0.0);
    addScreen(scene, {0.001, 0.99}, {0.004, 0.99});
    const SegmentIndex index(scene);
    const Sensor profile = Profile{{0}, 1};
    REQUIRE(refusal(scene, profile).empty());
    const Film film = runEstimator(kClosedFormEstimator, index, profile, {.maxDepth = 0, .passes = 200});
    CHECK(film.counts.nonFinite > 0);
}

TEST_CASE("closed form: the same bits on any number of threads") {
    const Scene scene = lampOverFloor();
    const SegmentIndex index(scene);
    const auto run = [&](unsigned threads) {
        return runEstimator(kClosedFormEstimator, index, Profile{{0}, 16},
                            {.maxDepth = 0, .passes = 50, .threads = threads});
    };
    const Film one = run(1);
    for (const unsigned threads : {2u, 3u}) {
        const Film more = run(threads);
        for (std::size_t i = 0; i < one.pixels.size(); ++i)
            CHECK(std::memcmp(&one.pixels.mean[i], &more.pixels.mean[i], sizeof(Rgb)) == 0);
    }
}
