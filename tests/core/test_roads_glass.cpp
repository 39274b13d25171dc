// Does light go through glass as Snell, Fresnel and Beer say?
#include <doctest/doctest.h>

#include <cmath>

#include "caustic.h"
#include "roads.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("roads: the sun through a slab") {
    const double degrees[] = {0.0, 30.0, 60.0};
    const double refractionOnly[] = {0.9216, 0.79559924498325, 0.4147904220680195};
    const double total[] = {0.923076923076923, 0.7969733293886283, 0.41811623135508424};
    for (int i = 0; i < 3; ++i) {
        Scene scene;
        scene.materials = {Dielectric{1.5, Rgb(0.0)}, Diffuse{Rgb(0.0)}};
        scene.segments = {wallOf({-50, 1}, {-50, 1.5}, 0), wallOf({-50, 1.5}, {50, 1.5}, 0),
                          wallOf({50, 1.5}, {50, 1}, 0), wallOf({50, 1}, {-50, 1}, 0),
                          wallOf({-60, 0}, {60, 0}, 1)};
        const double angle = degrees[i] * kPi / 180.0;
        scene.lights.push_back(DirectionalLight{{std::sin(angle), -std::cos(angle)}, Rgb(1.0)});
        Stage stage = staged("slab", scene);
        prepare(stage);
        // 0 ... 30 m: far from the slab's ends.
        const Sensor floor = Profile{{4}, 4};
        for (const std::string id : {"light", "bidirectional"}) {
            INFO(id << " at " << degrees[i] << " degrees");
            Run run{.id = id, .maxDepth = 0, .samples = 360'000, .threads = 2};
            checkValue(measure(stage, floor, run), 2, total[i], 1e-12);
            run.maxSpecular = 2;
            checkValue(measure(stage, floor, run), 2, refractionOnly[i], 1e-12);
        }
    }
}

TEST_CASE("roads: tinted glass, straight through a slab") {
    Scene scene;
    scene.materials = {Dielectric{1.5, Rgb(0.3, 1.0, 4.0)}};
    scene.segments = {wallOf({-9, 0}, {-9, 0.5}, 0), wallOf({-9, 0.5}, {9, 0.5}, 0),
                      wallOf({9, 0.5}, {9, 0}, 0), wallOf({9, 0}, {-9, 0}, 0)};
    scene.environment.radiance = Rgb(1.0);
    // Bright below only, so that what the slab reflects does not count.
    scene.environment.strip = {Rgb(0.0), Rgb(0.0), Rgb(1.0), Rgb(1.0)};
    Stage stage = staged("tinted", scene);
    prepare(stage);
    const double F = 0.04;
    for (const std::string id : {"path", "cast-ray", "bidirectional"}) {
        const Film film = measure(stage, Look{{0.1, 2.0}, {0.0, -1.0}},
                                  {.id = id, .maxDepth = 0, .samples = 200'000, .threads = 2});
        for (int c = 0; c < 3; ++c) {
            // All orders of inner reflection: (1 - F)^2 k / (1 - F^2 k^2).
            const double k = std::exp(-0.5 * Rgb(0.3, 1.0, 4.0)[c]);
            INFO(id << " channel " << c);
            CHECK(
                zTest(film.pixels[0], (1 - F) * (1 - F) * k / (1 - F * F * k * k), 1e-9, c).within(kSingle));
        }
    }
}

TEST_CASE("roads: a point in absorbing glass loses light on the way to it, by every estimator") {
    // A disk of index 1 and absorption 1/m about the point: what arrives has run one metre in it.
    CausticSetup setup;
    setup.ior = 1.0;
    Scene scene = causticScene(setup, 256, true);
    scene.segments.pop_back();
    scene.segmentNames.pop_back();
    scene.lights.clear();
    scene.materials[0] = Dielectric{1.0, Rgb(1.0)};
    scene.environment = Rgb(1.0);
    Stage sky = staged("tinted disk", scene);
    scene.environment = Rgb(0.0);
    scene.lights = {PointLight{{0.5, setup.height}, Rgb(1.0)}};
    Stage bulb = staged("bulb in the disk", scene);
    prepare(sky);
    prepare(bulb);
    const Vec2 middle(0.0, setup.height);
    const auto probed = [&](const Stage& stage, Vec2 normal) {
        return Probe{*shadedPointAt(*stage.index, middle, normal)};
    };
    const EstimateOptions options{.repeats = 400};
    for (const std::string id : {"cast-ray", "path"}) {
        INFO(id);
        // 256 facets are nearer than the circle by one part in 20 000 on average.
        CHECK(
            zTest(measure(sky, probed(sky, {0, 1}), {.id = id, .maxDepth = 0, .samples = 100'000}).pixels[0],
                  2.0 / std::exp(1.0), 1e-4)
                .within(kSingle));
        CHECK(
            measure(bulb, probed(bulb, {1, 0}), {.id = id, .maxDepth = 0, .samples = 100}).pixels[0].mean.x ==
            doctest::Approx(2.0 * std::exp(-0.5)));
    }
    Settings settings;
    settings.maxDepth = 0;
    const Estimate probe = estimateIrradiance(*sky.index, probed(sky, {0, 1}).at, settings, options);
    CHECK(zTest(probe.repeats, 2.0 / std::exp(1.0), 1e-4).within(kSingle));
}

TEST_CASE("roads: a glass disk under an even sky shows the sky") {
    CausticSetup setup;
    Scene scene = causticScene(setup, 256, true);
    scene.segments.pop_back();
    scene.segmentNames.pop_back();
    scene.lights.clear();
    scene.environment = Rgb(1.0);
    Stage stage = staged("furnace", scene);
    prepare(stage);
    const Vec2 middle(0.0, setup.height);
    for (const std::string id : {"path", "cast-ray", "bidirectional"}) {
        INFO(id);
        const Film outside =
            measure(stage, Look{middle + Vec2(0.6, 5.0), {0.0, -1.0}}, {.id = id, .samples = 20'000});
        CHECK(outside.pixels[0].mean.x == doctest::Approx(1.0).epsilon(1e-12));
        const Sensor within = Look{middle + Vec2(0.1, 0.2), {0.6, 0.8}};
        // Within, radiance is larger by the index.
        CHECK(measure(stage, within, {.id = id, .samples = 20'000}).pixels[0].mean.x ==
              doctest::Approx(1.5).epsilon(1e-12));
        checkValue(measure(stage, within, {.id = id, .maxSpecular = 1, .samples = 100'000}), 0,
                   1.4399996815460228, 1e-4, 0.005);
    }
    // Reflected and once refracted light alone; the facets' error is below 1e-4 at 256.
    checkValue(measure(stage, Look{middle + Vec2(0.6, 5.0), {0.0, -1.0}},
                       {.id = "path", .maxSpecular = 2, .samples = 200'000}),
               0, 0.04389473600344824 + 0.9141372758419158, 1e-4, 0.005);
}
