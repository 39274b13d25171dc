// Does what a teacher locks and hides stay so?
#include <doctest/doctest.h>

#include "app/class_rules.h"
#include "rig.h"

using namespace halfdisk;

namespace {

Rig& withRules(Rig& rig, const ClassRules& rules) {
    setRules(rig.session.state, rules);
    rig.settle();
    rig.driver.frames(2);
    return rig;
}

void refused(const std::string& text, std::string_view said, void (*add)(ClassRules&, const std::string&)) {
    ClassRules rules;
    try {
        add(rules, text);
        FAIL("taken: ", text);
    } catch (const InputError& error) {
        CHECK_MESSAGE(error.text.find(said) != std::string::npos, error.text);
    }
}

}  // namespace

TEST_CASE("a locked control keeps its value in every step, and is never unlocked") {
    ClassRules rules;
    addLock(rules, "samples=5");
    addLock(rules, "seed=77");
    addLock(rules, "sampler");
    Rig rig("controls:2");  // unlocks samples
    withRules(rig, rules);
    CHECK(rig.state().settings.samples == 5);
    CHECK(rig.state().settings.seed == 77);
    CHECK_FALSE(rig.driver.get("Controls/N").enabled);
    rig.driver.click("Controls/Unlock all");
    rig.driver.frames(2);
    CHECK_FALSE(rig.driver.get("Controls/N").enabled);
    CHECK_FALSE(rig.driver.get("Controls/sampler").enabled);
    CHECK(rig.driver.get("Controls/maxDepth").enabled);
    rig.driver.pressKey(Key::up);
    rig.apply(NextStep{});
    CHECK(rig.state().settings.samples == 5);
    rig.apply(ResetStep{});
    CHECK(rig.state().settings.samples == 5);
}

TEST_CASE("each control takes its value, and wrong ones are told") {
    ClassRules rules;
    for (const char* text :
         {"point=room.0:0.25", "samples=8", "depth=2", "seed=18446744073709551615", "sampler=cosine",
          "emitters=hit", "defects=pdf,frame", "estimator=radiosity", "step", "params"})
        addLock(rules, text);
    for (const Named<Control>& control : kControls) CHECK(rules.isLocked(control.value));
    CHECK(rules.seed == UINT64_MAX);
    CHECK(rules.estimator == "radiosity");
    refused("sample=4", "did you mean \"samples\"", addLock);
    refused("samples=0", "not a whole number", addLock);
    refused("samples=5000", "4096", addLock);
    refused("sampler=even", "is unknown", addLock);
    refused("step=3", "takes no value", addLock);
    refused("estimator=pth", "did you mean \"path\"", addLock);
    refused("", "is unknown", addLock);
    for (const char* place : {"point=", "point=floor", "point=floor:nan", "point=:0.5", "point=floor:2"})
        refused(place, "expected point=WALL:T", addLock);
    refused("histogramm", "did you mean \"histogram\"", addHidden);
}

TEST_CASE("a locked estimator keeps the parameters that the step gives it") {
    ClassRules rules;
    addLock(rules, "estimator=light");
    Rig rig("controls:10");
    Maker own = *rig.state().makers.first;
    REQUIRE(own.estimator == "light");
    withRules(rig, rules);
    CHECK(rig.state().makers.first == own);
}

TEST_CASE("P is put on a wall where the scene has it") {
    ClassRules rules;
    addLock(rules, "point=room.1:0.125");
    Rig rig("controls:1");
    withRules(rig, rules);
    CHECK(positionOf(rig.state().scene->scene, rig.state().at) ==
          positionOf(rig.state().scene->scene, parseWallPoint("room.1:0.125", rig.state().scene->scene)));
    rules.point = "nowhere:0.5";
    withRules(rig, rules);
    CHECK(rig.state().at == rig.state().currentStep()->values.at);
}

TEST_CASE("what is hidden is not shown, also when it is asked for") {
    ClassRules rules;
    addHidden(rules, "rays");
    addHidden(rules, "controls");
    Rig rig("controls:2");
    REQUIRE(rig.state().shows(View::rays));
    const float before = rig.canvas().width();
    withRules(rig, rules);
    CHECK_FALSE(rig.state().shows(View::rays));
    rig.apply(SetView{View::rays, true});
    CHECK_FALSE(rig.state().shows(View::rays));
    CHECK_FALSE(rig.session.widgets.find("Controls/N"));
    CHECK(rig.session.widgets.find("Lesson/Next"));
    CHECK(rig.canvas().width() > before);
    addHidden(rules, "lesson");
    withRules(rig, rules);
    CHECK_FALSE(rig.session.widgets.find("Lesson/Next"));
}

TEST_CASE("a kiosk stays in its lesson and its scene") {
    ClassRules rules;
    rules.kiosk = true;
    Rig rig("controls:1");
    withRules(rig, rules);
    const auto scene = rig.state().scene;
    rig.apply(GoTo{"field", 0});
    CHECK(rig.state().lesson->slug == "controls");
    rig.apply(GoTo{"controls", 2});
    CHECK(rig.state().step == 2);
    rig.apply(OpenFile{testLessons() / "02-field.toml"});
    rig.apply(OpenScene{testLessons() / "scenes/box.toml"});
    rig.apply(SetEditing{true});
    rig.apply(UnlockAll{true});
    CHECK(rig.state().scene == scene);
    CHECK_FALSE(rig.state().editing.on);
    CHECK_FALSE(rig.state().unlockAll);
    for (const char* name : {"Stage/Edit", "Controls/Unlock all", "Lesson/Lessons"})
        CHECK_FALSE(rig.session.widgets.find(name));
    rig.driver.click("Controls/Reset");
    rig.driver.click("Lesson/Next");
    CHECK(rig.state().step == 3);
}
