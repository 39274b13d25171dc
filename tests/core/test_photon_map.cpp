// Does the photon map blur light exactly as its kernel says, and lose none of it? Its expectation is the mean
// over the kernel, known by quadrature.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "photon_kernel.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// A matt box with a point light: direct light is the same in every pass, so all noise is the photons'.
Scene litBox() {
    Scene scene = polygonRoom({{-1.0, 0.0}, {1.0, 0.0}, {1.0, 1.5}, {-1.0, 1.5}}, {0.7, 0.5, 0.3});
    scene.lights.emplace_back(PointLight{{0.3, 1.1}, {1.0, 0.8, 0.6}});
    return scene;
}

}  // namespace

TEST_CASE("photon map: expects the mean over its kernel, at a wall's end too, and 5 % less is rejected") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const Reference reference(index, 2);
    for (const unsigned depth : {1u, 2u})
        for (const double t : {0.5, 0.04}) {
            const ShadedPoint at = shadedPointOn(index, 0, t);
            const Rgb mean = kernelMean(index, reference, 0, t, 0.2, depth);
            const Ask ask{{{"photons", 1000}, {"radius", 0.2}, {"gather", 0}}, depth, 400};
            const Statistics right = indirectPasses(index, at, ask);
            // As if the kernel were 5 % longer than what the photons were counted in.
            const Statistics wrong = indirectPasses(index, at, ask, 1.0 / 1.05);
            for (int c = 0; c < 3; ++c) {
                // The quadrature itself is exact to 1e-8 at depth 1 and to 1e-3 beyond.
                const double err = (depth == 1 ? 1e-7 : 1e-3) * mean[c];
                const ZTest test = zTest(right, mean[c], err, c);
                INFO(fmt::format("depth {} t {}: {}", depth, t, test.text()));
                CHECK(test.within(kSingle));
                CHECK_FALSE(zTest(wrong, mean[c], err, c).within(kSingle));
            }
        }
}

TEST_CASE("photon map: gathered light is the blurred light of the walls that are seen") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const Reference reference(index, 0);
    constexpr double kRadius = 0.15;
    const ShadedPoint at = shadedPointOn(index, 0, 0.3);
    const Frame frame = frameFromNormal(at.N);
    const auto arriving = [&](double theta) {
        const Ray ray = rayFrom(index, at, frame.toWorld(std::cos(theta), std::sin(theta)));
        const Hit hit = index.closestHit(ray);
        const Rgb E = kernelMean(index, reference, hit.segment, hit.u, kRadius, 0, false);
        const Rgb L = E * std::get<Diffuse>(index.material(hit.segment)).albedo / 2.0 * std::sin(theta);
        return Integrals<3>{L.x, L.y, L.z};
    };
    const Visibility visibility(index);
    const Integrals<3> parts = integrateOver<3>(visibility.arcs(at), arriving, 1e-5, 6);
    const Rgb sum(parts[0], parts[1], parts[2]);
    const Ask ask{{{"photons", 500}, {"radius", kRadius}, {"gather", 8}}, 1, 1500};
    const Statistics probe = indirectPasses(index, at, ask);
    // The same light, seen by an eye: the wall's albedo / 2 times all that arrives.
    const Vec2 from{0.5, 1.2};
    const Film look = runEstimator(kPhotonMapEstimator, index, Look{from, glm::normalize(at.P - from)}, ask);
    const Rgb direct = deltaIrradiance(index, at);
    for (int c = 0; c < 3; ++c) {
        const ZTest test = zTest(probe, sum[c], 1e-4 * sum[c], c);
        INFO(test.text());
        CHECK(test.within(kSingle));
        const double half = std::get<Diffuse>(scene.materials[0]).albedo[c] / 2.0;
        const ZTest seen = zTest(look.pixels[0], half * (direct[c] + sum[c]), 1e-4 * half * sum[c], c);
        INFO(seen.text());
        CHECK(seen.within(kSingle));
    }
}

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

TEST_CASE("photon map: a glossy wall sends on the mean of its kernel, by each photon's direction") {
    Scene scene = litBox();
    scene.materials.push_back(Glossy{{0.9, 0.6, 0.3}, 12.0});
    scene.segments[0].material = 1;
    const SegmentIndex index(scene);
    const Vec2 toFloor = glm::normalize(Vec2(0.7, -0.7));
    constexpr double kRadius = 0.25, kMiddle = 0.1;
    const auto lookAt = [&](double x) { return Look{Vec2(x, 0.0) - toFloor * 0.9, toFloor}; };
    const auto path = [&](double x, std::uint32_t depth, std::uint64_t passes) {
        return runEstimator(kPathEstimator, index, lookAt(x), {.maxDepth = depth, .passes = passes})
            .pixels[0];
    };
    // At depth 0 the wall sends on what comes straight from the light: the same in every pass.
    double mean = path(kMiddle, 0, 1).mean.x, square = 0.0;
    for (const GaussPoint& point : kGauss8) {
        const double x = kMiddle + kRadius * point.x;
        const Statistics all = path(x, 1, 20000);
        mean += point.weight / 2.0 * (all.mean.x - path(x, 0, 1).mean.x);
        square += std::pow(point.weight / 2.0 * all.standardError().x, 2);
    }
    const Film film = runEstimator(kPhotonMapEstimator, index, lookAt(kMiddle),
                                   {{{"photons", 1000}, {"radius", kRadius}, {"gather", 0}}, 1, 300});
    const double error = std::hypot(film.pixels[0].standardError().x, std::sqrt(square));
    INFO(fmt::format("{} +- {}, expected {}", film.pixels[0].mean.x, error, mean));
    CHECK(error < 0.01 * mean);
    CHECK(std::abs(film.pixels[0].mean.x - mean) <= kSingle * error);
}

TEST_CASE("photon map: the same bits on any number of threads") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const auto run = [&](unsigned threads) {
        return runEstimator(kPhotonMapEstimator, index, Profile{{0, 3}, 1500},
                            {{{"photons", 300}, {"shrink", 0.7}}, 1, 9, 3, threads});
    };
    const Film one = run(1);
    for (const unsigned threads : {2u, 3u}) {
        const Film more = run(threads);
        for (std::size_t i = 0; i < one.pixels.size(); ++i) {
            REQUIRE(one.pixels[i].mean == more.pixels[i].mean);
            REQUIRE(one.pixels[i].squares == more.pixels[i].squares);
        }
    }
}

TEST_CASE("photon map: refuses what it can't do before it starts") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const Sensor sensor = Probe{shadedPointOn(index, 0, 0.5)};
    const auto refused = [&](std::string_view name, double value, std::uint32_t depth = 1) {
        const Problem problem{.index = index, .sensor = sensor, .maxDepth = depth};
        return refusalOf(kPhotonMapEstimator, problem, paramsOf(kPhotonMapEstimator, {{name, value}}));
    };
    CHECK(refused("photons", 0) == "photons is 0, expected a whole number from 1 to 1e+07");
    CHECK(refused("photons", 1e12).starts_with("photons is 1e+12, expected"));
    CHECK(refused("radius", 0).starts_with("radius is 0, expected a number from"));
    CHECK(refused("shrink", 0).starts_with("shrink is 0, expected"));
    CHECK(refused("photons", 1e7, 1).empty());
    CHECK(refused("photons", 1e7, 2).find("lower photons") != std::string::npos);
}
