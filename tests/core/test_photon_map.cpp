// Does the photon map blur light exactly as its kernel says, and lose none of it? Its expectation is the mean
// over the kernel, known by quadrature.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "photon_kernel.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

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

TEST_CASE("photon map: no light leaks under a wall that stands on another") {
    // The box's left half, and beside it a dark one of the same size, behind a wall from floor to ceiling.
    const Scene left = litBox();
    Scene both = left;
    both.segments.resize(1);
    both.segmentNames.resize(1);
    const double height = left.segments[1].b.y;
    both.segments[0].b = {3.0, 0.0};
    addWall(both, {3.0, 0.0}, {3.0, height}, Rgb(0.5));
    addWall(both, {3.0, height}, {-1.0, height}, Rgb(0.5));
    addWall(both, {-1.0, height}, {-1.0, 0.0}, Rgb(0.5));
    addWall(both, {1.0, 0.0}, {1.0, height}, Rgb(0.5), Rgb(0.0), true);
    for (Segment& wall : both.segments) wall.material = 0;
    const SegmentIndex indexOfLeft(left), index(both);
    const Reference reference(indexOfLeft, 1);
    constexpr double kRadius = 0.2;
    const Ask ask{{{"photons", 1000}, {"radius", kRadius}, {"gather", 0}}, 1, 400};
    for (const double gap : {0.001, 0.1, 0.19}) {
        INFO(fmt::format("{} m off the wall", gap));
        const Statistics dark = indirectPasses(index, shadedPointOn(index, 0, (2.0 + gap) / 4.0), ask);
        CHECK(dark.mean == Rgb(0.0));
        CHECK(dark.squares == Rgb(0.0));
        // On the lit side all is as if the floor ended there.
        const Statistics lit = indirectPasses(index, shadedPointOn(index, 0, (2.0 - gap) / 4.0), ask);
        const Rgb mean = kernelMean(indexOfLeft, reference, 0, (2.0 - gap) / 2.0, kRadius, 1);
        const ZTest test = zTest(lit, mean.x, 1e-7 * mean.x);
        CHECK_MESSAGE(test.within(kSingle), test.text());
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
