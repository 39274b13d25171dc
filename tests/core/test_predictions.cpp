// Does castRay vary as much as the quadrature predicts, in a room with everything in it?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "core/reference.h"
#include "measure.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("predictions: measured mean and variance are the predicted ones") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    for (const ShadedPoint& at :
         {shadedPointOn(index, 0, 0.4), shadedPointOn(index, 2, 0.7), ShadedPoint{{0.6, 1.0}, {0.6, 0.8}}})
        for (const Sampler sampler : {Sampler::uniform, Sampler::cosine}) {
            const ExactEstimate exact = halfDiskEstimate(visibility, at, sampler, 0);
            Settings settings;
            settings.samples = 5000;
            settings.maxDepth = 0;
            settings.sampler = sampler;
            settings.emitters = Emitters::hit;
            Statistics means, variances;
            for (std::uint64_t k = 0; k < 200; ++k) {
                const Estimate e = estimateIrradiance(index, at, settings, {.firstRepeat = k, .threads = 2});
                means.add(e.samples.mean);
                variances.add(e.samples.variance());
            }
            for (int c = 0; c < 3; ++c) {
                const ZTest mean = zTest(means, exact.mean[c], 1e-9, c),
                            variance = zTest(variances, exact.variance[c], 1e-9, c);
                INFO(fmt::format("{} channel {}", nameOf(kSamplers, sampler), c));
                CHECK_MESSAGE(mean.within(kSweep), mean.text());
                CHECK_MESSAGE(variance.within(kSweep), variance.text());
                CHECK(variance.standardError < 0.05 * variance.exact);
            }
        }
}

TEST_CASE("predictions: means at depths 0, 1 and 2 are those of the quadrature") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Reference reference(index, 2);
    for (std::uint32_t wall = 0; wall < 3; ++wall)
        for (std::uint32_t depth = 0; depth <= 2; ++depth)
            for (const auto& emitters : kEmitters) {
                const ShadedPoint at = shadedPointOn(index, wall, 0.37);
                const Rgb exact = reference.irradiance(at, depth);
                Settings settings;
                settings.maxDepth = depth;
                settings.emitters = emitters.value;
                const Estimate e = measure(index, at, settings, exact, {.rays = 2e6});
                for (int c = 0; c < 3; ++c) {
                    const ZTest test =
                        zTest(e.repeats, exact[c], depth < 2 ? 1e-7 * exact[c] : 1e-3 * exact[c], c);
                    INFO(fmt::format("wall {} depth {} {} channel {}", wall, depth, emitters.name, c));
                    CHECK_MESSAGE(test.within(kSweep), test.text());
                }
            }
}

TEST_CASE("predictions: one-bounce mean and variance, seen through many inner samples") {
    // halfDiskEstimate takes the walls' radiance as exact; castRay estimates it, which can only add variance.
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    const ExactEstimate exact = halfDiskEstimate(visibility, at, Sampler::uniform, 1);
    Settings settings;
    settings.samples = 200;
    settings.maxDepth = 1;
    settings.sampler =
        Sampler::stratified;  // inside, nearly without noise; outside, the slices are those of uniform
    settings.emitters = Emitters::hit;
    Statistics means, variances;
    for (std::uint64_t k = 0; k < 100; ++k) {
        const Estimate e = estimateIrradiance(index, at, settings, {.firstRepeat = k, .threads = 2});
        means.add(e.samples.mean);
        variances.add(e.samples.variance());
    }
    for (int c = 0; c < 3; ++c) {
        const ZTest mean = zTest(means, exact.mean[c], 1e-6 * exact.mean[c], c);
        CHECK_MESSAGE(mean.within(kSweep), mean.text());
        // One angle in each of 200 slices: the spread over the slices is the variance up to 1 / 200.
        CHECK(variances.mean[c] == doctest::Approx(exact.variance[c]).epsilon(0.02));
    }
}
