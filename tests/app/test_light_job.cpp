// Is the light behind the frame always at the latest question, and does it give up in time?
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <set>

#include "app/light_job.h"
#include "app/light_stages.h"
#include "core/estimate.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

std::shared_ptr<const PreparedScene> box() {
    return std::make_shared<const PreparedScene>(loadScene(testLessons() / "scenes/box.toml"));
}

LightQuestion question(std::uint64_t id, const std::shared_ptr<const PreparedScene>& scene,
                       std::uint32_t samples = 8, std::uint32_t depth = 1) {
    LightQuestion asked{id, scene, {0, 0.25}, {}};
    asked.settings.samples = samples;
    asked.settings.maxDepth = depth;
    asked.settings.seed = id;
    return asked;
}

/// One run by the estimator itself.
Rgb runOf(const LightQuestion& asked) {
    NoObserver observer;
    std::uint64_t rays = 0;
    const SegmentIndex& index = asked.scene->index;
    return gatherOnce(index, shadedPointOn(index, asked.at.segment, asked.at.t), asked.settings, 0,
                      SampleRange::all(asked.settings.samples), observer, rays)
        .total();
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST_CASE("before a question there is no answer, and nothing to wait for") {
    const LightJob job;
    CHECK(job.latest() == nullptr);
    CHECK(job.idle());
    job.waitUntilIdle();
}

TEST_CASE("a question is answered completely") {
    LightJob job;
    const LightQuestion asked = question(1, box());
    job.ask(asked);
    job.waitUntilIdle();
    CHECK(job.idle());
    const auto answer = job.latest();
    REQUIRE(answer);
    CHECK(answer->complete);
    CHECK(answer->asked.id == 1);
    CHECK(answer->estimate.total() == runOf(asked));
    CHECK(answer->contributions.size() == asked.settings.samples);
    REQUIRE(answer->exact);
    CHECK(answer->runs.count > 1);
    // Many independent runs agree with the quadrature, and the plot's errors fall with N.
    const double error = std::sqrt(gray(answer->runs.variance()) / static_cast<double>(answer->runs.count));
    CHECK(std::abs(gray(answer->runs.mean) - gray(*answer->exact)) < 5 * error);
    REQUIRE(answer->errors.size() > 3);
    CHECK(answer->errors.back().rms < answer->errors.front().rms);
}

TEST_CASE("of many quick questions the last one is answered, and no answer is another question's") {
    const auto scene = box();
    LightJob job;
    constexpr std::uint64_t kQuestions = 400;
    std::uint64_t newest = 0;
    for (std::uint64_t id = 1; id <= kQuestions; ++id) {
        job.ask(question(id, scene));
        const auto answer = job.latest();
        if (!answer || answer->asked.id == newest) continue;
        CHECK(answer->asked.id > newest);
        CHECK(answer->asked.id <= id);
        newest = answer->asked.id;
        CHECK(answer->estimate.total() == runOf(answer->asked));
    }
    job.waitUntilIdle();
    CHECK(job.latest()->asked.id == kQuestions);
    CHECK(job.latest()->complete);
    CHECK(job.latest()->estimate.total() == runOf(question(kQuestions, scene)));
}

TEST_CASE("a long run is given up for a newer question, and never published") {
    const auto scene = box();
    LightJob job;
    const LightQuestion slow = question(1, scene, 4096, 1);  // millions of rays
    REQUIRE_FALSE(isQuick(slow));
    REQUIRE(raysPerRepeat(scene->index, slow.settings) < kMostRaysPerRun);
    job.ask(slow);
    job.ask(question(2, scene));
    job.waitUntilIdle();
    CHECK(job.latest()->asked.id == 2);
    CHECK(job.latest()->complete);
}

TEST_CASE("a question that would take too many rays is answered at once with their number") {
    const auto scene = box();
    LightJob job;
    const LightQuestion asked = question(1, scene, 4096, 8);
    const auto start = std::chrono::steady_clock::now();
    job.ask(asked);
    job.waitUntilIdle();
    CHECK(secondsSince(start) < 1.0);
    const auto answer = job.latest();
    CHECK(answer->tooManyRays);
    CHECK(answer->complete);
    CHECK(answer->record == nullptr);
    CHECK(static_cast<double>(answer->rays) > kMostRaysPerRun);
    job.ask(question(2, scene));
    job.waitUntilIdle();
    CHECK_FALSE(job.latest()->tooManyRays);
}

TEST_CASE("the end of the program does not wait for a long run") {
    const auto scene = box();
    for (const std::uint32_t depth : {0u, 1u, 2u}) {
        CAPTURE(depth);
        auto job = std::make_unique<LightJob>();
        job->ask(question(1, scene, depth == 2 ? 512 : 4096, depth));
        const auto start = std::chrono::steady_clock::now();
        job.reset();
        CHECK(secondsSince(start) < 2.0);  // the run itself would take many times as long
    }
}

TEST_CASE("while P is dragged in every frame pictures keep coming") {
    Rig rig("controls:1");
    rig.session.state.settings.samples = 64;
    rig.session.state.settings.maxDepth = 2;
    REQUIRE(isQuick({0, rig.state().scene, rig.state().at, rig.state().settings}));
    std::set<std::uint64_t> pictures;
    const auto start = std::chrono::steady_clock::now();
    constexpr double kMostSeconds = 30.0;
    constexpr std::size_t kEnough = 5;
    int frames = 0;
    // A new question in every frame, without a pause: the light never catches up.
    while (pictures.size() < kEnough && secondsSince(start) < kMostSeconds) {
        ++frames;
        rig.apply(MovePoint{{0, 0.1 + 0.0001 * (frames % 8000)}});
        REQUIRE(rig.state().answer);
        pictures.insert(rig.state().answer->asked.id);
    }
    CHECK(pictures.size() >= kEnough);
    CHECK(static_cast<std::size_t>(frames) > pictures.size());
}

TEST_CASE("the same question gives the same answer") {
    const auto scene = box();
    const auto answerTo = [&](const LightQuestion& asked) {
        LightJob job;
        job.ask(asked);
        job.waitUntilIdle();
        return job.latest();
    };
    const auto a = answerTo(question(7, scene)), b = answerTo(question(7, scene));
    CHECK(a->estimate.total() == b->estimate.total());
    CHECK(a->histogramOf == b->histogramOf);
    REQUIRE(a->errors.size() == b->errors.size());
    for (std::size_t i = 0; i < a->errors.size(); ++i) CHECK(a->errors[i].rms == b->errors[i].rms);
    CHECK(*a->exact == *b->exact);
}
