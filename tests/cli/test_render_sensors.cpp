// Does each sensor of the command line measure what its name says, at the place that its file tells?
//
// The lamp of segment_light.toml reaches from (-0.5, 2) to (1.5, 2), faces down and has radiance 3; at depth
// 0 all light comes straight from it.
#include <doctest/doctest.h>

#include <cmath>

#include "core/math.h"
#include "result_files.h"
#include "run_program.h"

using namespace halfdisk_test;
using halfdisk::kPi;
using halfdisk::Vec2;

namespace {

constexpr double kRadiance = 3.0, kLampFrom = -0.5, kLampTo = 1.5, kLampHeight = 2.0;
constexpr double kMostStandardErrors = 4.5;

CsvFile renderCsv(std::vector<std::string> arguments) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.csv";
    arguments.insert(arguments.end(), {"-o", file});
    const Outcome outcome = runProgram(arguments);
    REQUIRE_MESSAGE(outcome.exitCode == 0, outcome.err);
    return readCsv(file);
}

/// Angle to an end of the lamp, from straight up to the right.
double angleTo(double x, Vec2 P) {
    return std::atan2(x - P.x, kLampHeight - P.y);
}

void checkAgrees(const CsvRow& row, double exact) {
    CAPTURE(row.place[0]);
    for (int c = 0; c < 3; ++c) {
        CHECK(std::abs(row.mean[c] - exact) <= kMostStandardErrors * row.error[c] + 1e-9 * exact);
        CHECK(row.error[c] <= 0.05 * exact);
    }
}

}  // namespace

TEST_CASE("eye: the lamp is bright where it is, left to right") {
    const CsvFile strip =
        renderCsv({"eye", sceneFile("segment_light.toml"), "--position", "0,1", "--direction", "0,2", "--fov",
                   "120", "--width", "101", "--depth", "0", "--samples", "16"});
    const double left = angleTo(kLampFrom, {0.0, 1.0}) * 180.0 / kPi,
                 right = angleTo(kLampTo, {0.0, 1.0}) * 180.0 / kPi;
    REQUIRE(strip.rows.size() == 101);
    CHECK(strip.rows[50].place[0] == doctest::Approx(0.0));
    for (std::size_t i = 0; i < 101; ++i) {
        // Pixels are equally wide on a film across the view.
        const auto edge = [](double pixel) {
            return std::atan((2.0 * pixel / 101.0 - 1.0) * std::tan(kPi / 3.0)) * 180.0 / kPi;
        };
        const double from = edge(static_cast<double>(i)), to = edge(static_cast<double>(i) + 1.0);
        const CsvRow& row = strip.rows[i];
        CHECK(row.place[0] > from);
        CHECK(row.place[0] < to);
        if (to < left || from > right) CHECK(row.mean.x == 0.0);
        if (from > left && to < right) CHECK(row.mean.x == doctest::Approx(kRadiance).epsilon(1e-12));
    }
}

TEST_CASE("profile: irradiance along the floor by the formula of the lamp's sines") {
    const CsvFile floor = renderCsv({"profile", sceneFile("segment_light.toml"), "--walls", "floor",
                                     "--width", "40", "--depth", "0", "--samples", "4000"});
    REQUIRE(floor.rows.size() == 40);
    for (const CsvRow& row : floor.rows) {
        // Simpson's rule over the bin of 0.25 m; s counts from the wall's end at x = -5.
        const auto E = [&](double s) {
            const Vec2 P{s - 5.0, 0.0};
            return kRadiance * (std::sin(angleTo(kLampTo, P)) - std::sin(angleTo(kLampFrom, P)));
        };
        const double s = row.place[0];
        checkAgrees(row, (E(s - 0.125) + 4.0 * E(s) + E(s + 0.125)) / 6.0);
    }
}

TEST_CASE("field: fluence under the lamp is its radiance times the angle that it fills") {
    for (const char* estimator : {"path", "light"}) {
        CAPTURE(estimator);
        const CsvFile field = renderCsv({"field", sceneFile("segment_light.toml"), "--min", "-1,0.5", "--max",
                                         "2,1.5", "--width", "6", "--height", "4", "--depth", "0",
                                         "--samples", "4000", "--estimator", estimator});
        REQUIRE(field.rows.size() == 24);
        for (const CsvRow& row : field.rows) {
            constexpr int kSteps = 20;
            double sum = 0.0;
            for (int i = 0; i < kSteps; ++i)
                for (int j = 0; j < kSteps; ++j) {
                    const Vec2 P{row.place[0] + 0.5 * ((i + 0.5) / kSteps - 0.5),
                                 row.place[1] + 0.25 * ((j + 0.5) / kSteps - 0.5)};
                    sum += angleTo(kLampTo, P) - angleTo(kLampFrom, P);
                }
            checkAgrees(row, kRadiance * sum / (kSteps * kSteps));
        }
    }
}

TEST_CASE("an even sky of radiance 1: 1 in every pixel, 2 on every wall, 2 pi in every cell") {
    for (const CsvRow& row : renderCsv({"eye", sceneFile("open_sky.toml"), "--position", "0,0", "--direction",
                                        "1,0", "--width", "7"})
                                 .rows)
        CHECK(row.mean.y == doctest::Approx(1.0).epsilon(1e-12));
    for (const CsvRow& row : renderCsv({"profile", sceneFile("lone_floor.toml"), "--walls", "all", "--width",
                                        "7", "--samples", "3000"})
                                 .rows)
        checkAgrees(row, 2.0);
    for (const CsvRow& row : renderCsv({"field", sceneFile("open_sky.toml"), "--min", "0,0", "--max", "1,1",
                                        "--width", "3", "--samples", "3000"})
                                 .rows)
        checkAgrees(row, 2.0 * kPi);
}
