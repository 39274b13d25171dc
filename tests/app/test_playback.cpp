// Does the recorded run go forward and back, one event at a time, without changing?
#include <doctest/doctest.h>

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
