// Can everything be found by a part of its name, and is only that offered which can be done?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "app/doable.h"
#include "app/fuzzy.h"
#include "app/key_help.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

bool offers(const AppState& state, std::string_view name) {
    const std::vector<Doable> all = doables(state);
    return std::any_of(all.begin(), all.end(), [&](const Doable& one) { return one.name == name; });
}

/// Whether any offered name begins so.
bool offersKind(const AppState& state, std::string_view beginning) {
    const std::vector<Doable> all = doables(state);
    return std::any_of(all.begin(), all.end(),
                       [&](const Doable& one) { return one.name.rfind(beginning, 0) == 0; });
}

std::string best(const AppState& state, std::string_view query) {
    const std::vector<Doable> entries = found(doables(state), query);
    return entries.empty() ? "" : entries.front().name;
}

void open(Rig& rig) {
    rig.driver.pressKey(Key::ctrl, Key::k);
    rig.driver.frames(2);
    REQUIRE(rig.state().palette.shown);
}

/// What the keys and the list of commands both change, and what one could see of it.
struct Seen {
    std::optional<std::string> lesson;
    std::size_t step;
    SceneDescription scene;
    Settings settings;
    WallPoint at;
    Playback playback;
    ViewSet show;
    Makers makers;
    bool unlockAll, editing, snap, fit, canvasHidden, answerShown, helpShown, filesShown;
    Selection selected;
    Camera camera;
    Pane pane;
    float uiScale;
    std::string banner;
    std::optional<std::uint32_t> pinnedPixel;
    bool largestFirst;
    bool operator==(const Seen&) const = default;
};

Seen seen(const AppState& s) {
    return {s.lesson ? std::optional(s.lesson->slug) : std::nullopt,
            s.step,
            s.scene->description,
            s.settings,
            s.at,
            s.playback,
            s.show,
            s.makers,
            s.unlockAll,
            s.editing.on,
            s.editing.snap,
            s.fitCamera,
            s.canvasHidden,
            s.answerShown,
            s.helpShown,
            s.files.shown,
            s.editing.selected,
            s.camera,
            s.pane,
            s.uiScale,
            s.banner,
            s.pinnedPixel,
            s.largestFirst};
}

/// Presses what the help calls a key: "Ctrl Z", "Page Down, N", "Shift V", "3".
void press(Rig& rig, std::string_view words) {
    words = words.substr(0, words.find(", "));
    std::optional<Key> held;
    for (const auto& [name, key] : {std::pair{"Ctrl ", Key::ctrl}, std::pair{"Shift ", Key::shift}})
        if (words.rfind(name, 0) == 0) {
            held = key;
            words.remove_prefix(std::string_view(name).size());
        }
    constexpr std::pair<std::string_view, Key> kNames[] = {{"Page Down", Key::pageDown},
                                                           {"Page Up", Key::pageUp},
                                                           {"\u2192", Key::right},
                                                           {"\u2190", Key::left},
                                                           {"\u2191", Key::up},
                                                           {"\u2193", Key::down},
                                                           {"Space", Key::space},
                                                           {"Home", Key::home},
                                                           {"End", Key::end},
                                                           {"Delete", Key::del},
                                                           {"Escape", Key::escape},
                                                           {"F1", Key::f1},
                                                           {"+", Key::equal},
                                                           {"-", Key::minus}};
    std::optional<Key> key;
    for (const auto& [name, one] : kNames)
        if (words == name) key = one;
    if (!key && words.size() == 1) {
        const int c = std::toupper(static_cast<unsigned char>(words[0]));
        if (c >= 'A' && c <= 'Z') key = static_cast<Key>(static_cast<int>(Key::a) + c - 'A');
        if (c >= '0' && c <= '9') key = static_cast<Key>(static_cast<int>(Key::digit0) + c - '0');
    }
    REQUIRE_MESSAGE(key, "no key is called ", std::string(words));
    if (held)
        rig.driver.pressKey(*held, *key);
    else
        rig.driver.pressKey(*key);
}

/// A state in which much can be done, the same each time.
AppState busy(const LessonsCopy& folder, bool editing) {
    AppState state = openLesson(folder.folder, LessonRef{"controls", 3});
    apply(state, UnlockAll{true});
    apply(state, SetEditing{editing});
    state.editing.path = (folder.folder / "mine.toml").string();
    if (editing) {
        apply(state, SelectThings{Thing{ThingKind::shape, 0}});
        apply(state, ActOnSelected{EditAct::copy});
        apply(state, ActOnSelected{EditAct::copy});
        apply(state, Undo{});
    }
    return state;
}

}  // namespace

TEST_CASE("letters are found in their order, starts of words and runs first") {
    CHECK(fuzzyScore("", "anything") == 0);
    CHECK(fuzzyScore("gth", "Gather the light"));
    CHECK_FALSE(fuzzyScore("htg", "Gather the"));
    CHECK_FALSE(fuzzyScore("gatherer", "gather"));
    CHECK(fuzzyScore("GATHER", "gather") == fuzzyScore("gather", "GATHER"));
    CHECK(*fuzzyScore("nst", "next step") > *fuzzyScore("nst", "in a list"));
    CHECK(*fuzzyScore("seed", "next seed") > *fuzzyScore("seed", "some red edge"));
    CHECK(*fuzzyScore("cast", "castRay") > *fuzzyScore("cast", "broadcast"));
    CHECK(fuzzyScore("light gather", "Gather the light"));  // each word by itself
    CHECK_FALSE(fuzzyScore("light dark", "Gather the light"));
    CHECK(fuzzyScore("\u0398", "light against \u03b8"));
    CHECK(fuzzyScore("\u00e4ther", "der \u00c4ther"));
    CHECK_FALSE(fuzzyScore("\u03b8", "theta"));
}

TEST_CASE("a whole word comes before a part of one, wherever they stand") {
    const FuzzyQuery query("samples");
    CHECK(*fuzzyScore(query, "Show samples: the list") > *fuzzyScore(query, "Sampler: stratified"));
    CHECK(*fuzzyScore(query, "the samples") > *fuzzyScore(query, "the samplesque"));
}

TEST_CASE("the letters that were met are told, the best way to meet them") {
    CHECK(fuzzyPlaces("st", "last step") == std::vector<std::size_t>{5, 6});
    CHECK(fuzzyPlaces("\u03b8x", "a \u03b8 x") == std::vector<std::size_t>{2, 5});
    CHECK(fuzzyPlaces("b a", "a b") == std::vector<std::size_t>{0, 2});
    CHECK(fuzzyPlaces("z", "abc").empty());
}

TEST_CASE("queries that nobody would type are harmless") {
    for (const std::string& query :
         {std::string(10'000, 'a'), std::string(10'000, ' '), std::string("\xff\xfe\xc0\x80\xed\xa0\x80"),
          std::string(5'000, '\xce'), std::string("a\0b", 3)}) {
        CHECK_FALSE(fuzzyScore(query + "a", "next step").has_value());
        fuzzyPlaces(query, query);
    }
    std::string words;
    for (int i = 0; i < 5'000; ++i) words += "a ";
    CHECK_FALSE(fuzzyScore(words, "a").has_value());
    CHECK(fuzzyScore("aaaa", std::string(10'000, 'a')));
}

TEST_CASE("things are found and done by keys alone") {
    Rig rig("controls:1");
    open(rig);
    rig.driver.typeText("eve larg");
    rig.driver.pressKey(Key::enter);
    CHECK_FALSE(rig.state().palette.shown);
    CHECK(rig.state().uiScale == 1.25f);
    open(rig);
    CHECK(rig.state().palette.query.empty());
    rig.driver.typeText("change depth");
    rig.driver.frames(2);
    rig.driver.pressKey(Key::enter);
    CHECK(rig.state().currentStep()->title == "Change depth");
}

TEST_CASE("the list opens with the first entry selected, and the arrows lead round it") {
    Rig rig("controls:2");
    open(rig);
    const std::size_t count = doables(rig.state()).size();
    REQUIRE(count > 20);
    CHECK(rig.state().palette.selected == 0);
    rig.driver.pressKey(Key::up);
    CHECK(rig.state().palette.selected == count - 1);
    const std::string last = doables(rig.state()).back().name;
    rig.driver.frames(2);
    CHECK(rig.driver.get("Commands/" + last).target.height() > 10);  // scrolled to
    rig.driver.pressKey(Key::down);
    rig.driver.pressKey(Key::down);
    CHECK(rig.state().palette.selected == 1);
    rig.driver.typeText("s");
    CHECK(rig.state().palette.selected == 0);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().palette.shown);
    CHECK(rig.state().step == 1);
}

TEST_CASE("an entry is clicked, and a click beside the list closes it and does nothing else") {
    Rig rig("controls:1");
    open(rig);
    rig.driver.click("Commands/Next step");
    CHECK(rig.state().step == 1);
    CHECK_FALSE(rig.state().palette.shown);
    open(rig);
    const Rect next = rig.driver.get("Lesson/Next").target;
    rig.driver.clickAt(next.centerX(), next.centerY());
    CHECK_FALSE(rig.state().palette.shown);
    CHECK(rig.state().step == 1);
}

TEST_CASE("the list opens out of a text field, too, and the field keeps what it had") {
    Rig rig("controls:1");
    rig.driver.click("Stage/Edit");
    rig.driver.frames(2);
    rig.driver.click("Controls/file");
    rig.driver.pressKey(Key::end);
    const std::string before = rig.state().editing.path;
    open(rig);
    rig.driver.typeText("tool wall");
    CHECK(rig.state().palette.query == "tool wall");
    rig.driver.pressKey(Key::enter);
    CHECK(rig.state().editing.tool == Tool::wall);
    CHECK(rig.state().editing.path == before);
}

TEST_CASE("keys of the program are letters while the list is open") {
    Rig rig("controls:2");
    const Seen before = seen(rig.state());
    open(rig);
    for (const Key key : {Key::n, Key::u, Key::x, Key::g, Key::right, Key::home, Key::s, Key::space})
        rig.driver.pressKey(key);
    rig.driver.typeText("zzzz?");
    rig.driver.pressKey(Key::enter);
    CHECK_FALSE(rig.state().palette.shown);
    CHECK(seen(rig.state()) == before);
}

TEST_CASE("a hostile query is typed into the list and closed again") {
    Rig rig("controls:1");
    open(rig);
    std::string query;
    while (query.size() < 10'000) query += "a\u03b8\U0001F600 \uFFFD";
    for (std::size_t at = 0; at < query.size(); at += 500) {
        rig.apply(SetQuery{query.substr(0, at)});  // cut anywhere, also within a character
        CHECK(rig.state().palette.shown);
    }
    rig.driver.typeText("\u03b8\u2192x");
    rig.driver.pressKey(Key::down);
    rig.driver.pressKey(Key::up);
    rig.driver.pressKey(Key::enter);
    rig.driver.frames(2);
    CHECK_FALSE(rig.state().palette.shown);
    rig.apply(ShowPalette{true});
    rig.apply(SelectEntry{SIZE_MAX});
    rig.driver.pressKey(Key::down);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().palette.shown);
}

TEST_CASE("ten thousand typed characters are harmless") {
    Rig rig("controls:1");
    open(rig);
    for (int i = 0; i < 10'000; ++i) rig.host->queue(Character{U'q'});
    while (rig.host->hasQueuedInput()) rig.driver.frames();
    CHECK(rig.state().palette.query.size() == 10'000);
    rig.driver.pressKey(Key::enter);
    CHECK_FALSE(rig.state().palette.shown);
}

TEST_CASE("every step of every lesson is found by its title") {
    const AppState state = openLesson(courseLessons(), std::nullopt);
    std::size_t steps = 0;
    const std::vector<Doable> all = doables(state);
    for (const LessonEntry& entry : state.lessons) {
        REQUIRE(entry.error.empty());
        REQUIRE(entry.stepTitles.size() == static_cast<std::size_t>(entry.steps));
        for (std::size_t step = 0; step < entry.stepTitles.size(); ++step, ++steps) {
            const std::vector<Doable> entries = found(all, entry.title + " " + entry.stepTitles[step]);
            REQUIRE_FALSE(entries.empty());
            const auto* go = std::get_if<GoTo>(&entries.front().command);
            CAPTURE(entries.front().name);
            REQUIRE(go);
            CHECK(go->lesson == entry.slug);
            CHECK(go->step == step);
        }
    }
    CHECK(steps > 60);
    AppState broken = openLesson(testLessons(), LessonRef{"controls", 1});
    CHECK_FALSE(offersKind(broken, "3.1"));
}

TEST_CASE("what the step locks is not offered, and Unlock all offers it") {
    AppState state = openLesson(testLessons(), LessonRef{"controls", 9});  // unlocks none of these
    for (const bool unlocked : {false, true}) {
        apply(state, UnlockAll{unlocked});
        CAPTURE(unlocked);
        for (const char* kind : {"Double N", "One scattering more", "Next seed",
                                 "Sampler:", "Emitters:", "Defect ", "P onto", "Show histogram"})
            CHECK_MESSAGE(offersKind(state, kind) == unlocked, kind);
    }
    CHECK_FALSE(offersKind(state, "Tool:"));
    apply(state, SetEditing{true});
    CHECK(offersKind(state, "Tool:"));
    CHECK_FALSE(offersKind(state, "Copy what"));
    CHECK_FALSE(offers(state, "Undo"));
    apply(state, SelectThings{Thing{ThingKind::shape, 0}});
    CHECK(offersKind(state, "Copy what"));
    CHECK(offersKind(state, "Material:"));
    apply(state, ActOnSelected{EditAct::copy});
    CHECK(offers(state, "Undo"));
}

TEST_CASE("estimators and their choices are offered where they are unlocked and a picture is shown") {
    AppState state = openLesson(testLessons(), LessonRef{"controls", 1});
    CHECK_FALSE(offersKind(state, "Estimator:"));
    apply(state, UnlockAll{true});
    apply(state, SetView{View::field, false});
    apply(state, SetView{View::eye, false});
    apply(state, SetView{View::profile, false});
    CHECK_FALSE(offersKind(state, "Estimator:"));
    apply(state, SetView{View::field, true});
    apply(state, SetMakers{{makerOf("path"), std::nullopt}});
    CHECK(offers(state, "Estimator: light"));
    CHECK_FALSE(offers(state, "Estimator: path"));
    std::size_t choices = 0;
    for (const Doable& one : doables(state)) {
        if (one.name.rfind("path: ", 0) != 0) continue;
        AppState after = state;
        apply(after, one.command);
        CHECK_FALSE(after.makers == state.makers);
        ++choices;
    }
    CHECK(choices > 0);
    apply(state, SetMakers{{makerOf("path"), makerOf("light")}});
    CHECK(offers(state, "Second estimator: path"));
    CHECK(offers(state, "Compare: one estimator again"));
}

TEST_CASE("what the class rules lock or hide is not offered") {
    ClassRules rules;
    addLock(rules, "samples=5");
    addLock(rules, "sampler");
    addHidden(rules, "grid");
    AppState state = openLesson(testLessons(), LessonRef{"controls", 2});
    setRules(state, rules);
    apply(state, UnlockAll{true});
    CHECK_FALSE(offers(state, "Double N"));
    CHECK_FALSE(offersKind(state, "Sampler:"));
    CHECK_FALSE(offersKind(state, "Show grid"));
    CHECK(offers(state, "Next seed"));
}

TEST_CASE("in a kiosk only that is offered which a kiosk allows") {
    AppState state = openLesson(testLessons(), LessonRef{"controls", 2});
    remember(state.recent, testLessons() / "scenes/field.toml");
    CHECK(offersKind(state, "2.1"));
    CHECK(offersKind(state, "Open /"));
    ClassRules rules;
    rules.kiosk = true;
    setRules(state, rules);
    const std::vector<Doable> all = doables(state);
    for (const Doable& one : all) {
        CAPTURE(one.name);
        CHECK_FALSE(isForbidden(state, one.command));
        AppState after = state;
        apply(after, one.command);
        CHECK(after.lesson->slug == state.lesson->slug);
        CHECK(after.scene == state.scene);
        CHECK_FALSE(after.editing.on);
        CHECK_FALSE(after.unlockAll);
        CHECK_FALSE(after.files.shown);
    }
    CHECK_FALSE(offersKind(state, "2.1"));
    CHECK(offersKind(state, "1.3"));
    CHECK_FALSE(offersKind(state, "Open "));
    CHECK_FALSE(offersKind(state, "Edit"));
    CHECK_FALSE(offersKind(state, "Unlock"));
}

TEST_CASE("all that is offered changes something, and none of it fails") {
    const LessonsCopy folder;
    for (const bool editing : {false, true}) {
        Rig rig(busy(folder, editing));
        for (const Doable& one : doables(rig.state())) {
            CAPTURE(one.name);
            AppState after = rig.state();
            apply(after, one.command);
            CHECK(after.banner.empty());
            const bool changed =
                !(seen(after) == seen(rig.state())) || after.editing.tool != rig.state().editing.tool ||
                after.run != rig.state().run || after.exportWished != rig.state().exportWished ||
                after.editing.savedAs != rig.state().editing.savedAs;
            const bool again = one.name.rfind("Reset", 0) == 0 || one.name.rfind("Fit", 0) == 0 ||
                               one.name.rfind("Small screen", 0) == 0 || one.name.rfind("1.3", 0) == 0 ||
                               one.name.rfind("First step", 0) == 0 || one.name.rfind("Copy all", 0) == 0 ||
                               one.name.rfind("Save", 0) == 0 || one.name.rfind("Material: ", 0) == 0 ||
                               one.name.rfind("Select ", 0) == 0;
            CHECK((changed || again));
        }
    }
}

TEST_CASE("the key beside an entry does the same as the entry") {
    const LessonsCopy folder;
    std::size_t keys = 0;
    for (const bool editing : {false, true}) {
        std::vector<Doable> all;
        {
            Rig rig(busy(folder, editing));
            all = doables(rig.state());
        }
        for (const Doable& one : all) {
            if (one.key.empty()) continue;
            // With something selected the arrows move it.
            if (editing &&
                (one.key == "\u2192" || one.key == "\u2190" || one.key == "\u2191" || one.key == "\u2193"))
                continue;
            CAPTURE(one.name);
            CAPTURE(one.key);
            Rig byKey(busy(folder, editing)), byEntry(busy(folder, editing));
            press(byKey, one.key);
            byEntry.apply(one.command);
            byKey.settle();
            byEntry.settle();
            Seen a = seen(byKey.state()), b = seen(byEntry.state());
            a.playback.sinceLast = b.playback.sinceLast = 0.0f;
            if (a.playback.playing) a.playback.event = b.playback.event = 0;
            CHECK(a == b);
            ++keys;
        }
    }
    CHECK(keys > 30);
}

TEST_CASE("what one wants is found by what one would type") {
    AppState state = openLesson(courseLessons(), LessonRef{"gather", 1});
    apply(state, UnlockAll{true});
    CHECK(best(state, "cosine") == "Sampler: cosine");
    CHECK(best(state, "sco") == "Sampler: cosine");
    CHECK(best(state, "next seed") == "Next seed");
    CHECK(best(state, "help") == "Help: all keys");
    CHECK(best(state, "caustic") == "Lesson 13: The caustic");
    CHECK(best(state, "edit") == "Edit the scene");
    CHECK(best(state, "fit") == "Fit the scene into the canvas");
    CHECK(best(state, "").rfind("Next step", 0) == 0);
    CHECK(best(state, "no such thing at all").empty());
}

TEST_CASE("what was typed before is not undone into another query") {
    const LessonsCopy folder;
    Rig rig(busy(folder, false));
    rig.driver.pressKey(Key::ctrl, Key::k);
    rig.driver.frames(2);
    rig.driver.typeText("a long query");
    rig.driver.frames(2);
    CHECK(rig.state().palette.query == "a long query");
    for (int i = 0; i < 4; ++i) rig.driver.pressKey(Key::backspace);
    rig.apply(ShowPalette{false});
    rig.driver.frames(2);
    rig.driver.pressKey(Key::ctrl, Key::k);
    rig.driver.frames(2);
    for (int i = 0; i < 20; ++i) rig.driver.pressKey(Key::ctrl, Key::z);
    CHECK(rig.state().palette.shown);
    CHECK(rig.state().palette.query.empty());
}

TEST_CASE("a query that is no text can be taken away letter by letter") {
    const LessonsCopy folder;
    Rig rig(busy(folder, false));
    rig.apply(ShowPalette{true});
    rig.apply(SetQuery{std::string("\xff\xfe", 2) + "\u03b8" + "\U0001F600" + std::string(1, '\xc3')});
    rig.driver.frames(3);
    rig.driver.typeText("x");
    for (int i = 0; i < 8; ++i) rig.driver.pressKey(Key::backspace);
    rig.driver.frames(2);
    CHECK(rig.state().palette.shown);
    CHECK(rig.state().palette.query.empty());
}
