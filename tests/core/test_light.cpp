// Does every light send the right amount from the right place, and does its pdf measure angles?
#include <doctest/doctest.h>

#include "core/estimate.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

doctest::Approx near(double x) {
    return doctest::Approx(x).epsilon(1e-12);
}

/// Angle (rad) under which a segment is seen.
double subtended(Vec2 P, const Segment& s) {
    const Vec2 a = s.a - P, b = s.b - P;
    return std::abs(std::atan2(cross(a, b), glm::dot(a, b)));
}

bool isFinite(const LightSample& s) {
    return halfdisk::isFinite(s.L) && halfdisk::isFinite(s.L_i) && std::isfinite(s.pdfAngle);
}

}  // namespace

TEST_CASE("light: numbered as the delta lights, then the emitting segments") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    REQUIRE(lightCount(index) == 4);
    CHECK(isDelta(index, 0));
    CHECK(isPoint(index, 0));
    CHECK(isDelta(index, 1));
    CHECK_FALSE(isPoint(index, 1));
    CHECK_FALSE(isDelta(index, 2));
    CHECK_FALSE(isPoint(index, 2));
    CHECK(sampleLight(index, 2, {0.0, 0.1}, 0.5).segment == 1);
    CHECK(sampleLight(index, 3, {0.0, 0.1}, 0.5).segment == 3);
}

TEST_CASE("light: a point light falls off with 1 / r") {
    Scene scene;
    scene.lights.emplace_back(PointLight{{3.0, 4.0}, {1.0, 2.0, 5.0}});
    const SegmentIndex index(scene);
    const LightSample s = sampleLight(index, 0, {0.0, 0.0}, 0.7);
    CHECK(s.L.x == near(0.6));
    CHECK(s.L.y == near(0.8));
    CHECK(s.distance == near(5.0));
    CHECK(s.L_i.x == near(0.2));
    CHECK(s.L_i.z == near(1.0));
    CHECK(s.segment == kNoSegment);
    CHECK(s.pdfAngle == 0.0);
    // Twice as far, half as much: not a quarter.
    CHECK(sampleLight(index, 0, {-3.0, -4.0}, 0.7).L_i.x == near(0.1));
}

TEST_CASE("light: a directional light comes from where it does not travel to") {
    Scene scene;
    scene.lights.emplace_back(DirectionalLight{{0.6, -0.8}, {1.0, 2.0, 3.0}});
    const LightSample s = sampleLight(SegmentIndex(scene), 0, {9.0, 9.0}, 0.1);
    CHECK(s.L == Vec2(-0.6, 0.8));
    CHECK(s.distance == kInfinity);
    CHECK(s.L_i == Rgb(1.0, 2.0, 3.0));
}

TEST_CASE("light: the mean of 1 / pdfAngle over a segment is the angle under which it is seen") {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        Scene scene;
        const Vec2 a = random.pointIn(-2.0, 2.0), b = random.pointIn(-2.0, 2.0),
                   P = random.pointIn(-1.0, 1.0);
        addWall(scene, a, b, Rgb(0.0), Rgb(1.0));
        const SegmentIndex index(scene);
        const bool inFront = cross(b - a, P - a) > 0.0;
        const double closest = std::abs(cross(b - a, P - a)) / glm::length(b - a);
        if (closest < 0.1) continue;  // the midpoint rule below needs a smooth integrand
        constexpr int kPanels = 20'000;
        double mean = 0.0;
        for (int k = 0; k < kPanels; ++k) {
            const LightSample s = sampleLight(index, 0, P, (k + 0.5) / kPanels);
            if (s.pdfAngle > 0.0) mean += 1.0 / s.pdfAngle / kPanels;
        }
        REQUIRE(mean == doctest::Approx(inFront ? subtended(P, scene.segments[0]) : 0.0).epsilon(1e-6));
    }
}

TEST_CASE("light: L_i times pdfAngle is the radiance, and pdfLight agrees with sampleLight") {
    Random random(2);
    int compared = 0;
    for (int i = 0; i < 20'000; ++i) {
        Scene scene;
        const Vec2 a = random.pointIn(-2.0, 2.0), b = random.pointIn(-2.0, 2.0);
        addWall(scene, a, b, Rgb(0.0), {3.0, 2.0, 1.0}, i % 2 == 0);
        const SegmentIndex index(scene);
        const Vec2 P = random.pointIn(-2.0, 2.0);
        const double u = random.in(0.0, 1.0);
        const LightSample s = sampleLight(index, 0, P, u);
        REQUIRE(glm::length(s.L) == near(1.0));
        if (s.pdfAngle == 0.0) continue;
        REQUIRE(s.L_i.x * s.pdfAngle == near(3.0));
        REQUIRE(s.L_i.z * s.pdfAngle == near(1.0));
        const double stretch = random.in(0.1, 10.0);  // the direction of a ray need not be of unit length
        const Ray ray = {P, stretch * s.L};
        const Hit hit = index.closestHit(ray);
        if (!hit) continue;  // u next to an end
        ++compared;
        REQUIRE(hit.u == doctest::Approx(u).epsilon(1e-6));
        const double grazing = std::abs(glm::dot(s.L, index.normal(0)));
        REQUIRE(pdfLight(index, ray, hit) == doctest::Approx(s.pdfAngle).epsilon(1e-13 / grazing));
    }
    CHECK(compared > 14'000);
}

TEST_CASE("light: the back of a one-sided segment is dark, that of a two-sided one is not") {
    Scene scene;
    addWall(scene, {0.0, 1.0}, {1.0, 1.0}, Rgb(0.0), Rgb(1.0));
    addWall(scene, {0.0, 1.0}, {1.0, 1.0}, Rgb(0.0), Rgb(1.0), true);
    const SegmentIndex index(scene);
    CHECK(sampleLight(index, 0, {0.5, 0.0}, 0.5).L_i == Rgb(0.0));
    CHECK(sampleLight(index, 0, {0.5, 0.0}, 0.5).pdfAngle == 0.0);
    CHECK(sampleLight(index, 0, {0.5, 2.0}, 0.5).L_i.x == near(1.0));
    CHECK(sampleLight(index, 1, {0.5, 0.0}, 0.5).L_i.x == near(1.0));
    CHECK(sampleLight(index, 1, {0.5, 2.0}, 0.5).L_i.x == near(1.0));
}

TEST_CASE("light: a point exactly on a light gets nothing from it, and nothing that is not a number") {
    Scene scene;
    scene.lights.emplace_back(PointLight{{0.5, 1.0}, Rgb(1.0)});
    addWall(scene, {0.0, 1.0}, {1.0, 1.0}, Rgb(0.0), Rgb(1.0));
    const SegmentIndex index(scene);
    for (const Vec2 P : {Vec2(0.5, 1.0), Vec2(0.0, 1.0), Vec2(1.0, 1.0)})
        for (std::uint32_t light = 0; light < 2; ++light)
            for (const double u : {0.0, 0.25, 0.5, 1.0}) CHECK(isFinite(sampleLight(index, light, P, u)));
    CHECK(sampleLight(index, 0, {0.5, 1.0}, 0.5).L_i == Rgb(0.0));
    CHECK(sampleLight(index, 1, {0.5, 1.0}, 0.5).L_i == Rgb(0.0));
    CHECK(sampleLight(index, 1, {0.5, 1.0}, 0.25).L_i == Rgb(0.0));
}

TEST_CASE("light: a wall that emits never spoils its own estimate") {
    // An axis-aligned wall sees its own points exactly edge-on: every pdf and every cosine is 0 there.
    const std::vector<Vec2> square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    const Scene room = polygonRoom(square, Rgb(0.5), Rgb(1.0));
    const SegmentIndex index(room);
    for (const auto& sampler : kSamplers)
        for (const auto& emitters : kEmitters) {
            CAPTURE(sampler.name);
            CAPTURE(emitters.name);
            Settings settings;
            settings.samples = 4;
            settings.maxDepth = 1;
            settings.sampler = sampler.value;
            settings.emitters = emitters.value;
            for (std::uint32_t wall = 0; wall < 4; ++wall)
                CHECK(estimateIrradiance(index, shadedPointOn(index, wall, 0.3), settings, {.repeats = 20})
                          .nonFinite() == 0);
        }
}
