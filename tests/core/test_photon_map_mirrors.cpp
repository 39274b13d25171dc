// Does the photon map carry the light that mirrors throw on walls, once, and to its place?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "photon_kernel.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("photon map: the caustic of a mirror has its place and power, where backward paths see none") {
    Scene scene;
    addWall(scene, {-1.0, 0.0}, {1.0, 0.0}, Rgb(0.5));
    addWall(scene, {0.5, 0.4}, {0.5, 0.8});
    scene.materials[1] = Mirror{{0.9, 0.6, 0.3}};
    scene.lights.emplace_back(DirectionalLight{{0.6, -0.8}, Rgb(2.0)});
    const SegmentIndex index(scene);
    // The mirror's ends send their light down a slope of 4 / 3; its shadow falls to the right of it.
    constexpr double kFrom = 0.5 - 0.75 * 0.8, kTo = 0.5 - 0.75 * 0.4, kRadius = 0.02, kDirect = 2.0 * 0.8;
    const Sensor sensor = Profile{{0}, 80};
    constexpr double kBin = 2.0 / 80;
    for (const double gather : {0.0, 2.0})
        for (const double caustics : {0.0, 1.0}) {
            const Ask ask{{{"photons", 500},
                           {"gather", gather},
                           {"caustics", caustics},
                           {"radius", caustics > 0.0 ? 0.3 : kRadius},
                           {"caustic-radius", kRadius}},
                          0,
                          400};
            const Film film = runEstimator(kPhotonMapEstimator, index, sensor, ask);
            for (std::size_t bin = 0; bin < 60; ++bin) {
                const double left = -1.0 + static_cast<double>(bin) * kBin, right = left + kBin;
                INFO(fmt::format("gather {} caustics {} bin {}", gather, caustics, bin));
                if (left >= kFrom + kRadius && right <= kTo - kRadius) {
                    for (int c = 0; c < 3; ++c) {
                        const double E =
                            kDirect * (1.0 + std::get<Mirror>(scene.materials[1]).reflectance[c]);
                        CHECK(zTest(film.pixels[bin], E, 0.0, c).within(kSweep));
                    }
                } else if (right <= kFrom - kRadius || left >= kTo + kRadius) {
                    CHECK(film.pixels[bin].mean.x == doctest::Approx(kDirect).epsilon(1e-12));
                }
            }
        }
    // All of its power lands on the floor, whatever the radius.
    const Problem problem{.index = index, .sensor = sensor, .maxDepth = 0};
    const auto estimator =
        kPhotonMapEstimator.make(problem, paramsOf(kPhotonMapEstimator, {{"photons", 500}, {"gather", 0}}));
    Statistics power;
    Counts counts;
    for (std::uint64_t pass = 0; pass < 400; ++pass) {
        Picture picture(80);
        estimator->addPass(pass, picture, counts);
        double sum = 0.0;
        for (std::size_t bin = 0; bin < 60; ++bin) sum += (picture[bin].x - kDirect) * kBin;
        power.add(Rgb(sum));
    }
    CHECK(zTest(power, 0.9 * kDirect * (kTo - kFrom)).within(kSingle));
    // Nothing else can meet a directional light, and shadow rays do not know of mirrors.
    const ShadedPoint inside = shadedPointOn(index, 0, ((kFrom + kTo) / 2.0 + 1.0) / 2.0);
    for (const EstimatorInfo* blind : {&kPathEstimator, &kCastRayEstimator}) {
        const Film film = runEstimator(*blind, index, Probe{inside}, {.maxDepth = 0, .passes = 1000});
        CHECK(film.pixels[0].mean.x == doctest::Approx(kDirect).epsilon(1e-12));
        CHECK(film.pixels[0].variance().x < 1e-20);
    }
}

TEST_CASE("photon map: a lamp in a mirror counts once, on a wall and off it") {
    Scene scene;
    addWall(scene, {-1.0, 0.0}, {1.0, 0.0}, Rgb(0.5));
    addWall(scene, {1.0, -9.0}, {1.0, 9.0});
    scene.materials[1] = Mirror{Rgb(0.7)};
    addWall(scene, {0.2, 1.0}, {-0.2, 1.0}, Rgb(0.0), Rgb(3.0));
    const SegmentIndex index(scene);
    const Segment lamp = scene.segments[2];
    Segment image = lamp;
    image.a = {2.0 - lamp.b.x, lamp.b.y};
    image.b = {2.0 - lamp.a.x, lamp.a.y};
    image.emission = lamp.emission * 0.7;
    const auto E = [&](Vec2 P) {
        const Vec2 up{0.0, 1.0};
        return segmentIrradiance(P, up, lamp).x + segmentIrradiance(P, up, image).x;
    };
    const Vec2 free{0.1, 0.3}, onFloor{0.5, 0.0};
    // Blurred: the image's light only.
    constexpr double kRadius = 0.1;
    const auto blurred = [&](double x) {
        return Integrals<1>{segmentIrradiance({x, 0.0}, {0.0, 1.0}, image).x / (2.0 * kRadius)};
    };
    const double onWall = segmentIrradiance(onFloor, {0.0, 1.0}, lamp).x +
                          integrate<1>(blurred, 0.5 - kRadius, 0.5 + kRadius, {1e-9}, 6)[0];
    // The floor's own light comes back to neither place, so scattering once changes nothing; rays that look
    // for it meet the lamp's image, though.
    for (const auto& [gather, depth] : {std::pair(0.0, 0u), {3.0, 0u}, {0.0, 1u}, {3.0, 1u}}) {
        const Ask ask{{{"photons", 200}, {"caustic-radius", kRadius}, {"gather", gather}}, depth, 4000};
        const Film off = runEstimator(kPhotonMapEstimator, index, Probe{{free, {0.0, 1.0}}}, ask);
        CHECK(zTest(off.pixels[0], E(free)).within(kSingle));
        const Film on = runEstimator(kPhotonMapEstimator, index, Probe{shadedPointOn(index, 0, 0.75)}, ask);
        CHECK(zTest(on.pixels[0], onWall).within(kSingle));
    }
}
