// Where walls lie on each other, is the one behind dark and without light of its own, for every estimator?
#include <doctest/doctest.h>

#include "agreement.h"
#include "core/exact.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Stage coveredRoom() {
    Stage stage = readStage("covered");
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    return stage;
}

/// What the file says: which part of a wall's front lies behind another.
struct CoveredPart {
    std::string wall;
    double from, to;  // u
};
const CoveredPart kParts[] = {{"floor", 0.5, 0.75}, {"ceiling", 0.3, 0.5},     {"left wall", 0.25, 0.75},
                              {"window", 0.5, 1.0}, {"hidden lamp", 0.0, 1.0}, {"skylight", 0.0, 1.0},
                              {"rug", 0.0, 0.0},    {"lamp", 0.0, 0.0},        {"picture", 0.0, 0.0},
                              {"screen", 0.0, 0.0}, {"notice", 0.0, 0.0}};

std::vector<std::uint32_t> everyWall(const Stage& stage) {
    std::vector<std::uint32_t> walls(stage.scene.segments.size());
    for (std::uint32_t i = 0; i < walls.size(); ++i) walls[i] = i;
    return walls;
}

Film profileOf(const Stage& stage, const std::string& wall, const Run& run) {
    const Sensor sensor = Profile{{stage.wall(wall)}, 8};
    return measure(stage, sensor, run);
}

}  // namespace

TEST_CASE("cover: a wall is covered where another that goes before it lies on it, on that side only") {
    const Stage stage = coveredRoom();
    const CoveredWalls covers(*stage.index, everyWall(stage));
    constexpr int kPlaces = 1000;
    for (const CoveredPart& part : kParts)
        for (int i = 0; i < kPlaces; ++i) {
            const double u = (i + 0.5) / kPlaces;
            const ShadedPoint at = shadedPointOn(*stage.index, stage.wall(part.wall), u);
            INFO(part.wall << " at " << u);
            REQUIRE(isCovered(*stage.index, at) == (u > part.from && u < part.to));
            REQUIRE(covers.isCovered(*stage.index, at) == (u > part.from && u < part.to));
        }
    // The notice lies on the screen's back.
    const std::uint32_t screen = stage.wall("screen");
    for (const double u : {0.25, 0.49, 0.51, 0.75}) {
        const ShadedPoint front = shadedPointOn(*stage.index, screen, u);
        CHECK(isCovered(*stage.index, {front.P, -front.N, screen}) == (u > 0.5));
    }
    CHECK_FALSE(isCovered(*stage.index, {{0.5, 1.0}, {0.0, 1.0}}));
}

TEST_CASE("cover: walls that others lie over are found as by trying all pairs") {
    Random random(5);
    std::size_t found = 0;
    for (int round = 0; round < 20; ++round) {
        Scene scene;
        for (int i = 0; i < 60; ++i) {
            const Vec2 a = random.pointIn(-1.0, 1.0), along = random.direction();
            const std::uint32_t wall = addWall(scene, a, a + along * random.in(0.01, 1.0));
            scene.segments[wall].twoSided = random.integer(0, 3) == 0;
            if (random.integer(0, 2) == 0) continue;
            // Some on the same line, before, behind or beside it, either way round.
            const double from = random.in(-1.0, 1.0), to = random.in(-1.0, 1.0);
            addWall(scene, a + from * along, a + to * along);
        }
        const SegmentIndex index(scene);
        std::vector<std::uint32_t> walls, expected;
        for (std::uint32_t wall = 0; wall < scene.segments.size(); wall += 1 + round % 3)
            walls.push_back(wall);
        for (const std::uint32_t wall : walls) {
            bool any = false;
            for (std::uint32_t other = 0; other < scene.segments.size(); ++other)
                any = any || mayLieOver(scene, other, wall);
            if (any) expected.push_back(wall);
        }
        found += expected.size();
        CHECK(CoveredWalls(index, walls).all() == expected);
    }
    CHECK(found > 100);
}

TEST_CASE(
    "cover: on every wall, every estimator and the exact answer agree; where it is covered it is dark") {
    const Stage stage = coveredRoom();
    const std::uint32_t depth = 1;
    const Reference reference(*stage.index, depth);
    const struct {
        Run run;
        double err;  // of the patches, in parts of the brightest bin
    } runs[] = {{{.id = "path", .threads = 2}, 0.0},
                {{.id = "light", .threads = 2}, 0.0},
                {{.id = "bidirectional", .samples = 50'000, .threads = 2}, 0.0},
                {{.id = "cast-ray", .params = {{"samples", 2}}, .samples = 25'000, .threads = 2}, 0.0},
                {{.id = "virtual-lights", .params = {{"paths", 4}}, .samples = 25'000, .threads = 2}, 0.0},
                {{.id = "radiosity", .params = {{"patches", 150}}, .samples = 5'000, .threads = 2}, 5e-3}};
    for (const CoveredPart& part : kParts) {
        const std::uint32_t wall = stage.wall(part.wall);
        const std::vector<Rgb> exact = exactBins(stage, reference, wall, 8, 5, depth);
        double most = 0.0;
        for (std::size_t bin = 0; bin < 8; ++bin) {
            most = std::max(most, exact[bin].x);
            const double from = static_cast<double>(bin) / 8.0;
            const bool dark = from >= part.from && from + 0.125 <= part.to;
            CHECK((exact[bin].x == 0.0) == dark);
        }
        for (auto [run, err] : runs) {
            run.maxDepth = depth;
            const Film film = profileOf(stage, part.wall, run);
            const Agreement agreement = compareExact(film, exact, (1e-3 + err) * most, 60);
            INFO(part.wall << ": " << run.id << " against exact, " << agreement.where << ", "
                           << agreement.worst << " of " << agreement.threshold);
            CHECK(agreement.holds());
            CHECK(film.counts.negative + film.counts.nonFinite == 0);
        }
    }
}

TEST_CASE("cover: a room that forgets its covers is told from one that keeps them") {
    const Stage kept = coveredRoom();
    Stage forgotten = coveredRoom();
    // As if a covered place received what arrives without the cover: the rug behind the floor.
    std::swap(forgotten.scene.segments[forgotten.wall("rug")],
              forgotten.scene.segments[forgotten.wall("floor")]);
    std::swap(forgotten.scene.segmentNames[forgotten.wall("rug")],
              forgotten.scene.segmentNames[forgotten.wall("floor")]);
    forgotten.index = std::make_unique<SegmentIndex>(forgotten.scene);
    for (const std::string id : {"path", "light", "bidirectional"}) {
        const Film one = profileOf(kept, "floor", {.id = id, .threads = 2});
        const Film other = profileOf(forgotten, "floor", {.id = id, .seed = 2, .threads = 2});
        CHECK_FALSE(compare(one, other, 1).holds());
    }
    // Or as if the hidden lamp shone: all of the floor is brighter then.
    Stage shining = coveredRoom();
    shining.scene.segments[shining.wall("ceiling")].emission = Rgb(0.2);
    shining.index = std::make_unique<SegmentIndex>(shining.scene);
    CHECK_FALSE(compare(profileOf(kept, "rug", {.id = "light", .threads = 2}),
                        profileOf(shining, "rug", {.id = "light", .seed = 2, .threads = 2}), 1)
                    .holds());
}

TEST_CASE("cover: from behind a one-sided wall a two-sided lamp is seen that was written after it") {
    const Stage stage = coveredRoom();
    const Segment& skylight = stage.scene.segments[stage.wall("skylight")];
    const Vec2 up = -frontNormal(skylight), P = (skylight.a + skylight.b) / 2.0 + 0.3 * up;
    const Sensor sensor = Probe{{P, -up}};
    const double exact = segmentIrradiance(P, -up, skylight).x;
    CHECK(directIrradiance(Visibility(*stage.index), {P, -up}).x == doctest::Approx(exact));
    for (const std::string id :
         {"path", "light", "bidirectional", "cast-ray", "virtual-lights", "photon-map", "radiosity"}) {
        // A pass of photons is dear, and its gathering rays are many.
        const std::uint64_t samples = id == "photon-map" ? 200 : 20'000;
        const Film film = measure(stage, sensor, {.id = id, .maxDepth = 0, .samples = samples});
        const Agreement agreement = compareExact(film, {Rgb(exact)}, 1e-9 * exact, 7);
        INFO(id << ": " << film.pixels[0].mean.x << " of " << exact);
        CHECK(agreement.holds());
    }
    for (const char* how : {"sample", "hit"}) {
        const double choice = how == std::string("sample") ? 0.0 : 1.0;
        const Film film =
            measure(stage, sensor,
                    {.id = "path", .params = {{"emitters", choice}}, .maxDepth = 0, .samples = 200'000});
        INFO(how);
        CHECK(compareExact(film, {Rgb(exact)}, 1e-9 * exact, 2).holds());
    }
}

TEST_CASE("cover: a bulb on a wall lights one side of it, however its light is followed") {
    Stage stage = coveredRoom();
    const Segment& ceiling = stage.scene.segments[stage.wall("ceiling")];
    for (Segment& wall : stage.scene.segments) wall.emission = Rgb(0.0);
    stage.scene.lights.emplace_back(PointLight{glm::mix(ceiling.a, ceiling.b, 0.9), Rgb(1.0)});
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    for (const Sensor& sensor : sensorsOf(stage)) {
        const Film path = measure(stage, sensor, {.id = "path", .threads = 2});
        for (const std::string id : {"light", "bidirectional", "cast-ray", "virtual-lights"}) {
            if (id == "bidirectional" && std::holds_alternative<Field>(sensor)) continue;  // it has none
            const Film film = measure(stage, sensor, {.id = id, .seed = 2, .threads = 2});
            const Agreement agreement = compare(path, film, 10);
            INFO(id << " " << kSensorNames[sensor.index()] << ", " << agreement.where);
            CHECK(agreement.holds());
        }
    }
}
