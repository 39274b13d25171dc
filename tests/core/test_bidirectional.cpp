// Do all strategies of bidirectional tracing find the same light, and do their weights share it without loss?
#include <doctest/doctest.h>

#include "agreement.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Stage stageOf(const std::string& name) {
    Stage stage = readStage(name);
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    return stage;
}

Film strategy(const Stage& stage, const Sensor& sensor, int s, int t, bool weights,
              std::uint64_t samples = 400'000) {
    return measure(stage, sensor,
                   {.id = "bidirectional",
                    .params = {{"s", s}, {"t", t}, {"weights", weights ? 1.0 : 0.0}},
                    .maxDepth = 2,
                    .samples = samples,
                    .threads = 2});
}

}  // namespace

TEST_CASE("bidirectional: each strategy alone, unweighted, finds all light of its length") {
    // Paths of n vertices: light, walls, sensor. A probe on the floor of a room can be reached by each of
    // them but t = 0.
    for (const char* name : {"closed_room", "glossy_wall", "sky_only"}) {
        const Stage stage = stageOf(name);
        const Sensor probe = sensorsOf(stage)[0];
        for (const int n : {2, 3, 4}) {
            const Film reference = strategy(stage, probe, 1, n - 1, false);
            CHECK(reference.pixels[0].mean.x > 10.0 * reference.pixels[0].standardError().x);
            for (int s = 0; s < n; ++s) {
                if (s == 1) continue;
                const Film film = strategy(stage, probe, s, n - s, false);
                const Agreement agreement = compare(film, reference, 20);
                INFO(name << " s = " << s << " of " << n << ": " << agreement.where);
                CHECK(agreement.holds());
                Film dark = film;
                for (Rgb& mean : dark.pixels.mean) mean *= 0.85;
                CHECK_FALSE(compare(dark, reference, 20).holds());
            }
        }
    }
}

TEST_CASE("bidirectional: a profile is met by the light's own paths too") {
    const Stage stage = stageOf("closed_room");
    const Sensor profile = sensorsOf(stage)[2];
    for (const int n : {2, 3}) {
        const Agreement agreement =
            compare(strategy(stage, profile, n, 0, false), strategy(stage, profile, 1, n - 1, false), 4);
        INFO(agreement.where);
        CHECK(agreement.holds());
    }
}

TEST_CASE("bidirectional: the strategies' weighted pictures add up to the whole") {
    for (const char* name : {"mixed", "glass_disk", "sky_only"}) {
        const Stage stage = stageOf(name);
        for (const std::size_t which : {0u, 1u, 2u}) {
            const Sensor sensor = sensorsOf(stage)[which];
            const Film whole = strategy(stage, sensor, -1, -1, true, 600);
            std::vector<Rgb> sum(whole.pixels.size(), Rgb(0.0));
            // Chains of glass are longer than the depth: up to 40 vertices in these few hundred paths.
            for (int s = 0; s <= 40; ++s) {
                const Film part = strategy(stage, sensor, s, -1, true, 600);
                for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part.pixels[i].mean;
            }
            for (std::size_t i = 0; i < sum.size(); ++i)
                CHECK(sum[i].x == doctest::Approx(whole.pixels[i].mean.x).epsilon(1e-9));
        }
    }
}

TEST_CASE("bidirectional: the power heuristic agrees with the balance heuristic") {
    for (const char* name : {"closed_room", "mirror_room", "glossy_wall", "sky_only"}) {
        const Stage stage = stageOf(name);
        for (const std::size_t which : {0u, 1u, 2u}) {
            const Sensor sensor = sensorsOf(stage)[which];
            const Film balance =
                measure(stage, sensor, {.id = "bidirectional", .samples = 30'000, .threads = 2});
            const Film power = measure(stage, sensor,
                                       {.id = "bidirectional",
                                        .params = {{"heuristic", 1}},
                                        .seed = 2,
                                        .samples = 30'000,
                                        .threads = 2});
            const Agreement agreement = compare(balance, power, 12);
            INFO(name << " " << which << ": " << agreement.where);
            CHECK(agreement.holds());
        }
    }
}
