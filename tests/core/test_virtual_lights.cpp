// Do virtual lights add up to the light they stand for, and does clamping take away what its kernel says?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/estimate.h"
#include "core/estimators/all.h"
#include "core/quadrature.h"
#include "core/reference.h"
#include "rooms.h"
#include "run_estimator.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// Light scattered once, with 1 / distance limited to 1 / clamp: over all walls, albedo / 2 E_0 times both
// cosines (at P the one to N, or none) by the distance.
Rgb onceScattered(const SegmentIndex& index, Vec2 P, const Vec2* N, double clamp) {
    Rgb sum{0.0};
    for (std::uint32_t wall = 0; wall < index.scene().segments.size(); ++wall) {
        const Vec2 ofWall = index.normal(wall);
        const auto part = [&](double u) {
            const ShadedPoint from = shadedPointOn(index, wall, u);
            const Vec2 gap = P - from.P;
            const double distance = glm::length(gap);
            const double cosine = std::max(0.0, glm::dot(ofWall, gap) / distance);
            const double atP = N ? std::max(0.0, -glm::dot(*N, gap) / distance) : 1.0;
            const Rgb L = kBoxAlbedo / 2.0 * deltaIrradiance(index, from) * cosine * atP *
                          (index.length(wall) / std::max(distance, clamp));
            return Integrals<3>{L.x, L.y, L.z};
        };
        const Integrals<3> wholeWall = integrate<3>(part, 0.0, 1.0, {1e-9, 1e-9, 1e-9}, 30);
        sum += Rgb(wholeWall[0], wholeWall[1], wholeWall[2]);
    }
    return sum;
}

}  // namespace

TEST_CASE("virtual lights: unbiased without clamp, at a point and as an eye sees it") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const Reference reference(index, 2);
    const ShadedPoint at = shadedPointOn(index, 0, 0.45);
    const Vec2 eye{-0.4, 1.0};
    for (const unsigned depth : {0u, 1u, 2u}) {
        const Ask ask{{{"paths", 16}}, depth, 3000};
        const Film probe = runEstimator(kVirtualLightsEstimator, index, Probe{at}, ask);
        const Film look =
            runEstimator(kVirtualLightsEstimator, index, Look{eye, glm::normalize(at.P - eye)}, ask);
        const Rgb exact = reference.irradiance(at, depth);
        for (int c = 0; c < 3; ++c) {
            const double err = (depth == 0 ? 1e-12 : depth == 1 ? 1e-7 : 1e-3) * exact[c];
            const ZTest ofProbe = zTest(probe.pixels[0], exact[c], err, c);
            INFO(fmt::format("depth {}: {}", depth, ofProbe.text()));
            CHECK(ofProbe.within(kSingle));
            const double half = kBoxAlbedo[c] / 2.0;
            const ZTest ofLook = zTest(look.pixels[0], half * exact[c], half * err, c);
            INFO(fmt::format("depth {}, look: {}", depth, ofLook.text()));
            CHECK(ofLook.within(kSingle));
            if (depth > 0) CHECK_FALSE(zTest(probe.pixels[0], exact[c] * 1.05, err, c).within(kSingle));
        }
    }
}

TEST_CASE("virtual lights: clamping darkens a corner by what the limited kernel says") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const ShadedPoint corner = shadedPointOn(index, 0, 0.02);
    const Rgb direct = deltaIrradiance(index, corner);
    const Rgb whole = onceScattered(index, corner.P, &corner.N, 0.0);
    // The quadrature against another one.
    const Rgb known = Reference(index, 1).irradiance(corner, 1) - direct;
    for (int c = 0; c < 3; ++c) CHECK(whole[c] == doctest::Approx(known[c]).epsilon(1e-6));
    double before = 0.0;
    for (const double clamp : {0.0, 0.1, 0.4}) {
        const Rgb left = onceScattered(index, corner.P, &corner.N, clamp);
        const Film film = runEstimator(kVirtualLightsEstimator, index, Probe{corner},
                                       {{{"paths", 64}, {"clamp", clamp}}, 1, 4000});
        for (int c = 0; c < 3; ++c) {
            const ZTest test = zTest(film.pixels[0], direct[c] + left[c], 1e-6, c);
            INFO(fmt::format("clamp {}: {}", clamp, test.text()));
            CHECK(test.within(kSingle));
            if (clamp == 0.4) {
                // The bias is seen, and it is a loss.
                const ZTest unclamped = zTest(film.pixels[0], direct[c] + whole[c], 1e-6, c);
                CHECK(unclamped.z() < -kSingle);
            }
        }
        const double loss = (whole - left).x;
        CHECK(loss >= before);
        before = loss;
    }
}

TEST_CASE("virtual lights: clamping changes nothing where all walls are farther away") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const auto run = [&](double clamp) {
        const Vec2 P{-0.2, 0.7};
        return runEstimator(kVirtualLightsEstimator, index, Field{P - Vec2(1e-7), P + Vec2(1e-7), 1, 1},
                            {{{"paths", 32}, {"clamp", clamp}}, 1, 3000})
            .pixels[0];
    };
    const Statistics free = run(0.0);
    CHECK(free.mean == run(0.6).mean);
    CHECK(free.mean != run(1.0).mean);
    // Fluence in the middle of the room: straight from the light, and from the walls.
    const Vec2 P{-0.2, 0.7};
    const auto& light = std::get<PointLight>(scene.lights[0]);
    const Rgb exact =
        light.intensity / glm::length(light.position - P) + onceScattered(index, P, nullptr, 0.0);
    for (int c = 0; c < 3; ++c) {
        // The cell is 2e-7 m wide.
        const ZTest test = zTest(free, exact[c], 1e-6 * exact[c], c);
        INFO(test.text());
        CHECK(test.within(kSingle));
    }
}

TEST_CASE("virtual lights: a mirror's light on the wall that is seen is lost, and said to be") {
    Scene scene;
    addWall(scene, {-1.0, 0.0}, {1.0, 0.0}, Rgb(0.5));
    addWall(scene, {0.5, 0.4}, {0.5, 0.8});
    scene.materials[1] = Mirror{Rgb(0.9)};
    scene.lights.emplace_back(DirectionalLight{{0.6, -0.8}, Rgb(2.0)});
    const SegmentIndex index(scene);
    // x = 0.05: in the middle of the strip that the mirror lights.
    const Film film =
        runEstimator(kVirtualLightsEstimator, index, Probe{shadedPointOn(index, 0, 0.525)}, {.passes = 200});
    CHECK(film.pixels[0].mean.x == doctest::Approx(1.6).epsilon(1e-12));
    CHECK(film.pixels[0].variance().x < 1e-20);
    CHECK(kVirtualLightsEstimator.paths(scene, kProbeBit) == "LE or L(S|D)*DE");
    CHECK(kVirtualLightsEstimator.paths(litBox(), kProbeBit) == "LD*E");
}

TEST_CASE("virtual lights: refuses what it can't do before it starts") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const Sensor sensor = Probe{shadedPointOn(index, 0, 0.5)};
    const auto refused = [&](double paths, std::uint32_t depth) {
        const Problem problem{.index = index, .sensor = sensor, .maxDepth = depth};
        return refusalOf(kVirtualLightsEstimator, problem,
                         paramsOf(kVirtualLightsEstimator, {{"paths", paths}}));
    };
    CHECK(refused(0, 1) == "paths is 0, expected a whole number from 1 to 1e+06");
    CHECK(refused(1e12, 1).starts_with("paths is 1e+12, expected"));
    CHECK(refused(1e6, 5).empty());
    CHECK(refused(1e6, 6).find("lower paths") != std::string::npos);
}
