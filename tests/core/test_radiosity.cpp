// Does radiosity find the light between diffuse walls, at every depth, and ever better with more patches?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstring>

#include "cases.h"
#include "core/estimators/all.h"
#include "core/radiosity.h"
#include "core/reference.h"
#include "rooms.h"
#include "run_estimator.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr std::optional<std::uint32_t> kEndless = std::nullopt;

/// Root mean square of the relative errors of all answers of a case; `bounces` empty: without limit.
double errorOf(const Case& known, std::uint32_t patches, std::optional<std::uint32_t> bounces) {
    const SegmentIndex index(known.scene);
    const Radiosity radiosity(index, patches, bounces);
    Counts counts;
    double sum = 0.0, count = 0.0;
    for (const Answer& answer : known.answers) {
        std::optional<Rgb> exact = answer.unlimited;
        if (bounces) exact = answer.valueAt(*bounces + (answer.query == "radiance" ? 1 : 0));
        REQUIRE(exact.has_value());
        const Rgb value = quantityOf(index, answer, radiosity.irradiance(pointOf(index, answer), counts));
        for (int c = 0; c < 3; ++c) {
            const double scale = (*exact)[c] > 0.0 ? (*exact)[c] : 1.0;
            sum += std::pow((value[c] - (*exact)[c]) / scale, 2.0);
            count += 1.0;
        }
    }
    return std::sqrt(sum / count);
}

std::string refusal(const Scene& scene, const Sensor& sensor, const ParamValues& params) {
    const SegmentIndex index(scene);
    return refusalOf(kRadiosityEstimator, {.index = index, .sensor = sensor}, params);
}

}  // namespace

TEST_CASE("radiosity: a closed room of one radiance, whatever the patches") {
    for (const double albedo : {0.0, 0.5, 0.99}) {
        const Scene scene = polygonRoom(furnacePolygon(), Rgb(albedo), Rgb(0.3));
        const SegmentIndex index(scene);
        Counts counts;
        for (const std::uint32_t patches : {1u, 37u, 300u}) {
            const ShadedPoint at = shadedPointOn(index, 2, 0.3);
            for (const std::uint32_t depth : {0u, 1u, 2u, 10u}) {
                const double L = closedRoomRadiance(0.3, albedo, static_cast<int>(depth));
                const Radiosity bounced(index, patches, depth);
                CHECK(bounced.irradiance(at, counts).y == doctest::Approx(2.0 * L).epsilon(1e-11));
            }
            const double L = closedRoomRadiance(0.3, albedo, kAnyDepth);
            const Radiosity solved(index, patches, kEndless);
            CHECK(solved.irradiance(at, counts).x == doctest::Approx(2.0 * L).epsilon(1e-10));
            CHECK(solved.fluence({1.0, 1.0}, counts).z == doctest::Approx(2.0 * kPi * L).epsilon(1e-10));
        }
    }
}

TEST_CASE("radiosity: exact cases, an error that falls with the square of a patch") {
    // Asked for at places of smooth light; the first power alone would give 2, the second gives 4.
    for (const char* name : {"09_cornell_rgb", "22_environment_box", "14_square_albedo_0.99"}) {
        const Case known = readCase(name);
        for (const std::optional<std::uint32_t> bounces : {std::optional(1u), std::optional(2u), {}}) {
            const double coarse = errorOf(known, 100, bounces), fine = errorOf(known, 400, bounces);
            INFO(fmt::format("{} bounces {}: {:.2e}, {:.2e}", name, bounces ? int(*bounces) : -1, coarse,
                             fine));
            CHECK(fine < coarse / 12.0);
            CHECK(fine < 2e-3);
        }
        CHECK(errorOf(known, 50, 0) < 1e-11);  // direct light needs no patches
    }
}

TEST_CASE("radiosity: a V-groove, also nearer to its corner than a patch is long") {
    const Case known = readCase("16_vgroove_60");
    CHECK(errorOf(known, 50, 1) < 1e-11);  // light that was scattered once is constant on both sides
    const double coarse = errorOf(known, 100, kEndless), fine = errorOf(known, 400, kEndless);
    INFO(fmt::format("{:.2e}, {:.2e}", coarse, fine));
    CHECK(fine < coarse / 3.0);
    CHECK(fine < 2e-3);
}

TEST_CASE("radiosity: every kind of light, at the depths of the reference") {
    Scene scene = mixedRoom();
    scene.environment.strip = {Rgb(1.0), Rgb(0.2), Rgb(3.0), Rgb(0.0), Rgb(1.0), Rgb(2.0), Rgb(0.5)};
    const SegmentIndex index(scene);
    const Reference reference(index, 3);
    for (std::uint32_t depth = 0; depth <= 3; ++depth) {
        const Radiosity coarse(index, 200, depth), fine(index, 800, depth);
        Counts counts;
        const std::vector<std::pair<std::uint32_t, double>> places{{0, 0.1}, {0, 0.45}, {0, 0.8},
                                                                   {1, 0.5}, {2, 0.5},  {3, 0.6}};
        for (const auto& place : places) {
            const auto wall = place.first;
            const double t = place.second;
            const ShadedPoint at = shadedPointOn(index, wall, t);
            const Rgb exact = reference.irradiance(at, depth), far = coarse.irradiance(at, counts),
                      near = fine.irradiance(at, counts);
            for (int c = 0; c < 3; ++c) {
                INFO(fmt::format("depth {} wall {} at {}: {:.8g} {:.8g} {:.8g}", depth, wall, t, far[c],
                                 near[c], exact[c]));
                // A quarter of the length: an error of the first power or better is below a third of the
                // difference of the two. The reference is good to 1e-3 beyond depth 1, and 1e-7 up to it.
                const double allowed =
                    std::abs(near[c] - far[c]) / 3.0 + (depth > 1 ? 1e-3 : 1e-7) * exact[c];
                CHECK(std::abs(near[c] - exact[c]) <= allowed);
                CHECK(std::abs(near[c] - exact[c]) <= 1e-3 * exact[c]);
            }
        }
    }
}

TEST_CASE("radiosity: all sensors of a furnace") {
    const Scene scene = polygonRoom(furnacePolygon(), Rgb(0.6), Rgb(1.0));
    const SegmentIndex index(scene);
    const double L = closedRoomRadiance(1.0, 0.6, 2), deeper = closedRoomRadiance(1.0, 0.6, 3);
    const Eye eye{.position = {1.0, 1.0}, .direction = {0.0, 1.0}, .fov = 1.0};
    const std::vector<std::pair<Sensor, double>> expected{
        {Probe{shadedPointOn(index, 0, 0.5)}, 2.0 * L},
        {Look{{1.0, 1.0}, {1.0, 0.0}}, deeper},
        {EyeStrip{eye, 8}, deeper},
        {Profile{{0, 1, 3}, 9}, 2.0 * L},
        {Field{{0.8, 0.8}, {1.4, 1.4}, 3, 2}, 2.0 * kPi * L}};
    for (const auto& [sensor, value] : expected) {
        const Film film = runEstimator(kRadiosityEstimator, index, sensor, {.maxDepth = 2, .passes = 3});
        REQUIRE(film.pixels.size() == pixelCount(sensor));
        for (const Statistics& pixel : film.pixels)
            CHECK(pixel.mean.x == doctest::Approx(value).epsilon(1e-10));
        CHECK(film.counts.nonFinite == 0);
    }
}

TEST_CASE("radiosity: what it cannot treat, it names") {
    Scene scene = polygonRoom(regularPolygon(4));
    const Sensor sensor = Probe{{{0.0, 0.0}, {0.0, 1.0}}};
    const ParamValues params = initialValues(kRadiosityEstimator);
    CHECK(refusal(scene, sensor, params).empty());

    scene.segmentNames[2] = "right";
    scene.segments[2].material = 1;
    const std::vector<std::pair<Material, std::string>> kinds{
        {Mirror{}, "a mirror"}, {Dielectric{}, "glass"}, {Glossy{}, "glossy"}, {Mix{}, "a mix"}};
    for (const auto& [material, kind] : kinds) {
        scene.materials.resize(1);
        scene.materials.push_back(material);
        CHECK(refusal(scene, sensor, params) == "radiosity treats diffuse walls only: \"right\" is " + kind);
    }
    scene.segments[2].material = 0;
    scene.segments[3].normalA = scene.segments[3].normalB = frontNormal(scene.segments[3]);
    CHECK(refusal(scene, sensor, params) == "radiosity treats diffuse walls only: \"wall.3\" is round");

    const Scene many = polygonRoom(regularPolygon(4001));
    CHECK(refusal(many, sensor, params) ==
          "radiosity needs a patch on each lit side of a wall: there are 4001, expected at most 4000");
    for (const double patches : {0.0, 4001.0, 2.5})
        CHECK_FALSE(refusal(scene, sensor, {patches, 0.0}).empty());
}

TEST_CASE("radiosity: light that never ends is bounced, not solved") {
    const Scene scene = polygonRoom(furnacePolygon(), Rgb(1.0), Rgb(1.0));
    const SegmentIndex index(scene);
    CHECK_THROWS_AS(Radiosity(index, 50, kEndless), std::invalid_argument);
    Counts counts;
    CHECK(Radiosity(index, 50, 64u).irradiance(shadedPointOn(index, 0, 0.5), counts).x ==
          doctest::Approx(2.0 * 65.0).epsilon(1e-10));
}

TEST_CASE("radiosity: the same bits on any number of threads") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Field field{{-1.5, 0.1}, {1.5, 1.8}, 8, 6};
    const auto run = [&](unsigned threads) {
        return runEstimator(kRadiosityEstimator, index, field,
                            {.params = {{"patches", 60}}, .maxDepth = 2, .passes = 40, .threads = threads});
    };
    const Film one = run(1);
    for (const unsigned threads : {2u, 3u}) {
        const Film more = run(threads);
        for (std::size_t i = 0; i < one.pixels.size(); ++i) {
            CHECK(std::memcmp(&one.pixels.mean[i], &more.pixels.mean[i], sizeof(Rgb)) == 0);
            CHECK(one.pixels[i].standardError() == more.pixels[i].standardError());
        }
        CHECK(one.counts.rays == more.counts.rays);
    }
}
