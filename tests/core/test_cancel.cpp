// Does work that is called off end within a few rays, and is only what was finished kept?
#include <doctest/doctest.h>

#include <atomic>

#include "agreement.h"
#include "core/radiosity.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Stage stageOf(const std::string& name) {
    Stage stage = readStage(name);
    stage.index = std::make_unique<SegmentIndex>(stage.scene);
    return stage;
}

struct Asked {
    const char* id;
    std::vector<std::pair<std::string, double>> params;
    std::uint32_t maxDepth = 2;
};
/// Passes of thousands of rays.
const std::vector<Asked> kAsked{
    {"cast-ray", {{"samples", 12}}},
    {"path", {}},
    {"light", {{"paths", 3000}}},
    {"bidirectional", {}},
    {"photon-map", {{"photons", 3000}, {"gather", 50}}},
    {"virtual-lights", {{"paths", 60}}},
    {"radiosity", {{"patches", 60}}},
    {"closed-form", {}, 0},
};

/// A stage in which each of them may be asked, with many pixels.
struct Room {
    Stage stage = stageOf("two_patches");
    std::vector<Sensor> sensors = sensorsOf(stage);

    Room() {
        std::get<EyeStrip>(sensors[1]).width = 200;
        std::get<Profile>(sensors[2]).bins = 200;
        std::get<Field>(sensors[3]).width = 20;
        std::get<Field>(sensors[3]).height = 20;
    }
};

struct Pass {
    std::uint64_t questions = 0, rays = 0, mostRays = 0;  // mostRays: between two questions
    bool stopped = false;
};

/// One pass; the question is answered with yes from the `stopAt`-th time on.
Pass onePass(const Room& room, const Sensor& sensor, const Asked& asked, std::uint64_t stopAt) {
    Pass pass;
    Counts counts;
    bool preparing = true;
    const auto stop = [&] {
        if (preparing) return false;
        pass.mostRays = std::max(pass.mostRays, counts.rays - pass.rays);
        pass.rays = counts.rays;
        return ++pass.questions >= stopAt;
    };
    const EstimatorInfo* info = findEstimator(asked.id);
    const Problem problem{
        .index = *room.stage.index, .sensor = sensor, .maxDepth = asked.maxDepth, .stop = stop};
    const ParamValues values = valuesOf(*info, asked.params);
    const auto estimator = info->make(problem, values);
    preparing = false;
    Picture picture(pixelCount(sensor), Rgb(0.0));
    try {
        estimator->addPass(0, picture, counts);
    } catch (const Stopped&) {
        pass.stopped = true;
    }
    pass.mostRays = std::max(pass.mostRays, counts.rays - pass.rays);
    pass.rays = counts.rays;
    return pass;
}

}  // namespace

TEST_CASE("cancel: every estimator asks within a few hundred rays, and ends at the first yes") {
    const Room room;
    for (const Asked& asked : kAsked)
        for (const Sensor& sensor : room.sensors) {
            const EstimatorInfo* info = findEstimator(asked.id);
            const Problem problem{*room.stage.index, sensor, asked.maxDepth};
            if (!refusalOf(*info, problem, valuesOf(*info, asked.params)).empty()) continue;
            const std::string name = std::string(asked.id) + " " + std::string(kSensorNames[sensor.index()]);
            CAPTURE(name);
            const Pass whole = onePass(room, sensor, asked, UINT64_MAX);
            CHECK_FALSE(whole.stopped);
            REQUIRE(whole.questions > 0);
            // Sixteen paths of three walls, a few rays at each; castRay counts its rays at the end.
            CHECK(whole.rays <= 300 * whole.questions);
            if (asked.id != std::string("cast-ray")) CHECK(whole.mostRays <= 1000);
            for (const std::uint64_t stopAt :
                 {std::uint64_t{1}, (whole.questions + 1) / 2, whole.questions}) {
                const Pass part = onePass(room, sensor, asked, stopAt);
                CHECK(part.stopped);
                CHECK(part.questions == stopAt);
                CHECK(part.rays <= whole.rays);
            }
        }
}

TEST_CASE("cancel: castRay asks at every 16 rays, in the depth of its recursion too") {
    const Room room;
    const Pass pass = onePass(room, room.sensors[0], {"cast-ray", {{"samples", 16}}, 3}, UINT64_MAX);
    CHECK(pass.rays > 3000);
    CHECK(pass.questions >= pass.rays / 17);
}

TEST_CASE("cancel: what is kept are the first passes, to the bit, and none that was called off") {
    const Room room;
    const EstimatorInfo* info = findEstimator("path");
    const Sensor& sensor = room.sensors[1];
    for (const unsigned threads : {1u, 2u, 3u})
        for (const std::uint64_t stopAt : {1u, 40u, 700u, 2500u}) {
            std::atomic<std::uint64_t> questions{0};
            const Problem problem{.index = *room.stage.index, .sensor = sensor, .stop = [&] {
                                      return questions.fetch_add(1) + 1 >= stopAt;
                                  }};
            const auto estimator = info->make(problem, initialValues(*info));
            RenderOptions options;
            options.passes = 400;
            options.threads = threads;
            const Film film = render(*estimator, sensor, options);
            // 13 questions a pass, and after the first yes at most one for each thread. Threads may be far
            // ahead of the first chunk that is called off.
            CHECK(film.passes <= stopAt / 13);
            if (threads == 1) CHECK(film.passes == (stopAt - 1) / 13);
            CHECK(questions < stopAt + threads);
            const auto whole = info->make({*room.stage.index, sensor}, initialValues(*info));
            options.passes = film.passes;
            options.threads = 1;
            const Film again = render(*whole, sensor, options);
            CHECK(film.pixels.mean == again.pixels.mean);
            CHECK(film.pixels.squares == again.pixels.squares);
            CHECK(film.counts.rays == again.counts.rays);
        }
}

TEST_CASE("cancel: RenderOptions::stop lets the passes under way end") {
    const Room room;
    const EstimatorInfo* info = findEstimator("path");
    const auto estimator = info->make({*room.stage.index, room.sensors[1]}, initialValues(*info));
    RenderOptions options;
    options.passes = 400;
    options.stop = [] { return true; };
    const Film film = render(*estimator, room.sensors[1], options);
    CHECK(film.passes == 20);  // one chunk of 4096 / 200 passes
}

TEST_CASE("cancel: radiosity's preparation asks all the while, and ends at the first yes") {
    const Room room;
    const Stage occluded = stageOf("occluder");
    for (const SegmentIndex* index : {room.stage.index.get(), occluded.index.get()})
        for (const std::optional<std::uint32_t> bounces : {std::optional(3u), {}}) {
            constexpr std::uint32_t kPatches = 300;
            std::uint64_t whole = 0;
            Radiosity(*index, kPatches, bounces, [&] { return ++whole == UINT64_MAX; });
            // At the least for every 16 pairs of patches that face each other, and for every strip of a
            // matrix.
            CHECK(whole > kPatches * kPatches / 64);
            for (const std::uint64_t share : {0u, 1u, 2u, 3u, 4u}) {
                const std::uint64_t stopAt = std::max<std::uint64_t>(1, whole * share / 4);
                std::uint64_t questions = 0;
                CHECK_THROWS_AS(Radiosity(*index, kPatches, bounces, [&] { return ++questions >= stopAt; }),
                                Stopped);
                CHECK(questions == stopAt);
            }
        }
}

TEST_CASE("cancel: closed form's search for what is in the way ends at the first yes") {
    const Room room;
    std::uint64_t questions = 0;
    const Problem problem{.index = *room.stage.index, .sensor = room.sensors[3], .maxDepth = 0, .stop = [&] {
                              return ++questions >= 100;
                          }};
    const EstimatorInfo* info = findEstimator("closed-form");
    CHECK_THROWS_AS(refusalOf(*info, problem, initialValues(*info)), Stopped);
    CHECK(questions == 100);
}
