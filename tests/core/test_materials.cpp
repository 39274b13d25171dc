// Is every material reciprocal, does it make no light, and which send it in one direction only?
#include <doctest/doctest.h>

#include "material_rows.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("materials: light goes both ways alike") {
    Random random(3);
    for (const MaterialRow& row : scatteringMaterials())
        for (int i = 0; i < 1000; ++i) {
            const double a = random.in(-1.57, 1.57), b = random.in(-1.57, 1.57);
            const Rgb there = evalSurface(seenAt(row.material, a), fromNormal(b), fromNormal(a));
            const Rgb back = evalSurface(seenAt(row.material, b), fromNormal(a), fromNormal(b));
            REQUIRE(there.x == doctest::Approx(back.x).epsilon(1e-9));
            REQUIRE(there.z == doctest::Approx(back.z).epsilon(1e-9));
        }
}

TEST_CASE("materials: no more light leaves than arrives, from any angle") {
    Random random(5);
    for (const MaterialRow& row : allMaterials())
        for (int k = 0; k <= 40; ++k) {
            const double angle = -1.57 + 3.14 * k / 40.0;
            const SurfacePoint point =
                seenAt(row.material, angle, std::string(row.name) != "glass from within");
            Statistics sent;
            for (int i = 0; i < 4000; ++i) {
                const auto way = sampleSurface(point, Carried::power, drawsFrom(random));
                sent.add(way ? way->weight : Rgb(0.0));
            }
            INFO(row.name << " at " << angle);
            for (int c = 0; c < 3; ++c) {
                CHECK(sent.mean[c] <= 1.0 + kSweep * sent.standardError()[c] + 1e-12);
                CHECK(sent.mean[c] >= 0.0);
            }
        }
}

TEST_CASE("materials: which of them send light in one direction only") {
    Random random(8);
    for (const MaterialRow& row : allMaterials()) {
        const SurfacePoint point = seenAt(row.material, 0.5);
        int deltas = 0, draws = 0;
        for (int i = 0; i < 2000; ++i) {
            const auto way = sampleSurface(point, Carried::radiance, drawsFrom(random));
            if (!way) continue;
            ++draws;
            deltas += way->isDelta() ? 1 : 0;
        }
        INFO(row.name);
        const auto* mix = std::get_if<Mix>(&row.material);
        if (isSpecular(row.material)) {
            CHECK(deltas == draws);
            CHECK(evalSurface(point, fromNormal(-0.5), fromNormal(0.5)) == Rgb(0.0));
            CHECK(pdfSurface(point, fromNormal(0.5), fromNormal(-0.5)) == 0.0);
        } else if (mix && std::holds_alternative<Mirror>(mix->specular)) {
            CHECK(deltas == doctest::Approx(mix->weight * draws).epsilon(0.12));
        } else {
            CHECK(deltas == 0);
        }
    }
}
