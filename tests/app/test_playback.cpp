// Does the recorded run go forward and back, one event at a time, without changing?
#include <doctest/doctest.h>

#include <algorithm>

#include "app/run_text.h"
#include "app/step_text.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr const char* kStepping = "controls:8";

int lineNow(const Rig& rig) {
    const Event* event = currentEvent(rig.state());
    return event ? listingLine(event->kind) : 0;
}

}  // namespace

TEST_CASE("Step goes on by one event, Back returns to the very same, and the record stays as it is") {
    Rig rig(kStepping);
    const auto record = rig.state().answer->record;
    const std::uint64_t asked = rig.state().questionId;
    const std::size_t count = rig.state().eventCount();
    REQUIRE(count > 50);
    CHECK(rig.state().playback == Playback{true, 0, false, 0.0f});
    CHECK(currentEvent(rig.state()) == nullptr);

    std::vector<std::string> forward;
    const auto shown = [&] {
        const StepText text = describeStep(rig.state());
        return text.where + text.what + text.values;
    };
    constexpr std::size_t kSteps = 25;
    forward.push_back(shown());
    for (std::size_t k = 1; k <= kSteps; ++k) {
        rig.driver.click("Stage/Step");
        CHECK(rig.state().playback.event == k);
        CHECK(currentEvent(rig.state()) == &record->events[k - 1]);
        CHECK(lineNow(rig) == listingLine(record->events[k - 1].kind));
        forward.push_back(shown());
    }
    for (std::size_t k = kSteps; k-- > 0;) {
        rig.driver.click("Stage/Back");
        CHECK(rig.state().playback.event == k);
        CHECK(shown() == forward[k]);
    }
    rig.driver.click("Stage/Back");
    CHECK(rig.state().playback.event == 0);
    CHECK(rig.state().answer->record == record);
    CHECK(rig.state().questionId == asked);
}

TEST_CASE("Start and End lead to both ends, and no step leads past them") {
    Rig rig(kStepping);
    const std::size_t count = rig.state().eventCount();
    rig.driver.click("Stage/End");
    CHECK(rig.state().playback.event == count);
    rig.driver.click("Stage/Step");
    CHECK(rig.state().playback.event == count);
    rig.driver.click("Stage/Back");
    CHECK(rig.state().playback.event + 1 == count);
    rig.driver.click("Stage/Start");
    CHECK(rig.state().playback.event == 0);
}

TEST_CASE("a step that begins past the end of its run goes back from the end") {
    Rig rig(kStepping);
    rig.session.state.playback.event = 1'000'000;
    rig.driver.frames();
    rig.apply(StepEvents{-1});
    CHECK(rig.state().playback.event + 1 == rig.state().eventCount());
}

TEST_CASE("Play goes on by itself with the frames, pauses, and stops at the end") {
    Rig rig(kStepping);
    rig.driver.click("Stage/Play");
    CHECK(rig.state().playback.playing);
    const std::size_t before = rig.state().playback.event;
    rig.driver.frames(60);  // one second
    const std::size_t after = rig.state().playback.event;
    CHECK(after > before);
    CHECK(after < before + 60);
    rig.driver.click("Stage/Pause");
    CHECK_FALSE(rig.state().playback.playing);
    const std::size_t paused = rig.state().playback.event;
    rig.driver.frames(120);
    CHECK(rig.state().playback.event == paused);

    rig.apply(SetEvent{rig.state().eventCount() - 1});
    rig.apply(TogglePlay{});
    rig.driver.frames(120);
    CHECK(rig.state().playback.event == rig.state().eventCount());
    CHECK_FALSE(rig.state().playback.playing);
    rig.apply(TogglePlay{});
    rig.driver.frames(2);
    CHECK(rig.state().playback.playing);
    CHECK(rig.state().playback.event < rig.state().eventCount());
}

TEST_CASE("a click on a line leads on to the next event there, and round the end") {
    Rig rig(kStepping, 1280, 1000);
    const auto& events = rig.state().answer->record->events;
    for (const int line : {17, 21, 27}) {
        CAPTURE(line);
        const std::string name = "Stage/line 0" + std::to_string(line);
        rig.apply(SetEvent{0});
        std::size_t before = 0;
        for (int i = 0; i < 3; ++i) {
            rig.scrollTo(name, "Stage/line ");
            rig.driver.click(name);
            const std::size_t now = rig.state().playback.event;
            CHECK(now > before);
            CHECK(lineNow(rig) == line);
            for (std::size_t k = before; k + 1 < now; ++k) CHECK(listingLine(events[k].kind) != line);
            before = now;
        }
        rig.apply(SetEvent{events.size()});
        rig.apply(JumpToLine{line});
        CHECK(lineNow(rig) == line);
        CHECK(rig.state().playback.event < events.size());
    }
    const Playback before = rig.state().playback;
    rig.apply(JumpToLine{34});  // nothing is recorded there
    CHECK(rig.state().playback == before);
}

TEST_CASE("the lit line is in sight while stepping") {
    Rig rig(kStepping, 960, 600);
    const std::size_t count = rig.state().eventCount();
    for (std::size_t k = 1; k <= count; k += 3) {
        rig.apply(SetEvent{k});
        rig.driver.frames(2);
        const int line = lineNow(rig);
        CAPTURE(line);
        const Widget& lit =
            rig.driver.get((line < 10 ? "Stage/line 00" : "Stage/line 0") + std::to_string(line));
        CHECK(lit.target.height() > 0.9f * lit.rect.height());
    }
}

TEST_CASE("a new question starts the run again") {
    Rig rig(kStepping);
    rig.apply(SetEvent{9});
    Settings settings = rig.state().settings;
    ++settings.seed;
    rig.apply(SetSettings{settings});
    rig.settle();
    CHECK(rig.state().playback.event == 0);
    CHECK(rig.state().playback.stepping);
}

TEST_CASE("the runs of other estimators are stepped through as well, each with its own source") {
    Rig rig(kStepping);
    for (const Named<Run>& run : kRuns) {
        if (run.value == Run::castRay) continue;
        CAPTURE(run.name);
        rig.driver.click("Stage/run");
        rig.driver.click("Stage/run/" + std::string(run.name));
        rig.settle();
        REQUIRE(rig.state().run == run.value);
        REQUIRE(rig.state().answer->pathRun);
        const auto& events = rig.state().answer->pathRun->record.events;
        CHECK(rig.state().eventCount() == events.size());
        REQUIRE(events.size() > 20);
        CHECK(currentEvent(rig.state()) == nullptr);
        rig.driver.click("Stage/Start");
        CHECK(currentPathEvent(rig.state()) == nullptr);
        const Listing& listing = rig.session.listings.runs[static_cast<std::size_t>(run.value)];
        for (std::size_t k = 1; k <= 12; ++k) {
            rig.driver.click("Stage/Step");
            REQUIRE(currentPathEvent(rig.state()) == &events[k - 1]);
            const int line = lineOf(listing, events[k - 1].where);
            REQUIRE(line >= 0);
            CHECK(listing[static_cast<std::size_t>(line)].source > 0);
            const StepText words = describeStep(rig.state());
            CHECK_FALSE(words.what.empty());
            CHECK(words.values.find("nan") == std::string::npos);
        }
        rig.driver.click("Stage/Back");
        CHECK(currentPathEvent(rig.state()) == &events[10]);
        for (const PathEvent& event : events) CHECK(lineOf(listing, event.where) >= 0);
    }
}

TEST_CASE("a click on a line of an estimator's source goes on to the next step there") {
    Rig rig(kStepping);
    rig.apply(SetRun{Run::path});
    rig.settle();
    rig.apply(SetEvent{0});
    const auto& events = rig.state().answer->pathRun->record.events;
    const SourceLine where = events[5].where;
    rig.apply(JumpToSource{where, {where.file, where.line + 1}});
    const PathEvent* event = currentPathEvent(rig.state());
    REQUIRE(event != nullptr);
    CHECK(event->where.line == where.line);
    const std::size_t first = rig.state().playback.event;
    rig.apply(JumpToSource{where, {where.file, where.line + 1}});
    CHECK(rig.state().playback.event != first);
    rig.apply(JumpToSource{{where.file, 1}, {where.file, 2}});  // nothing is told there
    CHECK(rig.state().playback.event != first);
}

TEST_CASE("the slider leads to any step, also typed, and never past the end") {
    Rig rig(kStepping);
    const std::size_t count = rig.state().eventCount();
    const std::string slider = "Stage/scrub";
    const Rect target = rig.driver.get(slider).target;
    rig.driver.clickAt(target.left + 0.5f * target.width(), target.centerY());
    rig.driver.frames(2);
    CHECK(rig.state().playback.stepping);
    const double share = static_cast<double>(rig.state().playback.event) / static_cast<double>(count);
    CHECK(share == doctest::Approx(0.5).epsilon(0.05));
    rig.driver.dragTo(slider, target.right + 300, target.centerY());
    CHECK(rig.state().playback.event == count);
    rig.driver.typeNumber(slider, "7");
    CHECK(rig.state().playback.event == 7);
    rig.driver.typeNumber(slider, "999999999");
    CHECK(rig.state().playback.event == count);
}

TEST_CASE("Play goes as fast as is chosen, also by keys, and many steps a frame where they are due") {
    Rig rig(kStepping);
    for (const Named<PlaySpeed>& speed : kPlaySpeeds) {
        rig.apply(SetEvent{0});
        rig.apply(SetSpeed{speed.value});
        const float perSecond = kStepsPerSecond[static_cast<std::size_t>(speed.value)];
        rig.apply(TogglePlay{});
        const std::size_t before = rig.state().playback.event;
        rig.driver.frames(60);  // one second
        const std::size_t expected =
            std::min(before + static_cast<std::size_t>(perSecond), rig.state().eventCount());
        CHECK(rig.state().playback.event + 1 >= expected);
        CHECK(rig.state().playback.event <= expected + 1 + static_cast<std::size_t>(perSecond) / 60);
        if (rig.state().playback.playing) rig.apply(TogglePlay{});
    }
    CHECK(rig.state().speed == kPlaySpeeds.back().value);
    rig.driver.pressKey(Key::k);
    CHECK(rig.state().speed == kPlaySpeeds.back().value);
    for (std::size_t i = 0; i < kPlaySpeeds.size(); ++i) rig.driver.pressKey(Key::j);
    CHECK(rig.state().speed == kPlaySpeeds.front().value);
}
