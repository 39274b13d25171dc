// Where would a bias hide? Albedo 1, many bounces, lights close to walls, coordinates far from the origin.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "cases.h"
#include "measure.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Settings settingsOf(Sampler sampler, Emitters emitters, std::uint32_t maxDepth) {
    Settings settings;
    settings.sampler = sampler;
    settings.emitters = emitters;
    settings.maxDepth = maxDepth;
    settings.seed = 77;
    return settings;
}

/// scale * p + offset for the whole scene. Radiance and irradiance stay as they are, but for point lights.
Case moved(Case known, const Placing& placing) {
    const auto& [scale, offset] = placing;
    for (Segment& s : known.scene.segments) {
        s.a = scale * s.a + offset;
        s.b = scale * s.b + offset;
    }
    for (Answer& answer : known.answers) answer.at = scale * answer.at + offset;
    return known;
}

}  // namespace

TEST_CASE("bias: closed rooms of every albedo, up to depth 6") {
    // L at depth d is Le (1 - albedo^(d+1)) / (1 - albedo), and with albedo 1 it grows by Le at every bounce:
    // nothing fades.
    for (const double albedo : {0.0, 0.5, 0.99, 1.0})
        for (const std::uint32_t depth : {1u, 3u, 6u})
            for (const auto& sampler : kSamplers)
                for (const Emitters emitters : {Emitters::hit, Emitters::both}) {
                    INFO(fmt::format("albedo {} depth {} {} {}", albedo, depth, sampler.name,
                                     nameOf(kEmitters, emitters)));
                    const Scene room = polygonRoom(furnacePolygon(), Rgb(albedo), Rgb(0.3));
                    const SegmentIndex index(room);
                    double radiance = 0.0;
                    for (std::uint32_t k = 0; k <= depth; ++k) radiance += 0.3 * std::pow(albedo, k);
                    const Effort effort = {.rays = 1e6, .samplesPerBounce = depth > 3 ? 1u : 2u};
                    const Estimate e =
                        measure(index, shadedPointOn(index, 3, 0.37),
                                settingsOf(sampler.value, emitters, depth), Rgb(2.0 * radiance), effort);
                    const ZTest test = zTest(e.repeats, 2.0 * radiance);
                    CHECK_MESSAGE(test.within(kSweep), test.text());
                    CHECK(test.standardError <= 0.005 * test.exact);
                }
}

TEST_CASE("bias: a point light close to the floor, seen from the ceiling") {
    // The floor's irradiance is the narrow peak h / (x^2 + h^2). What the ceiling at height 1 gets from there
    // is the integral of (1/2) h / (x^2 + h^2) (1 + x^2)^(-3/2) over x; with x = h tan(phi) it is smooth.
    for (const double h : {0.1, 0.01}) {
        Scene scene;
        addWall(scene, {-20.0, 0.0}, {20.0, 0.0}, Rgb(1.0));
        const std::uint32_t ceiling = addWall(scene, {20.0, 1.0}, {-20.0, 1.0}, Rgb(0.0));
        scene.lights.emplace_back(PointLight{{0.0, h}, Rgb(1.0)});
        const SegmentIndex index(scene);
        const double end = std::atan(20.0 / h);
        constexpr int kPanels = 200'000;
        double indirect = 0.0;
        for (int i = 0; i < kPanels; ++i) {
            const double x = h * std::tan(end * (2.0 * (i + 0.5) / kPanels - 1.0));
            indirect += 0.5 * std::pow(1.0 + x * x, -1.5) * 2.0 * end / kPanels;
        }
        const double direct = 1.0 / (1.0 - h);
        for (const auto& sampler : kSamplers) {
            INFO(fmt::format("h {} {}", h, sampler.name));
            const Estimate e =
                measure(index, shadedPointOn(index, ceiling, 0.5),
                        settingsOf(sampler.value, Emitters::sample, 1), Rgb(direct + indirect));
            const ZTest test = zTest(e.repeats, direct + indirect);
            CHECK_MESSAGE(test.within(kSweep), test.text());
            CHECK(test.standardError <= 0.005 * test.exact);
            CHECK(e.direct.x == doctest::Approx(direct).epsilon(1e-12));
        }
    }
}

TEST_CASE("bias: scenes far from the origin, very small and very large") {
    for (const char* name :
         {"01_segment_light", "03_occluded_light", "05_white_furnace", "16_vgroove_60", "22_environment_box"})
        for (const Placing& placing :
             {Placing{1.0, Vec2(1e6, -1e6)}, {1e-6, Vec2(0.0)}, {1e6, Vec2(1e5, 1e7)}}) {
            const Case known = moved(readCase(name), placing);
            const SegmentIndex index(known.scene);
            for (const Answer& answer : known.answers) {
                const auto exact = answer.valueAt(1);
                if (!exact) continue;
                const auto depth = *depthSetting(answer, 1);
                const double slope =
                    quantityOf(index, answer, Rgb(1.0)).x - quantityOf(index, answer, Rgb(0.0)).x;
                for (const Emitters emitters : {Emitters::sample, Emitters::hit, Emitters::both}) {
                    INFO(fmt::format("{} x {} + {} {}", name, placing.scale, placing.offset.x,
                                     nameOf(kEmitters, emitters)));
                    const Estimate e =
                        measure(index, pointOf(index, answer), settingsOf(Sampler::cosine, emitters, depth),
                                *exact / slope, {.rays = 1e6});
                    const ZTest test{quantityOf(index, answer, e.repeats.mean).x,
                                     slope * e.repeats.standardError().x, exact->x,
                                     std::max(answer.err, 1e-8)};  // vertices round at these offsets
                    CHECK_MESSAGE(test.within(kSweep), test.text());
                    CHECK(e.nonFinite() == 0);
                }
            }
        }
}

TEST_CASE("bias: sampling, meeting and both agree where no closed form is at hand") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    for (std::uint32_t wall = 0; wall < 3; ++wall) {
        std::vector<Statistics> results;
        for (const auto& emitters : kEmitters)
            for (const auto& sampler : kSamplers) {
                const Settings settings = settingsOf(sampler.value, emitters.value, 2);
                results.push_back(
                    measure(index, shadedPointOn(index, wall, 0.37), settings, Rgb(1.0), {.rays = 2e6})
                        .repeats);
            }
        for (const Statistics& a : results)
            for (int c = 0; c < 3; ++c) {
                const double error = std::hypot(a.standardError()[c], results.front().standardError()[c]);
                const ZTest test{a.mean[c], error, results.front().mean[c], 0.0};
                CHECK_MESSAGE(test.within(kSweep), test.text());
            }
    }
}

TEST_CASE("bias: a lamp that lies on a wall, and comes first, shines however it is counted") {
    // Of coincident walls the lower index is met: the lamp. Shadow rays must see it that way too.
    for (const double tilt : {0.0, 0.3}) {
        const Vec2 along = {std::cos(tilt), std::sin(tilt)}, up = perp(along);
        Scene scene;
        const std::uint32_t floor = addWall(scene, -3.0 * along, 3.0 * along);
        addWall(scene, 2.0 * up + along, 2.0 * up - along, Rgb(0.0), Rgb(1.0));
        addWall(scene, 2.0 * up + along, 2.0 * up - along, Rgb(0.5));
        const SegmentIndex index(scene);
        const double exact = 2.0 / std::sqrt(5.0);  // Le (sin beta - sin alpha), tan = 1 / 2
        for (const auto& emitters : kEmitters) {
            INFO(fmt::format("tilt {} {}", tilt, emitters.name));
            const Estimate e = measure(index, shadedPointOn(index, floor, 0.5),
                                       settingsOf(Sampler::cosine, emitters.value, 0), Rgb(exact));
            const ZTest test = zTest(e.repeats, exact);
            CHECK_MESSAGE(test.within(kSweep), test.text());
        }
    }
}
