// Does castRay count its rays, its depth and its light as the conventions say? Where the answer has no
// variance.
#include <doctest/doctest.h>

#include "core/estimate.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Settings settingsOf(std::uint32_t samples, std::uint32_t maxDepth, Sampler sampler, Emitters emitters) {
    Settings settings;
    settings.samples = samples;
    settings.maxDepth = maxDepth;
    settings.sampler = sampler;
    settings.emitters = emitters;
    return settings;
}

Irradiance gather(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings,
                  std::uint64_t& rays) {
    NoObserver observer;
    return gatherOnce(index, at, settings, 0, SampleRange::all(settings.samples), observer, rays);
}

Irradiance gather(const SegmentIndex& index, const ShadedPoint& at, const Settings& settings) {
    std::uint64_t rays = 0;
    return gather(index, at, settings, rays);
}

/// Gives up after a number of samples.
struct Impatient : NoObserver {
    int left;
    bool keepGoing() { return left-- > 0; }
};

}  // namespace

TEST_CASE("castRay: 16 samples and three levels cost 16 + 256 + 4096 rays") {
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    std::uint64_t rays = 0;
    gather(index, shadedPointOn(index, 0, 0.5), settingsOf(16, 2, Sampler::uniform, Emitters::hit), rays);
    CHECK(rays == 16 + 256 + 4096);
}

TEST_CASE("castRay: one shadow ray for each light and half-disk, in a convex room") {
    Scene room = polygonRoom(regularPolygon(5));
    room.lights.emplace_back(PointLight{{0.1, 0.1}, Rgb(1.0)});
    const SegmentIndex index(room);
    std::uint64_t rays = 0;
    gather(index, shadedPointOn(index, 0, 0.5), settingsOf(8, 1, Sampler::uniform, Emitters::hit), rays);
    CHECK(rays == (1 + 8) + 8 * (1 + 8));
}

TEST_CASE("castRay: depth is E at D and L at D + 1") {
    // In a closed room where all walls are alike, cosine sampling has no variance: every ray returns L at
    // depth D, and every weight is 2. So E = 2 L_D to rounding.
    for (const double albedo : {0.0, 0.5, 1.0}) {
        const Scene room = polygonRoom(furnacePolygon(), Rgb(albedo), Rgb(0.3));
        const SegmentIndex index(room);
        double radiance = 0.0, power = 0.3;
        for (std::uint32_t depth = 0; depth <= 4; ++depth, power *= albedo) {
            radiance += power;
            const ShadedPoint at = shadedPointOn(index, 3, 0.37);
            const Irradiance E = gather(index, at, settingsOf(3, depth, Sampler::cosine, Emitters::hit));
            CHECK(E.total().x == doctest::Approx(2.0 * radiance).epsilon(1e-13));
            CHECK(E.direct.x == doctest::Approx(0.6).epsilon(1e-13));
            CHECK(outgoingRadiance(index, at, E.total()).x ==
                  doctest::Approx(0.3 + albedo * radiance).epsilon(1e-13));
        }
    }
}

TEST_CASE("castRay: a miss returns the environment, at any depth of the recursion") {
    Scene scene;
    scene.environment = Rgb(1.0, 2.0, 3.0);
    const SegmentIndex empty(scene);
    const ShadedPoint free = {{0.0, 0.0}, {0.6, 0.8}};
    const Irradiance E = gather(empty, free, settingsOf(4, 2, Sampler::cosine, Emitters::sample));
    CHECK(E.direct.x == doctest::Approx(2.0).epsilon(1e-14));
    CHECK(E.direct.z == doctest::Approx(6.0).epsilon(1e-14));
    CHECK(E.indirect == Rgb(0.0));
}

TEST_CASE("castRay: the back of a one-sided wall is black, a two-sided one scatters and emits there") {
    for (const bool twoSided : {false, true}) {
        Scene scene;
        scene.environment = Rgb(1.0);
        addWall(scene, {-1e9, 1.0}, {1e9, 1.0}, Rgb(0.5), Rgb(0.25), twoSided);  // faces up, away from P
        const SegmentIndex index(scene);
        const ShadedPoint below = {{0.0, 0.0}, {0.0, 1.0}};
        const Irradiance E = gather(index, below, settingsOf(8, 0, Sampler::cosine, Emitters::hit));
        CHECK(E.total().x == doctest::Approx(twoSided ? 0.5 : 0.0).epsilon(1e-6));
    }
}

TEST_CASE("castRay: delta lights give their closed form at depth 0") {
    Scene scene;
    addWall(scene, {-5.0, 0.0}, {5.0, 0.0}, {0.5, 0.25, 1.0});
    scene.lights.emplace_back(PointLight{{3.0, 4.0}, Rgb(10.0)});
    scene.lights.emplace_back(DirectionalLight{{0.6, -0.8}, {1.0, 2.0, 3.0}});
    scene.lights.emplace_back(DirectionalLight{{0.0, 1.0}, Rgb(7.0)});  // from below: shut out
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.5);
    const Irradiance E = gather(index, at, settingsOf(2, 0, Sampler::uniform, Emitters::sample));
    // I cos / r = 10 * 0.8 / 5, and E0 cos.
    CHECK(E.direct.x == doctest::Approx(1.6 + 0.8).epsilon(1e-12));
    CHECK(E.direct.z == doctest::Approx(1.6 + 2.4).epsilon(1e-12));
    CHECK(outgoingRadiance(index, at, E.total()).y == doctest::Approx(0.125 * (1.6 + 1.6)).epsilon(1e-12));
}

TEST_CASE("castRay: the mean over the samples one at a time is the whole") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    for (const auto& emitters : kEmitters) {
        const Settings settings = settingsOf(16, 1, Sampler::stratified, emitters.value);
        Rgb direct(0.0), indirect(0.0);
        for (std::uint32_t n = 0; n < 16; ++n) {
            NoObserver observer;
            std::uint64_t rays = 0;
            const Irradiance one = gatherOnce(index, at, settings, 0, {n, n + 1, 16}, observer, rays);
            direct += one.direct / 16.0;
            indirect += one.indirect / 16.0;
        }
        const Irradiance whole = gather(index, at, settings);
        for (int c = 0; c < 3; ++c) {
            CHECK(direct[c] == doctest::Approx(whole.direct[c]).epsilon(1e-13));
            CHECK(indirect[c] == doctest::Approx(whole.indirect[c]).epsilon(1e-13));
        }
    }
}

TEST_CASE("castRay: an observer that has enough stops the recursion") {
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    for (const int patience : {0, 5}) {
        Impatient observer{{}, patience};
        std::uint64_t rays = 0;
        gatherOnce(index, shadedPointOn(index, 0, 0.5), settingsOf(16, 2, Sampler::uniform, Emitters::hit), 0,
                   SampleRange::all(16), observer, rays);
        CHECK(rays == static_cast<std::uint64_t>(patience));
    }
}

TEST_CASE("castRay: another seed or repeat gives other numbers, the same one the same") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    Settings settings = settingsOf(8, 1, Sampler::uniform, Emitters::hit);
    const Rgb first = gather(index, at, settings).total();
    CHECK(gather(index, at, settings).total() == first);
    NoObserver observer;
    std::uint64_t rays = 0;
    CHECK(gatherOnce(index, at, settings, 1, SampleRange::all(8), observer, rays).total() != first);
    settings.seed = 2;
    CHECK(gather(index, at, settings).total() != first);
}
