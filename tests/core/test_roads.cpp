// Do paths find the exact answers, and nothing where nothing can be found?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "cases.h"
#include "caustic.h"
#include "roads.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// All but 07, a circle of 10 000 walls.
constexpr const char* kCases[] = {"01_segment_light", "03_occluded_light",     "05_white_furnace",
                                  "09_cornell_rgb",   "14_square_albedo_0.99", "16_vgroove_60",
                                  "20b_grazing",      "22_environment_box",    "24_cornell_mirror_wall"};

// All channels of pixel 0 against exact values: scale times what was measured, and offset.
struct Truth {
    Rgb exact;
    double err;
    Rgb scale{1.0}, offset{0.0};

    std::vector<ZTest> tests(const Film& film) const {
        const Rgb mean = offset + film.pixels[0].mean * scale, error = film.pixels[0].standardError() * scale;
        std::vector<ZTest> all;
        for (int c = 0; c < 3; ++c) all.push_back({mean[c], error[c], exact[c], err});
        return all;
    }
};

void checkTruth(Sweep& sweep, const Stage& stage, const Sensor& sensor, const Run& run, const Truth& truth) {
    Film first;
    const auto measured = [&](bool again) {
        if (again) return truth.tests(measureAgain(stage, sensor, run, first));
        first = measureWell(stage, sensor, run);
        return truth.tests(first);
    };
    for (const ZTest& test : sweep.settle(measured)) {
        CHECK_MESSAGE(test.within(kSingle), test.text());
        CHECK_MESSAGE(test.standardError <= kPrecision * test.exact, test.text());
        CHECK_MESSAGE(tellsFivePercent(test), test.text());
    }
}

void checkChance(const Sweep& sweep) {
    MESSAGE(sweep.text());
    CHECK(sweep.again() <= sweep.mostAgain());
}

}  // namespace

TEST_CASE("roads: every case's deepest exact answers, and those without limit") {
    Sweep sweep;
    for (const std::string name : kCases) {
        const Case known = readCase(name);
        Stage stage = staged(known.name, known.scene);
        prepare(stage);
        for (const Answer& answer : known.answers) {
            const ShadedPoint point = pointOf(*stage.index, answer);
            const Sensor probe = Probe{point};
            const Rgb offset = quantityOf(*stage.index, answer, Rgb(0.0)),
                      scale = quantityOf(*stage.index, answer, Rgb(1.0)) - offset;
            const auto check = [&](const std::string& id, std::uint32_t depth, const Rgb& value) {
                const EstimatorInfo* info = findEstimator(id);
                if (info->paths(stage.scene, bitOf(probe)) != allPaths(stage.scene)) return;
                INFO(name << " " << id << " " << answer.wall << " " << answer.t << " depth " << depth);
                checkTruth(sweep, stage, probe,
                           {.id = id, .maxDepth = depth, .samples = 20'000, .threads = 2},
                           {value, answer.err, scale, offset});
            };
            const std::size_t last = answer.depth.size() - 1;
            if (const auto setting = depthSetting(answer, last))
                for (const std::string id : {"path", "light", "bidirectional"})
                    check(id, *setting, answer.depth[last]);
            // In a square of albedo 0.99 one part in 20 000 is missing after 1000 scatterings: far below the
            // noise.
            if (answer.unlimited)
                for (const std::string id : {"path", "light"}) check(id, 1000, *answer.unlimited);
        }
    }
    checkChance(sweep);
}

TEST_CASE("roads: an eye sees every case's walls as bright as they are") {
    Sweep sweep;
    for (const std::string name : kCases) {
        const Case known = readCase(name);
        Stage stage = staged(known.name, known.scene);
        prepare(stage);
        for (const Answer& answer : known.answers) {
            const std::size_t last = answer.depth.size() - 1;
            const auto setting = depthSetting(answer, last);
            if (answer.query != "radiance" || !setting) continue;
            // One pixel, 10 nm wide on the wall: over so little light does not change.
            const ShadedPoint point = pointOf(*stage.index, answer);
            const Sensor eye = EyeStrip{{point.P + 1e-4 * point.N, -point.N, 1e-4}, 1};
            for (const std::string id : {"path", "bidirectional"}) {
                INFO(name << " " << id << " " << answer.wall << " " << answer.t);
                checkTruth(sweep, stage, eye,
                           {.id = id, .maxDepth = *setting, .samples = 20'000, .threads = 2},
                           {answer.depth[last], answer.err});
            }
        }
    }
    checkChance(sweep);
}

TEST_CASE("roads: radiance seen in a mirror") {
    Stage stage = staged("mirror", readCase("24_cornell_mirror_wall").scene);
    prepare(stage);
    // 0.8 times the radiance of the left wall at y = 0.85, at depths 1, 2, 3 (tests/cases/24).
    const double exact[] = {0.04837078484157635, 0.05000597531759352, 0.06007435853999537};
    const Sensor look = Look{{1.4, 1.5}, {0.9701425001453319, -0.24253562503633297}};
    for (std::uint32_t depth = 0; depth < 3; ++depth)
        for (const std::string id : {"path", "cast-ray", "bidirectional"}) {
            INFO(id << " depth " << depth + 1);
            Run run{.id = id, .maxDepth = depth, .samples = 20'000, .threads = 2};
            if (run.id == "cast-ray") run.params = {{"samples", 3}};
            checkValue(measureWell(stage, look, run), 0, exact[depth], 1e-6, 0.005);
        }
}

TEST_CASE("roads: what can't be found is exactly zero") {
    SUBCASE("castRay and path tracing find no caustic of a light without size") {
        Stage stage = staged("caustic", causticScene({}, 64, true));
        prepare(stage);
        // Below the disk only light through it arrives: no shadow ray gets there, and the sun can't be met.
        const Sensor below = Probe{shadedPointOn(*stage.index, stage.wall("floor"), 0.5)};
        for (const std::string id : {"cast-ray", "path"})
            for (const double emitters : {0.0, 1.0, 2.0}) {
                const Film film =
                    measure(stage, below, {.id = id, .params = {{"emitters", emitters}}, .samples = 20'000});
                CHECK(film.pixels[0].mean == Rgb(0.0));
                CHECK(film.pixels[0].squares == Rgb(0.0));
            }
    }
    SUBCASE("light tracing does not see through the pinhole what a mirror shows") {
        Stage stage = readStage("mirror_room");
        prepare(stage);
        // An eye close to the mirror that sees nothing else.
        const Sensor eye = EyeStrip{{{1.95, 1.0}, {1.0, 0.0}, kPi / 3}, 4};
        const Film film = measure(stage, eye, {.id = "light", .samples = 40'000});
        const Film truth = measure(stage, eye, {.id = "path", .samples = 40'000});
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(film.pixels[i].mean == Rgb(0.0));
            CHECK(truth.pixels[i].mean.x > 10.0 * truth.pixels[i].standardError().x);
        }
    }
    SUBCASE("nor does a probe below glass get its direct light by light tracing") {
        Stage stage = staged("caustic", causticScene({}, 64, true));
        prepare(stage);
        const Film film = measure(stage, Probe{shadedPointOn(*stage.index, stage.wall("floor"), 0.5)},
                                  {.id = "light", .maxDepth = 3, .samples = 20'000});
        CHECK(film.pixels[0].mean == Rgb(0.0));
    }
}
