// Are lights chosen by their power, and does light set out with all of it?
#include <doctest/doctest.h>

#include "core/light_table.h"
#include "core/quadrature.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Segment lamp(Vec2 a, Vec2 b, double emission, bool twoSided = false) {
    Segment segment;
    segment.a = a;
    segment.b = b;
    segment.emission = Rgb(emission);
    segment.twoSided = twoSided;
    return segment;
}

/// A bulb, a sun, a lamp of one side, one of two, and a sky with a bright spot.
Scene lightsOfAllKinds() {
    Scene scene;
    scene.materials = {Diffuse{Rgb(0.5)}};
    scene.materialNames = {"grey"};
    scene.segments = {lamp({-1, 0}, {1, 0}, 0.0), lamp({0.5, 1}, {0, 1}, 2.0),
                      lamp({-0.5, 0.6}, {-0.8, 0.9}, 1.0, true)};
    scene.segmentNames = {"floor", "lamp", "screen"};
    scene.lights = {PointLight{{0.2, 0.4}, Rgb(0.3)}, DirectionalLight{{0.0, -1.0}, Rgb(0.7)}};
    scene.environment.radiance = Rgb(0.1);
    scene.environment.strip = {Rgb(1.0), Rgb(0.0), Rgb(9.0), Rgb(2.0)};
    return scene;
}

}  // namespace

TEST_CASE("light table: powers in closed form") {
    const Scene scene = lightsOfAllKinds();
    const SegmentIndex index(scene);
    const LightTable table(index);
    CHECK(table.power(0).x == doctest::Approx(0.3 * 2 * kPi));
    CHECK(table.power(1).x == doctest::Approx(0.7 * 2 * table.radius()));
    CHECK(table.power(2).x == doctest::Approx(2.0 * 2 * 0.5));
    CHECK(table.power(3).x == doctest::Approx(4.0 * std::hypot(0.3, 0.3)));
    CHECK(table.power(4).x == doctest::Approx(0.1 * (1 + 9 + 2) * kPi / 2 * 2 * table.radius()));
    double sum = 0.0;
    for (std::uint32_t light = 0; light < 5; ++light) sum += table.probability(light);
    CHECK(sum == doctest::Approx(1.0));
}

TEST_CASE("light table: lights are picked by their power") {
    const Scene scene = lightsOfAllKinds();
    const SegmentIndex index(scene);
    const LightTable table(index);
    Random random(4);
    constexpr int kDraws = 100'000;
    std::vector<std::uint64_t> counts(5, 0);
    for (int i = 0; i < kDraws; ++i) {
        const LightPick pick = table.pick(random.in(0.0, 1.0));
        REQUIRE(pick.probability == doctest::Approx(table.probability(pick.light)));
        ++counts[pick.light];
    }
    std::vector<double> expected, shifted;
    for (std::uint32_t light = 0; light < 5; ++light) {
        expected.push_back(kDraws * table.probability(light));
        shifted.push_back(kDraws * (0.95 * table.probability(light) + 0.05 / 5));
    }
    CHECK(chiSquareTest(counts, expected) > 1e-4);
    CHECK(chiSquareTest(counts, shifted) < 1e-4);
}

TEST_CASE("light table: what sets out carries the power of all lights, from where they are") {
    const Scene scene = lightsOfAllKinds();
    const SegmentIndex index(scene);
    const LightTable table(index);
    double total = 0.0;
    for (std::uint32_t light = 0; light < 5; ++light) total += table.power(light).x;
    Random random(5);
    Statistics power;
    for (int i = 0; i < 20'000; ++i) {
        const Emission light = table.emit(random.in(0.0, 1.0), random.in(0.0, 1.0));
        power.add(light.power);
        REQUIRE(glm::length(light.ray.direction) == doctest::Approx(1.0).epsilon(1e-12));
        if (light.segment == 1) REQUIRE(light.ray.direction.y < 0.0);
        if (light.light == 1) REQUIRE(light.ray.direction == Vec2(0.0, -1.0));
        if (light.light == 0) REQUIRE(light.ray.origin == Vec2(0.2, 0.4));
        if (light.light == 4)
            REQUIRE(std::abs(cross(light.ray.direction, light.ray.origin - table.center())) <=
                    table.radius());
    }
    CHECK(zTest(power, total, 1e-9 * total).within(kSingle));
}

TEST_CASE("light table: the sky is drawn by its radiance") {
    const Scene scene = lightsOfAllKinds();
    const SegmentIndex index(scene);
    const LightTable table(index);
    Random random(6);
    std::vector<std::uint64_t> counts(4, 0);
    Statistics arriving;
    for (int i = 0; i < 60'000; ++i) {
        const LightSample way = table.sampleFrom(table.environmentLight(), {0.0, 0.5}, random.in(0.0, 1.0));
        ++counts[stripIndex(4, way.L)];
        arriving.add(way.L_i);
        REQUIRE(way.pdfAngle == doctest::Approx(table.pdfEnvironment(way.L)));
    }
    CHECK(counts[1] == 0);
    CHECK(chiSquareTest({counts[0], counts[2], counts[3]},
                        {60'000 / 12.0, 60'000 * 9 / 12.0, 60'000 * 2 / 12.0}) > 1e-4);
    // Fluence of the whole sky: the integral of its radiance. Drawn by it, each sample is that integral.
    CHECK(arriving.mean.x == doctest::Approx(0.1 * 12 * kPi / 2).epsilon(1e-9));
    CHECK(arriving.variance().x < 1e-18);
}

TEST_CASE("light table: the density of a direction integrates to the chance of its light") {
    const Scene scene = lightsOfAllKinds();
    const SegmentIndex index(scene);
    const LightTable table(index);
    const Vec2 P(0.1, 0.3);
    double lamps[3] = {};
    constexpr int kRays = 400'000;
    for (int i = 0; i < kRays; ++i) {
        const double angle = 2 * kPi * (i + 0.5) / kRays;
        const Ray ray{P, {std::cos(angle), std::sin(angle)}};
        const Hit hit = index.closestHit(ray);
        lamps[hit ? hit.segment : 0] +=
            hit && hit.segment > 0 ? table.pdfDrawn(ray, hit) * 2 * kPi / kRays : 0.0;
    }
    CHECK(lamps[1] == doctest::Approx(table.probability(2)).epsilon(1e-3));
    CHECK(lamps[2] == doctest::Approx(table.probability(3)).epsilon(1e-3));
}
