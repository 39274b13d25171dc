// Is the as-printed twin castRay itself to the bit while no defect is switched on?
#include <doctest/doctest.h>

#include "core/estimate.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

template <class Tracer>
Irradiance gatherBy(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                    std::uint64_t repeat, std::uint64_t& rays) {
    NoObserver observer;
    Tracer tracer{{index, settings, observer}};
    const Irradiance E =
        tracer.gatherLight(at, 0, Rng(settings.seed, repeat), SampleRange::all(settings.samples));
    rays = tracer.rays;
    return E;
}

void checkTwins(const Scene& scene, const ShadedPoint& at, const SegmentIndex& index) {
    for (const auto& sampler : kSamplers)
        for (const auto& emitters : kEmitters)
            for (std::uint32_t depth = 0; depth <= 2; ++depth)
                for (std::uint64_t repeat = 0; repeat < 3; ++repeat) {
                    CAPTURE(scene.title);
                    CAPTURE(sampler.name);
                    CAPTURE(emitters.name);
                    CAPTURE(depth);
                    Settings settings;
                    settings.samples = 6;
                    settings.maxDepth = depth;
                    settings.seed = 40 + repeat;
                    settings.sampler = sampler.value;
                    settings.emitters = emitters.value;
                    std::uint64_t rays = 0, printedRays = 0;
                    const Irradiance E = gatherBy<CastRay<>>(index, at, settings, repeat, rays);
                    const Irradiance printed =
                        gatherBy<AsPrinted<>>(index, at, settings, repeat, printedRays);
                    REQUIRE(E.direct == printed.direct);
                    REQUIRE(E.indirect == printed.indirect);
                    REQUIRE(rays == printedRays);
                }
}

}  // namespace

TEST_CASE("as printed: with no switch on it is castRay to the bit") {
    Scene mixed = mixedRoom(), closed = polygonRoom(furnacePolygon(), {0.7, 0.5, 0.2}, {0.3, 0.1, 0.0});
    mixed.title = "mixed";
    closed.title = "closed";
    closed.lights.emplace_back(PointLight{{1.0, 1.0}, Rgb(1.0)});
    for (const Scene& scene : {mixed, closed}) {
        const SegmentIndex index(scene);
        for (std::uint32_t wall = 0; wall < 3; ++wall)
            checkTwins(scene, shadedPointOn(index, wall, 0.43), index);
        checkTwins(scene, {{0.9, 0.8}, {0.6, 0.8}}, index);
        checkTwins(scene, {{0.2, 0.3}, {-1.0, 0.0}}, index);
    }
}

TEST_CASE("as printed: every switch changes what is computed") {
    // A tilted wall, so that the mirrored normal and the exact start of a ray matter too.
    Scene scene = polygonRoom(furnacePolygon(), Rgb(0.5), Rgb(0.1));
    scene.lights.emplace_back(PointLight{{1.0, 1.0}, Rgb(1.0)});
    const SegmentIndex index(scene);
    Settings settings;
    settings.samples = 16;
    settings.maxDepth = 2;
    for (const auto& defect : kDefects) {
        CAPTURE(defect.name);
        int changed = 0;
        for (int i = 0; i < 20; ++i) {  // only some rounded points lie behind their wall
            const ShadedPoint at = shadedPointOn(index, 3, (i + 0.5) / 20);
            std::uint64_t rays = 0;
            settings.defects = {};
            NoObserver observer;
            const Rgb right =
                gatherOnce(index, at, settings, 0, SampleRange::all(16), observer, rays).total();
            settings.defects.set(defect.value, true);
            changed +=
                gatherOnce(index, at, settings, 0, SampleRange::all(16), observer, rays).total() != right;
        }
        CHECK(changed > 0);
    }
}
