// Does the window's trade grow to its end, does its dial choose what the trade itself would, and is that
// tried?
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/instrument_stages.h"
#include "app/plot_tables.h"
#include "app/share_text.h"
#include "app/state_text.h"
#include "app/trade_words.h"
#include "lessons/lesson_file.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

AppState lampRoom() {
    return openLesson(courseLessons(), LessonRef{"trade", 6});
}

LightQuestion questionOf(const AppState& state, double effort) {
    LightQuestion asked;
    asked.id = 1;
    asked.scene = state.scene;
    asked.at = state.at;
    asked.settings = state.settings;
    asked.instruments.set(View::trade, true);
    asked.instrumentSettings = state.instruments;
    asked.effort = effort;
    return asked;
}

const TradeSoFar& tradeIn(const Rig& rig) {
    const TradeSoFar* trade = tradeOf(rig.state());
    REQUIRE(trade);
    return *trade;
}

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.kind == WidgetKind::text && widget.name.find(words) != std::string::npos) return true;
    return false;
}

InstrumentSettings wishing(const AppState& state, double error) {
    InstrumentSettings settings = state.instruments;
    settings.wish = Wish::error;
    settings.wishedError = error;
    settings.tradeCost = TradeCost::rays;
    return settings;
}

/// A dot that can be clicked, of a setting that does not make the pictures.
std::size_t clickable(Rig& rig) {
    const TradeReport& report = tradeIn(rig).report;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const Widget* dot = rig.session.widgets.find("Stage/setting " + report.cells[i].name);
        if (!dot || cellOnStage(rig.state(), tradeIn(rig)) == i) continue;
        const auto apart = [&](std::size_t k) {
            const Widget* other = rig.session.widgets.find("Stage/setting " + report.cells[k].name);
            return k == i || !other || std::abs(other->rect.centerX() - dot->rect.centerX()) > 4.0f ||
                   std::abs(other->rect.centerY() - dot->rect.centerY()) > 4.0f;
        };
        bool alone = true;
        for (std::size_t k = 0; k < report.cells.size(); ++k) alone = alone && apart(k);
        if (alone) return i;
    }
    FAIL("no dot stands alone");
    return 0;
}

}  // namespace

TEST_CASE("the trade grows by one setting at a time, and what is called off goes on where it was") {
    const AppState state = lampRoom();
    LightAnswer answer;
    answer.asked = questionOf(state, 1e-3);
    InstrumentCache cache;
    std::atomic<bool> cancelled{false};
    std::vector<std::size_t> done;
    const auto publish = [&] {
        done.push_back(answer.instruments.trade->done);
        CHECK(answer.instruments.trade->report.cells.size() == done.back());
        if (done.size() == 5) cancelled = true;
    };
    measureInstruments(answer, cache, cancelled, publish);
    CHECK(done == std::vector<std::size_t>{1, 2, 3, 4, 5});
    const TradeCell third = answer.instruments.trade->report.cells[2];
    cancelled = false;
    measureInstruments(answer, cache, cancelled, publish);
    const TradeSoFar& trade = *answer.instruments.trade;
    CHECK(trade.complete());
    CHECK(trade.settings > 30);
    for (std::size_t i = 0; i < trade.settings; ++i) CHECK(done[i] == i + 1);
    CHECK(trade.report.cells[2].seconds == third.seconds);
    CHECK(trade.report.cells[2].statistics.mean == third.statistics.mean);
    // Another place on the same wall is the same trade; another wall is another one.
    const auto before = answer.instruments.trade;
    answer.asked.at.t = 0.9;
    recallInstruments(answer, cache);
    CHECK(answer.instruments.trade == before);
    answer.asked.at.segment = 1;
    recallInstruments(answer, cache);
    CHECK(answer.instruments.trade == nullptr);
}

TEST_CASE("another wish measures nothing anew but what it chooses, and leaves the run as it is") {
    Rig rig(lampRoom());
    REQUIRE(tradeIn(rig).complete());
    const std::vector<TradeCell> before = tradeIn(rig).report.cells;
    const auto record = rig.state().answer->record;
    const auto profile = rig.state().answer->pictures.profile;
    rig.apply(SetEvent{3});
    for (const double wished : {0.3, 0.1, 0.02}) {
        CAPTURE(wished);
        rig.apply(SetInstruments{wishing(rig.state(), wished)});
        rig.settle();
        const TradeSoFar& trade = tradeIn(rig);
        CHECK(rig.state().answer->complete);
        CHECK(rig.state().answer->record == record);
        CHECK(rig.state().answer->pictures.profile == profile);
        CHECK(rig.state().playback.event == 3);
        REQUIRE(trade.report.cells.size() == before.size());
        for (std::size_t i = 0; i < before.size(); ++i)
            CHECK(trade.report.cells[i].seconds == before[i].seconds);
        const auto choice = choose(trade.report, {TradeCost::rays, wished});
        REQUIRE(choice);
        REQUIRE(checkOf(trade, *choice));
        CHECK(showsText(rig, trade.report.cells[choice->cell].name));
        const auto& outcome = checkOf(trade, *choice)->outcome;
        if (!outcome) continue;  // at this effort much is too long to be tried
        CHECK(outcome->runs >= 4);
        CHECK(outcome->rays == doctest::Approx(choice->rays).epsilon(0.2));
        CHECK(outcome->relativeError.value < 3.0 * wished);
        CHECK(showsText(rig, "Tried "));
    }
}

TEST_CASE("the dial is dragged and typed, and time is paid in seconds") {
    Rig rig(lampRoom());
    rig.driver.typeNumber("Stage/dial", "10");
    CHECK(rig.state().instruments.wishedError == doctest::Approx(0.1));
    rig.driver.dragBy("Stage/dial", 60, 0);
    CHECK(rig.state().instruments.wishedError > 0.1);
    rig.driver.typeNumber("Stage/dial", "0.0001");
    CHECK(rig.state().instruments.wishedError == kLeastWishedError);
    rig.driver.click("Stage/wish");
    rig.driver.frames(2);
    rig.driver.click("Stage/wish/time");
    rig.settle();
    CHECK(rig.state().instruments.wish == Wish::time);
    CHECK(rig.state().instruments.tradeCost == TradeCost::seconds);
    rig.driver.typeNumber("Stage/dial", "20");
    CHECK(rig.state().instruments.wishedMilliseconds == 20.0);
    rig.settle();
    const auto choice = choiceOf(rig.state(), tradeIn(rig));
    REQUIRE(choice);
    CHECK(choice->seconds <= 0.0201);
    CHECK(showsText(rig, "The least error in 20 ms"));
    rig.driver.click("Stage/axis");
    rig.driver.frames(2);
    rig.driver.click("Stage/axis/rays");
    CHECK(rig.state().instruments.tradeCost == TradeCost::rays);
    CHECK(choiceOf(rig.state(), tradeIn(rig))->seconds == choice->seconds);  // time stays what is wished
}

TEST_CASE("a click makes the pictures by a setting, another one as before, and a lock forbids it") {
    Rig rig(lampRoom());
    const Makers before = rig.state().makers;
    const std::size_t cell = clickable(rig);
    const std::string dot = "Stage/setting " + tradeIn(rig).report.cells[cell].name;
    rig.driver.click(dot);
    rig.settle();
    CHECK(rig.state().pickedTrade == cell);
    CHECK(rig.state().makers.first ==
          makerOf(tradeIn(rig).report.cells[cell].setting, rig.state().settings.maxDepth));
    CHECK(cellOnStage(rig.state(), tradeIn(rig)) == cell);
    CHECK(rig.state().answer->asked.makers == rig.state().makers);
    rig.driver.click(dot);
    CHECK_FALSE(rig.state().pickedTrade.has_value());
    CHECK(rig.state().makers == before);
    // The dial's own choice, by its button.
    rig.driver.click("Stage/Show its picture");
    rig.settle();
    CHECK(cellOnStage(rig.state(), tradeIn(rig)) == choiceOf(rig.state(), tradeIn(rig))->cell);
    rig.apply(ResetStep{});
    rig.settle();
    CHECK_FALSE(rig.state().pickedTrade.has_value());
    rig.session.state.rules.lock(Control::estimator);
    rig.driver.frames(2);
    rig.driver.click(dot);
    CHECK(rig.state().makers == before);
}

TEST_CASE("what the stage cannot make cannot be picked") {
    TradeSetting setting{findEstimator("path"), initialValues(*findEstimator("path")), 2};
    REQUIRE(makerOf(setting, 2));
    CHECK_FALSE(makerOf(setting, 2)->depth.has_value());
    CHECK(makerOf(setting, 5)->depth == 2);
    setting.facets = 2.0;
    CHECK_FALSE(makerOf(setting, 2));
    setting.facets = 1.0;
    setting.index = IndexMethod::grid;
    CHECK_FALSE(makerOf(setting, 2));
}

TEST_CASE("the wish goes along with the state, and comes from the lesson") {
    Rig rig(lampRoom());
    InstrumentSettings settings = rig.state().instruments;
    settings.wish = Wish::time;
    settings.wishedMilliseconds = 12.5;
    settings.tradeCost = TradeCost::seconds;
    rig.apply(SetInstruments{settings});
    const std::string text = shareText(rig.state());
    CHECK(openShared(courseLessons(), text).instruments == settings);
    Rig other(openLesson(courseLessons(), LessonRef{"gather", 1}));
    other.apply(OpenShared{text});
    CHECK(other.state().banner.empty());
    CHECK(other.state().instruments == settings);

    const SceneLoader loader = [&](const std::filesystem::path&) { return rig.state().scene->description; };
    const auto valuesOf = [&](const std::string& set) {
        return parseLesson(
                   "title = 'T'\nsection = 'S'\nscene = 's.toml'\n[[step]]\ntitle = 'A'\nprose = "
                   "'P'\n[step.set]\n" +
                       set,
                   "01-mine.toml", loader)
            .steps.front()
            .values.instruments;
    };
    CHECK(valuesOf("wishedError = 0.05").wish == Wish::error);
    CHECK(valuesOf("wishedError = 0.05").tradeCost == TradeCost::rays);
    CHECK(valuesOf("wishedError = 0.05\ntradeCost = 'seconds'").tradeCost == TradeCost::seconds);
    CHECK(valuesOf("wishedMilliseconds = 5").tradeCost == TradeCost::seconds);
    CHECK_THROWS_AS(valuesOf("tradeCost = 'money'"), InputError);
}

TEST_CASE("words and table tell each setting and what was chosen") {
    Rig rig(lampRoom());
    const TradeSoFar& trade = tradeIn(rig);
    const std::string words = tradeWords(rig.state());
    CHECK(stateText(rig.state()).find("What accuracy costs here") != std::string::npos);
    for (const TradeCell& cell : trade.report.cells)
        if (cell.measured()) CHECK(words.find(cell.name + ": ") != std::string::npos);
    CHECK(words.find(choiceWords(rig.state(), trade)) != std::string::npos);
    const std::string table = tradeTable(rig.state());
    CHECK(std::count(table.begin(), table.end(), '\n') ==
          1 + static_cast<std::ptrdiff_t>(trade.report.cells.size()));
    const auto commas = [&](std::size_t from) {
        return std::count(table.begin() + static_cast<std::ptrdiff_t>(from),
                          table.begin() + static_cast<std::ptrdiff_t>(table.find('\n', from)), ',');
    };
    std::size_t line = 0;
    for (std::size_t i = 0; i < trade.report.cells.size(); ++i) {
        line = table.find('\n', line) + 1;
        if (trade.report.cells[i].measured()) CHECK(commas(line) == commas(0));
    }
    AppState none = rig.state();
    none.answer.reset();
    const std::string head = tradeTable(none);
    CHECK(std::count(head.begin(), head.end(), '\n') == 1);
    CHECK(tradeWords(none) == "It is not known yet.");
}

TEST_CASE("a dark scene says so") {
    LightAnswer answer;
    answer.asked = questionOf(lampRoom(), 1e-3);
    const char* dark =
        "[material.m]\ntype = 'diffuse'\n[[segment]]\nname = 'floor'\na = [0, 0]\nb = [1, 0]\n"
        "material = 'm'\n[[segment]]\nname = 'top'\na = [1, 1]\nb = [0, 1]\nmaterial = 'm'\n";
    answer.asked.scene = std::make_shared<const PreparedScene>(parseScene(dark, "dark.toml", {}));
    InstrumentCache cache;
    std::atomic<bool> cancelled{false};
    measureInstruments(answer, cache, cancelled, [] {});
    REQUIRE(answer.instruments.trade);
    CHECK(answer.instruments.trade->complete());
    CHECK(answer.instruments.trade->refusal.find("no light") != std::string::npos);
    CHECK(tradeProgress(*answer.instruments.trade).find("Nothing is measured: no light") == 0);
    CHECK(answer.instruments.trade->report.cells.empty());
}
