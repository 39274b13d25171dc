// Does a recorded run tell all that an estimator found, step by step, and nothing that it did not?
#include <doctest/doctest.h>

#include <map>
#include <numeric>

#include "core/path_run.h"
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
    return recordPaths(info, stage.index, stage.at, settings, initialValues(info), {}, limit);
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
        CHECK_THROWS_AS(
            recordPaths(*info, stage.index, stage.at, deep(64), initialValues(*info), [] { return true; }),
            Stopped);
    }
    Settings tooDeep;
    tooDeep.maxDepth = 100;
    const EstimatorInfo& bidirectional = *findEstimator("bidirectional");
    const PathRun run = runOf(bidirectional, stage, tooDeep);
    CHECK(run.refusal.find("64") != std::string::npos);
    CHECK(run.record.events.empty());
}
