// Is an estimate the same on any number of threads, cheap to stop, and honest about its cost?
#include <doctest/doctest.h>

#include <thread>

#include "core/estimate.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

bool sameBits(const Statistics& a, const Statistics& b) {
    return a.count == b.count && a.nonFinite == b.nonFinite && a.negative == b.negative && a.mean == b.mean &&
           a.squares == b.squares;
}

bool sameBits(const Estimate& a, const Estimate& b) {
    return sameBits(a.repeats, b.repeats) && sameBits(a.samples, b.samples) && a.direct == b.direct &&
           a.indirect == b.indirect && a.rays == b.rays;
}

Settings settingsOf(std::uint32_t samples, std::uint32_t maxDepth, Emitters emitters = Emitters::sample) {
    Settings settings;
    settings.samples = samples;
    settings.maxDepth = maxDepth;
    settings.emitters = emitters;
    return settings;
}

}  // namespace

TEST_CASE("estimate: the same bits on 1, 2, 3 and 8 threads") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    struct Size {
        std::uint32_t samples;
        std::uint64_t repeats;
    };
    for (const Size size : {Size{1, 5000}, Size{4, 3000}, Size{64, 100}, Size{1023, 5}, Size{1024, 5},
                            Size{1025, 5}, Size{5000, 7}, Size{700, 9}})
        for (const auto& sampler : kSamplers) {
            Settings settings = settingsOf(size.samples, size.samples > 100 ? 0 : 1);
            settings.sampler = sampler.value;
            const Estimate one =
                estimateIrradiance(index, at, settings, {.repeats = size.repeats, .threads = 1});
            CHECK(one.repeats.count == size.repeats);
            CHECK(one.samples.count == size.repeats * size.samples);
            for (const unsigned threads : {2u, 3u, 8u})
                CHECK(sameBits(one, estimateIrradiance(index, at, settings,
                                                       {.repeats = size.repeats, .threads = threads})));
        }
}

TEST_CASE("estimate: its means are those of the single runs") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    for (const std::uint32_t samples : {3u, 1500u}) {
        const Settings settings = settingsOf(samples, 0, Emitters::both);
        Statistics means;
        Rgb direct(0.0), indirect(0.0);
        for (std::uint64_t repeat = 0; repeat < 6; ++repeat) {
            NoObserver observer;
            std::uint64_t rays = 0;
            const Irradiance E =
                gatherOnce(index, at, settings, 4 + repeat, SampleRange::all(samples), observer, rays);
            means.add(E.total());
            direct += E.direct / 6.0;
            indirect += E.indirect / 6.0;
        }
        const Estimate estimate = estimateIrradiance(index, at, settings, {.firstRepeat = 4, .repeats = 6});
        CHECK(estimate.repeats.mean.x == doctest::Approx(means.mean.x).epsilon(1e-12));
        CHECK(estimate.repeats.variance().x == doctest::Approx(means.variance().x).epsilon(1e-9));
        CHECK(estimate.irradiance().y == doctest::Approx(means.mean.y).epsilon(1e-12));
        CHECK(estimate.direct.z == doctest::Approx(direct.z).epsilon(1e-12));
        CHECK(estimate.indirect.z == doctest::Approx(indirect.z).epsilon(1e-12));
        CHECK((estimate.direct + estimate.indirect).x ==
              doctest::Approx(estimate.irradiance().x).epsilon(1e-12));
    }
}

TEST_CASE("estimate: two halves of the repeats make the whole") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    const Settings settings = settingsOf(5, 1);
    const Estimate whole = estimateIrradiance(index, at, settings, {.repeats = 100});
    const Estimate first = estimateIrradiance(index, at, settings, {.repeats = 40});
    const Estimate second = estimateIrradiance(index, at, settings, {.firstRepeat = 40, .repeats = 60});
    Statistics both = first.repeats;
    both.merge(second.repeats);
    CHECK(both.count == whole.repeats.count);
    CHECK(both.mean.x == doctest::Approx(whole.repeats.mean.x).epsilon(1e-13));
    CHECK(both.variance().x == doctest::Approx(whole.repeats.variance().x).epsilon(1e-12));
    CHECK(first.rays + second.rays == whole.rays);
    CHECK(first.irradiance() != second.irradiance());
}

TEST_CASE("estimate: stops when cancelled, before or during the work") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    for (const unsigned threads : {1u, 3u}) {
        std::atomic<bool> cancelled = true;
        const EstimateOptions options = {
            .repeats = 1'000'000'000, .threads = threads, .cancelled = &cancelled};
        CHECK(estimateIrradiance(index, at, settingsOf(16, 2), options).rays == 0);
        cancelled = false;
        Estimate estimate;  // would take years; this test ends only if the flag is heard
        std::thread worker(
            [&] { estimate = estimateIrradiance(index, at, settingsOf(100'000, 5), options); });
        cancelled = true;
        worker.join();
        CHECK(estimate.repeats.count < options.repeats);
    }
}

TEST_CASE("estimate: a flag that stays down changes no bit") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    const std::atomic<bool> cancelled = false;
    CHECK(sameBits(estimateIrradiance(index, at, settingsOf(8, 1), {.repeats = 50}),
                   estimateIrradiance(index, at, settingsOf(8, 1),
                                      {.repeats = 50, .threads = 2, .cancelled = &cancelled})));
}

TEST_CASE("estimate: raysPerRepeat is never exceeded, and reached in closed rooms") {
    for (const auto& emitters : kEmitters)
        for (std::uint32_t depth = 0; depth <= 2; ++depth)
            for (const std::uint32_t samples : {1u, 4u, 9u}) {
                CAPTURE(emitters.name);
                CAPTURE(depth);
                CAPTURE(samples);
                const Settings settings = settingsOf(samples, depth, emitters.value);
                const Scene mixed = mixedRoom();
                const SegmentIndex open(mixed);
                const Estimate some =
                    estimateIrradiance(open, shadedPointOn(open, 0, 0.4), settings, {.repeats = 10});
                CHECK(static_cast<double>(some.rays) <= 10.0 * raysPerRepeat(open, settings));
                // Convex, so that every wall faces the point light.
                Scene room = polygonRoom(regularPolygon(5));
                room.lights.emplace_back(PointLight{{0.1, 0.1}, Rgb(1.0)});
                const SegmentIndex closed(room);
                const Estimate all =
                    estimateIrradiance(closed, shadedPointOn(closed, 0, 0.4), settings, {.repeats = 10});
                CHECK(static_cast<double>(all.rays) == 10.0 * raysPerRepeat(closed, settings));
            }
}

TEST_CASE("estimate: absurd requests have a finite or infinite cost, never a wrong one") {
    const Scene room = polygonRoom(regularPolygon(5));
    const SegmentIndex index(room);
    CHECK(raysPerRepeat(index, settingsOf(1'000'000'000, 64)) > 1e300);
    CHECK(raysPerRepeat(index, settingsOf(16, 2)) == 4368.0);
}

TEST_CASE("estimate: the shaded point of a probe") {
    Scene scene;
    addWall(scene, {0.0, 0.0}, {4.0, 0.0}, Rgb(0.25));
    const SegmentIndex index(scene);
    const auto onWall = shadedPointAt(index, {1.0, 0.0}, std::nullopt);
    REQUIRE(onWall);
    CHECK(onWall->segment == 0);
    CHECK(onWall->N == Vec2(0.0, 1.0));
    CHECK(onWall->albedo == Rgb(0.25));
    CHECK_FALSE(shadedPointAt(index, {1.0, 0.5}, std::nullopt));
    const auto free = shadedPointAt(index, {1.0, 0.5}, Vec2(3.0, 4.0));
    REQUIRE(free);
    CHECK(free->segment == kNoSegment);
    CHECK(glm::length(free->N - Vec2(0.6, 0.8)) < 1e-15);
    // A tilted half-disk on a wall stands on its side, and the wall blocks what is below.
    scene.environment = Rgb(1.0);
    const auto tilted = shadedPointAt(index, {2.0, 0.0}, Vec2(0.6, 0.8));
    REQUIRE(tilted);
    CHECK(tilted->P.y > 0.0);
    Settings settings = settingsOf(1 << 16, 0);
    settings.sampler = Sampler::stratified;
    // Sees the directions above the ground: 1 + cos of the tilt, cos = 0.8.
    const Estimate E = estimateIrradiance(index, *tilted, settings);
    CHECK(E.irradiance().x == doctest::Approx(1.8).epsilon(1e-3));
    const auto back = shadedPointAt(index, {2.0, 0.0}, Vec2(0.0, -1.0));
    REQUIRE(back);
    CHECK(estimateIrradiance(index, *back, settings).irradiance().x == doctest::Approx(2.0).epsilon(1e-3));
}
