// Does a recorded run tell all that an estimator found, step by step, and nothing that it did not?
#include <doctest/doctest.h>

#include <map>
#include <numeric>

#include "core/path_run.h"
#include "core/path_word.h"
#include "core/pixel_statistics.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

struct Stage {
    Scene scene;
    SegmentIndex index{scene};
    ShadedPoint at;

    explicit Stage(Scene built) : scene(std::move(built)) {
        const Segment& wall = scene.segments[0];
        at.segment = 0;
        at.P = wall.a + 0.4 * (wall.b - wall.a);
        at.N = index.normal(0);
    }
};

std::vector<const EstimatorInfo*> recorded() {
    std::vector<const EstimatorInfo*> infos;
    for (const EstimatorInfo* info : estimators())
        if (info->recorded) infos.push_back(info);
    return infos;
}

PathRun runOf(const EstimatorInfo& info, const Stage& stage, const Settings& settings,
              std::size_t limit = 100'000) {
    return recordPaths(info, stage.index, Probe{stage.at}, 0, settings, initialValues(info), {}, limit);
}

Settings deep(std::uint32_t samples) {
    Settings settings;
    settings.samples = samples;
    settings.maxDepth = 3;
    return settings;
}

Rgb sumOf(const PathRecord& record) {
    Rgb sum{0.0};
    for (const PathEvent& event : record.events) sum += event.value;
    return sum;
}

double relative(const Rgb& a, const Rgb& b) {
    return glm::length(a - b) / std::max(glm::length(b), 1e-300);
}

}  // namespace

TEST_CASE("four estimators can be recorded") {
    CHECK(recorded().size() == 4);
}

TEST_CASE("what the steps add is the estimate") {
    for (const Scene& scene : {litBox(), mixedRoom()}) {
        const Stage stage(scene);
        for (const EstimatorInfo* info : recorded()) {
            CAPTURE(info->id);
            const PathRun run = runOf(*info, stage, deep(64));
            REQUIRE(run.refusal.empty());
            REQUIRE(run.estimate.x > 0.0);
            const double divisor = run.divisor;
            CHECK(relative(sumOf(run.record) / divisor, run.estimate) < 1e-12);
            CHECK(relative(run.record.events.back().sum / divisor, run.estimate) < 1e-12);
            // A recorder that forgets one step would be found out.
            PathRecord robbed = run.record;
            for (PathEvent& event : robbed.events)
                if (event.value.x > 0.0) {
                    event.value = Rgb(0.0);
                    break;
                }
            CHECK(relative(sumOf(robbed) / divisor, run.estimate) > 1e-9);
        }
    }
}

TEST_CASE("a run that is recorded is to the bit the one that is not") {
    const Stage stage(mixedRoom());
    for (const EstimatorInfo* info : recorded()) {
        CAPTURE(info->id);
        const PathRun run = runOf(*info, stage, deep(32));
        ParamValues params = initialValues(*info);
        for (std::size_t i = 0; i < params.size(); ++i)
            if (info->params[i].name == "paths" || info->params[i].name == "photons") params[i] = 32;
        const Sensor sensor = Probe{stage.at};
        const Problem problem{.index = stage.index, .sensor = sensor, .maxDepth = 3};
        const auto estimator = info->make(problem, params);
        Statistics values;
        Counts counts;
        for (std::uint32_t pass = 0; pass < run.divisor; ++pass) {
            Picture picture(1, Rgb(0.0));
            estimator->addPass(pass, picture, counts);
            values.add(picture.front());
        }
        CHECK(values.mean == run.estimate);
        CHECK(counts.rays == run.counts.rays);
    }
}

TEST_CASE("a path flies from wall to wall: each flight begins where the last one ended") {
    const Stage stage(mixedRoom());
    for (const EstimatorInfo* info : recorded()) {
        CAPTURE(info->id);
        const PathRun run = runOf(*info, stage, deep(48));
        std::size_t flights = 0, arrivals = 0;
        Vec2 here{0.0};
        for (const PathEvent& event : run.record.events) {
            if (event.kind == PathEventKind::start) here = event.from;
            if (event.kind == PathEventKind::fly) {
                ++flights;
                CHECK(glm::length(event.from - here) < 1e-9);
                here = event.to;
            }
            if (event.kind == PathEventKind::arrive) {
                ++arrivals;
                CHECK(glm::length(event.from - here) < 1e-9);
                const Segment& wall = stage.scene.segments[event.segment];
                CHECK(std::abs(cross(glm::normalize(wall.b - wall.a), event.from - wall.a)) < 1e-9);
            }
        }
        CHECK(flights > 48);
        CHECK(arrivals > 0);
    }
}

TEST_CASE("every path but a bare question to a light has one start and comes to one end") {
    const Stage stage(mixedRoom());
    for (const EstimatorInfo* info : recorded()) {
        CAPTURE(info->id);
        const PathRun run = runOf(*info, stage, deep(24));
        std::map<std::uint32_t, int> starts, ends, flights;
        for (const PathEvent& event : run.record.events) {
            starts[event.path] += event.kind == PathEventKind::start;
            flights[event.path] += event.kind == PathEventKind::fly;
            ends[event.path] += event.kind == PathEventKind::end || event.kind == PathEventKind::escape;
        }
        CHECK(starts.size() == run.record.paths);
        for (const auto& [path, count] : starts) {
            CHECK(count == 1);
            if (flights[path] > 0) CHECK(ends[path] == 1);
        }
    }
}

TEST_CASE("a full record leaves out whole paths, says so, and changes nothing else") {
    const Stage stage(litBox());
    for (const EstimatorInfo* info : recorded()) {
        CAPTURE(info->id);
        const PathRun whole = runOf(*info, stage, deep(64)), some = runOf(*info, stage, deep(64), 100);
        CHECK_FALSE(whole.record.truncated);
        CHECK(some.record.truncated);
        CHECK(some.estimate == whole.estimate);
        CHECK(some.record.paths == whole.record.paths);
        const auto& kept = some.record.events;
        REQUIRE(kept.size() >= 100);
        REQUIRE(kept.size() < whole.record.events.size());
        CHECK(whole.record.events[kept.size()].kind == PathEventKind::start);
    }
}

TEST_CASE("a run that is called off stops, and one that is refused says why") {
    const Stage stage(litBox());
    for (const EstimatorInfo* info : recorded()) {
        CAPTURE(info->id);
        CHECK_THROWS_AS(recordPaths(*info, stage.index, Probe{stage.at}, 0, deep(64), initialValues(*info),
                                    [] { return true; }),
                        Stopped);
    }
    Settings tooDeep;
    tooDeep.maxDepth = 100;
    const EstimatorInfo& bidirectional = *findEstimator("bidirectional");
    const PathRun run = runOf(bidirectional, stage, tooDeep);
    CHECK(run.refusal.find("64") != std::string::npos);
    CHECK(run.record.events.empty());
}

namespace {

/// What an eye in the corner of the room sees.
EyeStrip stripIn(const Scene& scene, std::uint32_t width = 16) {
    Vec2 low(1e9), high(-1e9);
    for (const Segment& wall : scene.segments)
        for (const Vec2& end : {wall.a, wall.b}) {
            low = glm::min(low, end);
            high = glm::max(high, end);
        }
    const Vec2 size = high - low;
    return {Eye{low + 0.2 * size, glm::normalize(0.6 * size), 1.2}, width};
}

}  // namespace

TEST_CASE("what the steps of a pixel's run add is the pixel, by every estimator") {
    for (const Scene& scene : {litBox(), mixedRoom()}) {
        const Stage stage(scene);
        const Sensor strip = stripIn(scene);
        for (const EstimatorInfo* info : recorded()) {
            CAPTURE(info->id);
            Rgb all{0.0};
            for (std::uint32_t pixel = 0; pixel < pixelCount(strip); ++pixel) {
                CAPTURE(pixel);
                const PathRun run =
                    recordPaths(*info, stage.index, strip, pixel, deep(64), initialValues(*info), {});
                REQUIRE(run.refusal.empty());
                CHECK(glm::length(sumOf(run.record) / double(run.divisor) - run.estimate) <=
                      1e-12 * glm::length(run.estimate));
                all += run.estimate;
            }
            CHECK(all.x > 0.0);
        }
    }
}

TEST_CASE("a pixel's run is to the bit what the strip's passes bring to this pixel") {
    const Stage stage(mixedRoom());
    const Sensor strip = stripIn(stage.scene);
    for (const std::string_view id : {"path", "light", "photon-map"}) {
        CAPTURE(id);
        const EstimatorInfo& info = *findEstimator(id);
        ParamValues params = initialValues(info);
        for (std::size_t i = 0; i < params.size(); ++i)
            if (info.params[i].name == "paths" || info.params[i].name == "photons") params[i] = 64;
        const Problem problem{.index = stage.index, .sensor = strip, .maxDepth = 3};
        const auto estimator = info.make(problem, params);
        const std::uint64_t passes = id == "path" ? 64 : 1;
        PixelStatistics whole;
        whole.reset(pixelCount(strip));
        for (std::uint64_t pass = 0; pass < passes; ++pass) {
            Picture picture(pixelCount(strip), Rgb(0.0));
            Counts counts;
            estimator->addPass(pass, picture, counts);
            whole.add(picture);
        }
        std::size_t lit = 0;
        for (std::uint32_t pixel = 0; pixel < pixelCount(strip); ++pixel) {
            CAPTURE(pixel);
            const PathRun run = recordPaths(info, stage.index, strip, pixel, deep(64), params, {});
            CHECK(run.estimate == whole[pixel].mean);
            lit += run.estimate != Rgb(0.0);
        }
        CHECK(lit > 8);
    }
}

TEST_CASE("a pixel that bidirectional records alone has the light that it has among others") {
    const Stage stage(mixedRoom());
    const Sensor strip = stripIn(stage.scene, 8);
    const EstimatorInfo& info = *findEstimator("bidirectional");
    const Problem problem{.index = stage.index, .sensor = strip, .maxDepth = 3};
    const auto estimator = info.make(problem, initialValues(info));
    PixelStatistics whole;
    whole.reset(pixelCount(strip));
    for (std::uint64_t pass = 100'000; pass < 104'000; ++pass) {
        Picture picture(pixelCount(strip), Rgb(0.0));
        Counts counts;
        estimator->addPass(pass, picture, counts);
        whole.add(picture);
    }
    for (const std::uint32_t pixel : {1u, 4u, 6u}) {
        CAPTURE(pixel);
        const PathRun run =
            recordPaths(info, stage.index, strip, pixel, deep(4000), initialValues(info), {}, 1000);
        REQUIRE(run.standardError);
        const Rgb error = glm::sqrt(*run.standardError * *run.standardError +
                                    whole[pixel].standardError() * whole[pixel].standardError());
        REQUIRE(error.x < 0.1 * whole[pixel].mean.x);
        CHECK(std::abs(run.estimate.x - whole[pixel].mean.x) < 4.0 * error.x);
    }
}

TEST_CASE("every find of a run has the word of its way") {
    const Stage stage(mixedRoom());
    const Sensor probe = Probe{stage.at}, strip = stripIn(stage.scene);
    for (const std::string_view id : {"path", "light", "bidirectional"}) {
        for (const Sensor* sensor : {&probe, &strip}) {
            CAPTURE(id);
            const EstimatorInfo& info = *findEstimator(id);
            const PathRun run =
                recordPaths(info, stage.index, *sensor, 0, deep(256), initialValues(info), {});
            PathWord word;
            std::map<std::string, int> words;
            std::size_t walls = 0;  // of a way that is joined: told by s and t alone
            for (const PathEvent& event : run.record.events) {
                const std::string found = word.of(event);
                CHECK(found.empty() == (event.value == Rgb(0.0)));
                if (found.empty()) continue;
                ++words[found];
                CHECK(found.front() == 'L');
                CHECK(found.back() == 'E');
                CHECK(found.find_first_not_of("DS", 1) == found.size() - 1);
                if (event.kind != PathEventKind::joined) continue;
                walls = event.s + event.t - 2;
                CHECK(found.size() == walls + 2);
            }
            CHECK(words.size() > 1);
        }
    }
}

TEST_CASE("a mirror on the way is an S, and the wall that asks a light a D") {
    // From the eye to a mirror, to the floor, which asks the bulb.
    const auto event = [](PathEventKind kind, std::uint32_t vertex, bool delta, double value) {
        PathEvent e;
        e.kind = kind;
        e.vertex = vertex;
        e.delta = delta;
        e.value = Rgb(value);
        return e;
    };
    PathWord word;
    CHECK(word.of(event(PathEventKind::start, 0, false, 0.0)).empty());
    CHECK(word.of(event(PathEventKind::arrive, 1, false, 0.0)).empty());
    CHECK(word.of(event(PathEventKind::depart, 1, true, 0.0)).empty());
    CHECK(word.of(event(PathEventKind::arrive, 2, false, 0.0)).empty());
    CHECK(word.of(event(PathEventKind::asked, 2, false, 1.0)) == "LDSE");
    CHECK(word.of(event(PathEventKind::depart, 2, false, 0.0)).empty());
    CHECK(word.of(event(PathEventKind::arrive, 3, false, 0.0)).empty());
    CHECK(word.of(event(PathEventKind::met, 3, false, 1.0)) == "LDSE");
    CHECK(word.walls() == "DDS");
    PathEvent sky = event(PathEventKind::met, 3, false, 1.0);
    sky.missed = true;
    CHECK(word.of(sky) == "LDDSE");
    CHECK(word.of(event(PathEventKind::start, 0, false, 0.0)).empty());
    CHECK(word.walls().empty());
}
