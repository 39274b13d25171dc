// Does every key that the help lists do what it says, and is every key in the help?
#include <doctest/doctest.h>

#include "rig.h"

using namespace halfdisk;

namespace {

AppState& state(Rig& rig) {
    return rig.session.state;
}

/// Opens a step with everything unlocked.
void begin(Rig& rig, std::size_t step) {
    rig.apply(GoTo{"controls", step});
    rig.apply(UnlockAll{true});
    rig.settle();
}

void lessonStep(Rig& rig) {
    begin(rig, 3);
    for (const Key key : {Key::pageDown, Key::n}) {
        const std::size_t before = state(rig).step;
        rig.driver.pressKey(key);
        CHECK(state(rig).step == before + 1);
    }
}

void lessonStepBack(Rig& rig) {
    begin(rig, 3);
    for (const Key key : {Key::pageUp, Key::b}) {
        const std::size_t before = state(rig).step;
        rig.driver.pressKey(key);
        CHECK(state(rig).step + 1 == before);
    }
}

void reset(Rig& rig) {
    begin(rig, 2);
    state(rig).settings.samples = 77;
    rig.driver.pressKey(Key::r);
    CHECK(state(rig).settings == state(rig).currentStep()->values.settings);
}

void speed(Rig& rig) {
    begin(rig, 2);
    const PlaySpeed before = state(rig).speed;
    rig.driver.pressKey(Key::k);
    CHECK(state(rig).speed > before);
    rig.driver.pressKey(Key::j);
    CHECK(state(rig).speed == before);
}

void samplerAndEmitters(Rig& rig) {
    begin(rig, 2);
    const Settings before = state(rig).settings;
    rig.driver.pressKey(Key::m);
    CHECK(state(rig).settings.sampler != before.sampler);
    rig.driver.pressKey(Key::e);
    CHECK(state(rig).settings.emitters != before.emitters);
    for (std::size_t i = 1; i < kSamplers.size(); ++i) rig.driver.pressKey(Key::m);
    for (std::size_t i = 1; i < kEmitters.size(); ++i) rig.driver.pressKey(Key::e);
    CHECK(state(rig).settings == before);
}

void defects(Rig& rig) {
    begin(rig, 2);
    rig.driver.pressKey(Key::digit3);
    CHECK(state(rig).settings.defects.has(Defect::pdf));
    rig.driver.pressKey(Key::digit3);
    rig.driver.pressKey(Key::digit0);
    CHECK(state(rig).settings.defects == DefectSet::all());
    rig.driver.pressKey(Key::digit7);
    CHECK_FALSE(state(rig).settings.defects.has(Defect::offset));
}

void nextLesson(Rig& rig) {
    begin(rig, 2);
    const std::string before = state(rig).lesson->slug;
    rig.driver.pressKey(Key::l);
    CHECK(state(rig).lesson->slug != before);
    CHECK(state(rig).step == 0);
}

void zoomAndPan(Rig& rig) {
    begin(rig, 2);
    const Camera before = state(rig).camera;
    rig.driver.pressKey(Key::equal);
    CHECK(state(rig).camera.pixelsPerMeter > before.pixelsPerMeter);
    CHECK(state(rig).camera.center == before.center);
    rig.driver.pressKey(Key::minus);
    CHECK(state(rig).camera.pixelsPerMeter == doctest::Approx(before.pixelsPerMeter));
    rig.driver.pressKey(Key::ctrl, Key::right);
    CHECK(state(rig).camera.center.x > before.center.x);
}

void panes(Rig& rig) {
    begin(rig, 2);
    for (const Pane pane : {Pane::stage, Pane::controls, Pane::lesson}) {
        rig.driver.pressKey(Key::p);
        CHECK(state(rig).pane == pane);
    }
    rig.driver.pressKey(Key::c);
    CHECK(state(rig).canvasHidden);
}

void arrows(Rig& rig) {
    begin(rig, 7);
    rig.driver.pressKey(Key::right);
    rig.driver.pressKey(Key::right);
    CHECK(state(rig).playback.event == 2);
    rig.driver.pressKey(Key::left);
    CHECK(state(rig).playback.event == 1);
}

void tenAtOnce(Rig& rig) {
    begin(rig, 7);
    rig.driver.pressKey(Key::shift, Key::right);
    CHECK(state(rig).playback.event == 10);
    rig.driver.pressKey(Key::shift, Key::left);
    CHECK(state(rig).playback.event == 0);
}

void play(Rig& rig) {
    begin(rig, 7);
    rig.driver.pressKey(Key::space);
    CHECK(state(rig).playback.playing);
    rig.driver.pressKey(Key::space);
    CHECK_FALSE(state(rig).playback.playing);
}

void ends(Rig& rig) {
    begin(rig, 7);
    rig.driver.pressKey(Key::end);
    CHECK(state(rig).playback.event == state(rig).eventCount());
    rig.driver.pressKey(Key::home);
    CHECK(state(rig).playback.event == 0);
    CHECK(state(rig).playback.stepping);
}

void wholeRun(Rig& rig) {
    begin(rig, 7);
    rig.driver.pressKey(Key::right);
    rig.driver.pressKey(Key::w);
    CHECK_FALSE(state(rig).playback.stepping);
}

void samples(Rig& rig) {
    begin(rig, 1);
    const std::uint32_t before = state(rig).settings.samples;
    rig.driver.pressKey(Key::up);
    CHECK(state(rig).settings.samples == 2 * before);
    rig.driver.pressKey(Key::down);
    rig.driver.pressKey(Key::down);
    CHECK(state(rig).settings.samples == before / 2);
    for (int i = 0; i < 14; ++i) rig.driver.pressKey(Key::down);
    CHECK(state(rig).settings.samples == 1);
    for (int i = 0; i < 14; ++i) rig.driver.pressKey(Key::up);
    CHECK(state(rig).settings.samples == kMostLessonSamples);
}

void point(Rig& rig) {
    begin(rig, 0);
    const WallPoint before = state(rig).at;
    rig.driver.pressKey(Key::rightBracket);
    CHECK(state(rig).at.t > before.t);
    CHECK(state(rig).at.segment == before.segment);
    rig.driver.pressKey(Key::leftBracket);
    CHECK(state(rig).at.t == doctest::Approx(before.t));
}

void depth(Rig& rig) {
    begin(rig, 2);
    const std::uint32_t before = state(rig).settings.maxDepth;
    rig.driver.pressKey(Key::d);
    CHECK(state(rig).settings.maxDepth == before + 1);
    for (int i = 0; i < 4; ++i) rig.driver.pressKey(Key::shift, Key::d);
    CHECK(state(rig).settings.maxDepth == 0);
}

void seed(Rig& rig) {
    begin(rig, 3);
    const std::uint64_t before = state(rig).settings.seed;
    rig.driver.pressKey(Key::s);
    CHECK(state(rig).settings.seed == before + 1);
}

void answer(Rig& rig) {
    begin(rig, 0);
    rig.driver.pressKey(Key::a);
    CHECK(state(rig).answerShown);
}

void unlock(Rig& rig) {
    begin(rig, 0);
    rig.driver.pressKey(Key::u);
    CHECK_FALSE(state(rig).unlockAll);
    rig.driver.pressKey(Key::u);
    CHECK(state(rig).unlockAll);
}

void fit(Rig& rig) {
    begin(rig, 0);
    rig.apply(FitCamera{});
    rig.driver.frames();
    const Camera fitted = state(rig).camera;
    rig.apply(SetCamera{Camera{Vec2(5.0), 3.0}});
    rig.driver.pressKey(Key::f);
    rig.driver.frames();
    CHECK(state(rig).camera == fitted);
}

void grid(Rig& rig) {
    begin(rig, 0);
    for (const bool on : {true, false}) {
        rig.driver.pressKey(Key::g);
        CHECK(state(rig).shows(View::grid) == on);
    }
}

void pictures(Rig& rig) {
    begin(rig, 0);
    for (const bool on : {true, false}) {
        rig.driver.pressKey(Key::v);
        CHECK(state(rig).shows(View::eye) == on);
        CHECK_FALSE(state(rig).shows(View::field));
    }
    for (const bool on : {true, false}) {
        rig.driver.pressKey(Key::shift, Key::v);
        CHECK(state(rig).shows(View::field) == on);
        CHECK_FALSE(state(rig).shows(View::eye));
    }
}

void pixels(Rig& rig) {
    rig.apply(OpenScene{courseLessons() / "scenes/mirror_room.toml"});
    rig.apply(SetView{View::eye, true});
    rig.driver.pressKey(Key::period);
    REQUIRE(state(rig).pinnedPixel);
    const std::uint32_t first = *state(rig).pinnedPixel;
    rig.driver.pressKey(Key::period);
    CHECK(state(rig).pinnedPixel == first + 1);
    rig.driver.pressKey(Key::comma);
    CHECK(state(rig).pinnedPixel == first);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(state(rig).pinnedPixel);
}

void size(Rig& rig) {
    begin(rig, 0);
    rig.driver.pressKey(Key::ctrl, Key::equal);
    CHECK(state(rig).uiScale > 1.0f);
    rig.driver.pressKey(Key::ctrl, Key::minus);
    CHECK(state(rig).uiScale == 1.0f);
}

void help(Rig& rig) {
    CHECK_FALSE(state(rig).helpShown);
    rig.driver.typeText("?");
    CHECK(state(rig).helpShown);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(state(rig).helpShown);
    rig.driver.pressKey(Key::f1);
    CHECK(state(rig).helpShown);
    rig.driver.frames(2);
    rig.driver.click("Keys/Close");
    CHECK_FALSE(state(rig).helpShown);
}

void mouse(Rig&) {}  // all of test_canvas.cpp

void exactNumber(Rig&) {}  // "a double click on N types it, too"

using Check = void (*)(Rig&);

/// By a part of what the help says about the key.
void editing(Rig& rig) {
    rig.driver.pressKey(Key::x);
    CHECK(rig.state().editing.on);
    rig.driver.pressKey(Key::x);
    CHECK_FALSE(rig.state().editing.on);
}

/// Selects the first thing, with editing on.
void selectFirst(Rig& rig) {
    rig.driver.pressKey(Key::x);
    rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    rig.driver.frames(2);
}

void copyAndDelete(Rig& rig) {
    selectFirst(rig);
    const std::size_t before = rig.state().scene->description.shapes.size();
    rig.driver.pressKey(Key::ctrl, Key::d);
    CHECK(rig.state().scene->description.shapes.size() == before + 1);
    rig.driver.pressKey(Key::del);
    CHECK(rig.state().scene->description.shapes.size() == before);
}

void undoAndRedo(Rig& rig) {
    selectFirst(rig);
    const SceneDescription before = rig.state().scene->description;
    rig.driver.pressKey(Key::ctrl, Key::d);
    const SceneDescription after = rig.state().scene->description;
    rig.driver.pressKey(Key::ctrl, Key::z);
    CHECK(rig.state().scene->description == before);
    rig.driver.pressKey(Key::ctrl, Key::y);
    CHECK(rig.state().scene->description == after);
}

void saving(Rig& rig) {
    const LessonsCopy folder;
    rig.driver.pressKey(Key::x);
    const auto file = folder.folder / "saved.toml";
    rig.apply(SetScenePath{file.string()});
    rig.driver.pressKey(Key::ctrl, Key::s);
    CHECK(std::filesystem::exists(file));
    rig.driver.pressKey(Key::ctrl, Key::o);
    CHECK(rig.state().files.shown);
}

void sharing(Rig& rig) {
    rig.apply(MovePoint{{1, 0.125}});
    rig.driver.pressKey(Key::ctrl, Key::c);
    rig.apply(MovePoint{{0, 0.5}});
    rig.driver.pressKey(Key::ctrl, Key::v);
    CHECK(rig.state().at == WallPoint{1, 0.125});
}

void exporting(Rig& rig) {
    rig.driver.pressKey(Key::ctrl, Key::e);
    CHECK(rig.state().exportWished);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().exportWished);
}

void finding(Rig& rig) {
    rig.driver.pressKey(Key::ctrl, Key::k);
    CHECK(rig.state().palette.shown);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().palette.shown);
}

void choosing(Rig& rig) {
    rig.driver.pressKey(Key::x);
    rig.driver.pressKey(Key::ctrl, Key::a);
    CHECK(rig.state().editing.selected == everything(rig.state().scene->description));
    rig.driver.pressKey(Key::t);
    CHECK(rig.state().editing.selected == Selection(thingsOf(rig.state().scene->description).front()));
    rig.driver.pressKey(Key::shift, Key::t);
    CHECK(rig.state().editing.selected == Selection(thingsOf(rig.state().scene->description).back()));
}

void nudging(Rig& rig) {
    selectFirst(rig);
    const SceneDescription before = rig.state().scene->description;
    const auto middle = [&] {
        return commonMiddle(rig.state().scene->description, rig.state().editing.selected);
    };
    const Vec2 start = middle();
    rig.driver.pressKey(Key::right);
    const double step = middle().x - start.x;
    CHECK(step > 0.0);
    CHECK(middle().y == start.y);
    rig.driver.pressKey(Key::shift, Key::up);
    CHECK(middle().y - start.y > 5.0 * step);
    CHECK(rig.state().playback.event == 0);
    rig.driver.pressKey(Key::ctrl, Key::z);
    rig.driver.pressKey(Key::ctrl, Key::z);
    CHECK(rig.state().scene->description == before);
}

const std::pair<std::string_view, Check> kRows[] = {{"next step of the lesson", lessonStep},
                                                    {"previous step of the lesson", lessonStepBack},
                                                    {"reset", reset},
                                                    {"step forward / back", arrows},
                                                    {"ten steps", tenAtOnce},
                                                    {"play or pause", play},
                                                    {"play faster", speed},
                                                    {"first / last", ends},
                                                    {"whole run", wholeRun},
                                                    {"double / halve N", samples},
                                                    {"move P", point},
                                                    {"one scattering", depth},
                                                    {"next seed", seed},
                                                    {"show the answer", answer},
                                                    {"unlock all", unlock},
                                                    {"next sampler", samplerAndEmitters},
                                                    {"switch one defect", defects},
                                                    {"next lesson", nextLesson},
                                                    {"magnify", zoomAndPan},
                                                    {"next pane", panes},
                                                    {"fit the scene", fit},
                                                    {"grid", grid},
                                                    {"what the eye sees", pictures},
                                                    {"the eye's strip", pixels},
                                                    {"everything larger", size},
                                                    {"this help", help},
                                                    {"drag P", mouse},
                                                    {"change the scene, or", editing},
                                                    {"undo / redo", undoAndRedo},
                                                    {"copy / delete", copyAndDelete},
                                                    {"find anything", finding},
                                                    {"select all", choosing},
                                                    {"move what is selected", nudging},
                                                    {"save the scene", saving},
                                                    {"copy all that is seen", sharing},
                                                    {"export what is seen", exporting},
                                                    {"type it exactly", exactNumber}};

}  // namespace

TEST_CASE("every key of the help does what it says") {
    for (const auto& row : kRows) {
        CAPTURE(row.first);
        Rig rig("controls:1");
        row.second(rig);
    }
}

TEST_CASE("every row of the help is tested") {
    Rig rig("controls:1");
    rig.driver.click("Stage/?");
    rig.driver.frames(2);
    int texts = 0, known = 0;
    for (const Widget& widget : rig.session.widgets.widgets) {
        if (widget.window != "Keys" || widget.kind != WidgetKind::text) continue;
        ++texts;
        for (const auto& [meaning, check] : kRows)
            if (widget.name.find(meaning) != std::string::npos) {
                ++known;
                break;
            }
    }
    CHECK(texts == 2 * known);  // each row is a key and its meaning
    CHECK(known == static_cast<int>(std::size(kRows)));
}

TEST_CASE("keys do nothing to what the step locks") {
    Rig rig("controls:9");
    const Settings before = rig.state().settings;
    const WallPoint at = rig.state().at;
    for (const Key key : {Key::up, Key::down, Key::d, Key::s, Key::leftBracket, Key::rightBracket})
        rig.driver.pressKey(key);
    CHECK(rig.state().settings == before);
    CHECK(rig.state().at == at);
}

TEST_CASE("while a number is typed its characters are no commands") {
    Rig rig("controls:2");
    rig.host->queue(KeyChange{Key::ctrl, true});
    rig.driver.click("Controls/N");
    rig.host->queue(KeyChange{Key::ctrl, false});
    rig.driver.frames(2);
    const std::size_t step = rig.state().step;
    for (const Key key : {Key::n, Key::u, Key::g, Key::right, Key::home, Key::pageDown})
        rig.driver.pressKey(key);
    rig.driver.typeText("?");
    CHECK(rig.state().step == step);
    CHECK_FALSE(rig.state().unlockAll);
    CHECK_FALSE(rig.state().helpShown);
    CHECK_FALSE(rig.state().shows(View::grid));
}
