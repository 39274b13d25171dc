// Does the quadrature of many bounces give the tabulated radiosities?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <stdexcept>

#include "cases.h"
#include "core/reference.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("reference: equals the tabulated cases at depths 0 to 3") {
    for (const char* name : {"01_segment_light", "03_occluded_light", "05_white_furnace", "09_cornell_rgb",
                             "14_square_albedo_0.99", "16_vgroove_60", "22_environment_box"}) {
        const Case known = readCase(name);
        const SegmentIndex index(known.scene);
        const Reference reference(index, 2);
        REQUIRE(reference.ready());
        for (const Answer& answer : known.answers)
            for (std::size_t depth = 0; depth <= 3; ++depth) {
                const auto setting = depthSetting(answer, depth);
                if (!setting || *setting > 2 || !answer.valueAt(depth)) continue;
                const Rgb exact = *answer.valueAt(depth);
                const Rgb value =
                    quantityOf(index, answer, reference.irradiance(pointOf(index, answer), *setting));
                // As its own description promises.
                const double relative = *setting == 0 ? 1e-11 : *setting == 1 ? 1e-7 : 1e-3;
                for (int c = 0; c < 3; ++c) {
                    INFO(fmt::format("{} depth {}: {:.12g}, exact {:.12g}", name, depth, value[c], exact[c]));
                    CHECK(std::abs(value[c] - exact[c]) <= relative * exact[c] + answer.err);
                }
            }
    }
}

TEST_CASE("reference: what arrives along an angle sums up to the irradiance") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Reference reference(index, 2);
    const ShadedPoint at = shadedPointOn(index, 0, 0.4);
    for (unsigned depth = 0; depth <= 2; ++depth) {
        Rgb sum = deltaIrradiance(index, at);
        constexpr int kAngles = 20'000;
        for (int i = 0; i < kAngles; ++i) {
            const double theta = kPi * (i + 0.5) / kAngles;
            sum +=
                reference.radiance(at, theta, depth) * std::sin(theta) * kPi / static_cast<double>(kAngles);
        }
        const Rgb E = reference.irradiance(at, depth);
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(E[c]).epsilon(1e-3));
    }
}

TEST_CASE("reference: refuses too many walls and stops when cancelled") {
    const Scene many = polygonRoom(regularPolygon(static_cast<int>(Reference::kMostWalls) + 1));
    const SegmentIndex manyIndex(many);
    CHECK_THROWS_AS(Reference(manyIndex, 1), std::invalid_argument);
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex index(room);
    const std::atomic<bool> cancelled = true;
    CHECK_FALSE(Reference(index, 3, &cancelled).ready());
}
