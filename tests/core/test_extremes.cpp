// Does every estimator stay finite where light is at its most extreme?
#include <doctest/doctest.h>

#include <functional>

#include "agreement.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// A room of 2 m with a lamp in its ceiling and a small square in its middle; walls are material 0, the
/// square material 1.
Scene room(Material walls, Material square) {
    Scene scene;
    scene.materials = {walls, square};
    scene.materialNames = {"walls", "square"};
    scene.segments = {wallOf({0, 0}, {2, 0}, 0),         wallOf({2, 0}, {2, 2}, 0),
                      wallOf({2, 2}, {1.3, 2}, 0),       wallOf({1.3, 2}, {0.7, 2}, 0, Rgb(1.0)),
                      wallOf({0.7, 2}, {0, 2}, 0),       wallOf({0, 2}, {0, 0}, 0),
                      wallOf({0.8, 0.8}, {0.8, 1.2}, 1), wallOf({0.8, 1.2}, {1.2, 1.2}, 1),
                      wallOf({1.2, 1.2}, {1.2, 0.8}, 1), wallOf({1.2, 0.8}, {0.8, 0.8}, 1)};
    for (std::size_t i = 0; i < scene.segments.size(); ++i)
        scene.segmentNames.push_back(i == 0 ? "floor" : "wall" + std::to_string(i));
    scene.eye = Eye{{0.3, 1.5}, glm::normalize(Vec2(1.0, -0.7)), 1.2};
    return scene;
}

struct Extreme {
    const char* name;
    Scene scene;
};

std::vector<Extreme> extremes() {
    const Material white = Diffuse{Rgb(0.8)}, glass = Dielectric{1.5, Rgb(0.0)};
    std::vector<Extreme> all;
    const auto add = [&](const char* name, Scene scene) { all.push_back({name, std::move(scene)}); };
    add("albedo 1", room(Diffuse{Rgb(1.0)}, Diffuse{Rgb(1.0)}));
    add("albedo 0", room(Diffuse{Rgb(0.0)}, Diffuse{Rgb(0.0)}));
    add("index 1", room(white, Dielectric{1.0, Rgb(0.0)}));
    add("index 4", room(white, Dielectric{4.0, Rgb(0.0)}));
    add("glass that lets nothing through", room(white, Dielectric{1.5, Rgb(1e6)}));
    add("roughness 0", room(Glossy{Rgb(1.0), exponentOfRoughness(0.0)}, white));
    add("roughness 1", room(Glossy{Rgb(1.0), exponentOfRoughness(1.0)}, white));
    add("mirrors all around", room(Mirror{Rgb(1.0)}, white));
    add("a mix of all mirror", room(Mix{Diffuse{Rgb(1.0)}, Mirror{Rgb(1.0)}, 1.0}, white));
    add("a mix of no mirror", room(Mix{Diffuse{Rgb(1.0)}, Glossy{Rgb(1.0), 50.0}, 0.0}, white));
    Scene touching = room(white, white);
    touching.segments.push_back(wallOf({2.0, 0.3}, {1.6, 0.0}, 0, Rgb(2.0)));
    touching.segmentNames.emplace_back("lamp in the corner");
    touching.lights.push_back(PointLight{{0.0, 1.0}, Rgb(1.0)});
    touching.lights.push_back(PointLight{{0.4, 0.0}, Rgb(1.0)});
    add("lights that touch walls", touching);
    Scene inside = room(white, glass);
    inside.eye->position = {1.0, 1.0};
    inside.lights.push_back(PointLight{{1.1, 1.05}, Rgb(1.0)});
    add("eye and bulb inside glass", inside);
    Scene onWall = room(white, white);
    onWall.eye = Eye{{2.0, 1.0}, {-1.0, 0.0}, 3.0};
    add("camera on a wall", onWall);
    Scene bright = room(white, white), faint = bright;
    for (Segment& segment : bright.segments) segment.emission *= 1e30;
    for (Segment& segment : faint.segments) segment.emission *= 1e-30;
    add("radiance of 1e30", bright);
    add("radiance of 1e-30", faint);
    Scene sky = room(white, white);
    sky.segments.resize(1);
    sky.segmentNames.resize(1);
    sky.environment.radiance = Rgb(1.0);
    sky.environment.strip = {Rgb(0.0), Rgb(1e6), Rgb(0.0), Rgb(0.0), Rgb(0.0), Rgb(0.0), Rgb(0.0), Rgb(0.0)};
    add("one bright spot in a black sky", sky);
    Scene dark = room(white, white);
    for (Segment& segment : dark.segments) segment.emission = Rgb(0.0);
    add("no light", dark);
    return all;
}

/// Every estimator on every sensor that it serves; `check` sees each film.
void forAll(const Stage& stage, std::uint64_t samples,
            const std::function<void(const EstimatorInfo&, const Sensor&, const Film&)>& check) {
    for (const Sensor& sensor : sensorsOf(stage))
        for (const EstimatorInfo* info : estimators()) {
            Run run{.id = std::string(info->id),
                    .maxDepth = info->id == "closed-form" ? 0u : 3u,
                    .samples = samples,
                    .threads = 2};
            if (info->id == "cast-ray") run.params = {{"samples", 2}}, run.samples /= 8;
            if (info->id == "photon-map") run.params = {{"photons", 500}, {"gather", 2}}, run.samples /= 50;
            if (info->id == "virtual-lights") run.params = {{"paths", 4}}, run.samples /= 4;
            if (info->id == "radiosity") run.params = {{"patches", 60}}, run.samples /= 50;
            const Problem problem{*stage.index, sensor, run.maxDepth};
            if (!refusalOf(*info, problem, valuesOf(*info, run.params)).empty()) continue;
            check(*info, sensor, measure(stage, sensor, run));
        }
}

}  // namespace

TEST_CASE("extremes: no contribution that is not finite, none below zero") {
    for (Extreme& extreme : extremes()) {
        Stage stage;
        stage.name = extreme.name;
        stage.scene = std::move(extreme.scene);
        stage.index = std::make_unique<SegmentIndex>(stage.scene);
        forAll(stage, 10'000, [&](const EstimatorInfo& info, const Sensor& sensor, const Film& film) {
            INFO(stage.name << ": " << info.id << " " << kSensorNames[sensor.index()]);
            CHECK(film.counts.nonFinite == 0);
            CHECK(film.counts.negative == 0);
            for (const Statistics& pixel : film.pixels) {
                REQUIRE(isFinite(pixel.mean));
                REQUIRE(pixel.nonFinite == 0);
            }
        });
    }
}

TEST_CASE("extremes: glass of index 1 changes nothing") {
    Stage empty, filled;
    empty.scene = room(Diffuse{Rgb(0.8)}, Dielectric{1.0, Rgb(0.0)});
    filled.scene = empty.scene;
    empty.scene.segments.resize(6);
    empty.scene.segmentNames.resize(6);
    for (Stage* stage : {&empty, &filled}) stage->index = std::make_unique<SegmentIndex>(stage->scene);
    for (const Sensor& sensor : sensorsOf(empty))
        // Shadow rays take glass for opaque, so lamps must be met.
        CHECK(compare(measure(empty, sensor, {.id = "path", .params = {{"emitters", 1}}}),
                      measure(filled, sensor, {.id = "path", .params = {{"emitters", 1}}, .seed = 2}), 8)
                  .holds());
}

TEST_CASE("extremes: a closed room of albedo 1 keeps all of its light") {
    // Scattered at most D times, the walls of a furnace send out D + 1 times what they emit; no roulette may
    // change that.
    Scene furnace = room(Diffuse{Rgb(1.0)}, Diffuse{Rgb(1.0)});
    for (Segment& segment : furnace.segments) segment.emission = Rgb(1.0);
    Stage stage;
    stage.scene = furnace;
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    for (const char* id : {"path", "light", "bidirectional"})
        for (const std::uint32_t depth : {0u, 5u, 20u}) {
            const Film film =
                measure(stage, Probe{shadedPointOn(*stage.index, 0, 0.37)},
                        {.id = id, .maxDepth = depth, .samples = depth == 20 ? 3'000u : 20'000u});
            INFO(id << " depth " << depth);
            // E = 2 L on a floor that sees the room alone.
            CHECK(zTest(film.pixels[0], 2.0 * (depth + 1.0), 1e-9).within(kSingle));
        }
}
