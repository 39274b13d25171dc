// Does the lesson go on, and do the controls set what they say, when operated by their names?
#include <doctest/doctest.h>

#include <algorithm>

#include "rig.h"

using namespace halfdisk;

namespace {

/// The option of an open chooser whose name contains `words`.
std::string option(const WidgetRegistry& widgets, std::string_view words) {
    for (const Widget& widget : widgets.widgets)
        if (widget.kind == WidgetKind::option && widget.name.find(words) != std::string::npos)
            return widget.name;
    return "no option with " + std::string(words);
}

void choose(Rig& rig, std::string_view chooser, std::string_view words) {
    rig.driver.click(chooser);
    rig.driver.frames(2);
    rig.driver.click(option(rig.session.widgets, words));
}

/// The step of the test lesson that unlocks `control`.
std::string stepOf(Control control) {
    return "controls:" + std::to_string(static_cast<int>(control) + 1);
}

bool shows(const Rig& rig, std::string_view name) {
    return rig.session.widgets.find(name) != nullptr;
}

}  // namespace

TEST_CASE("Next and Previous walk through the steps and set their values") {
    Rig rig("controls:1");
    const std::vector<Step>& steps = rig.state().lesson->steps;
    CHECK_THROWS_WITH_AS(rig.driver.click("Lesson/Previous"), doctest::Contains("disabled"),
                         std::runtime_error);
    for (std::size_t k = 1; k < steps.size(); ++k) {
        rig.driver.click("Lesson/Next");
        CHECK(rig.state().step == k);
        CHECK(rig.state().settings == rig.state().currentStep()->values.settings);
        CHECK(rig.state().at == rig.state().currentStep()->values.at);
        CHECK(rig.state().show == rig.state().currentStep()->show);
        CHECK(shows(rig, "Lesson/" + rig.state().currentStep()->title));
    }
    CHECK_THROWS_WITH_AS(rig.driver.click("Lesson/Next"), doctest::Contains("disabled"), std::runtime_error);
    rig.driver.click("Lesson/Previous");
    CHECK(rig.state().step + 2 == rig.state().lesson->steps.size());
    rig.settle();
    CHECK(rig.state().answer->asked.settings == rig.state().settings);
}

TEST_CASE("the chooser opens another lesson at its first step") {
    Rig rig("controls:3");
    const auto before = rig.state().scene;
    choose(rig, "Lesson/Lessons", "Field");
    CHECK(rig.state().lesson->slug == "field");
    CHECK(rig.state().step == 0);
    CHECK(rig.state().scene != before);
    rig.settle();
    CHECK(rig.state().answer->asked.scene == rig.state().scene);
    // An even sky of radiance 0.5 over a half-disk: E = 2 * 0.5.
    REQUIRE(rig.state().answer->exact);
    CHECK(rig.state().answer->exact->x == doctest::Approx(1.0));
}

TEST_CASE("a broken lesson is listed; choosing it says why and changes nothing else") {
    Rig rig("controls:3");
    const AppState before = rig.state();
    choose(rig, "Lesson/Lessons", "broken");
    CHECK(rig.state().banner.find("03-broken.toml:4") != std::string::npos);
    CHECK(rig.state().lesson == before.lesson);
    CHECK(rig.state().step == before.step);
    CHECK(rig.state().scene == before.scene);
    CHECK(rig.state().settings == before.settings);
    rig.driver.frames(2);
    rig.driver.click("Message/Dismiss");
    CHECK(rig.state().banner.empty());
    rig.driver.frames();
    CHECK_FALSE(shows(rig, "Message/Dismiss"));
}

TEST_CASE("a step unlocks its one control; Unlock all unlocks the others") {
    const std::pair<Control, const char*> names[] = {{Control::samples, "Controls/N"},
                                                     {Control::depth, "Controls/maxDepth"},
                                                     {Control::seed, "Controls/seed"},
                                                     {Control::sampler, "Controls/sampler"},
                                                     {Control::emitters, "Controls/emitters"}};
    for (const Named<Control>& control : kControls) {
        CAPTURE(control.name);
        Rig rig(stepOf(control.value));
        REQUIRE(rig.state().currentStep()->unlock == control.value);
        for (const auto& [owner, name] : names)
            CHECK(rig.driver.get(name).enabled == (owner == control.value));
        rig.driver.click("Controls/Unlock all");
        rig.driver.frames();
        for (const auto& [owner, name] : names) CHECK(rig.driver.get(name).enabled);
        rig.driver.click("Controls/Unlock all");
        rig.driver.frames();
        for (const auto& [owner, name] : names)
            CHECK(rig.driver.get(name).enabled == (owner == control.value));
    }
}

TEST_CASE("N is dragged and typed, and stays in its range") {
    Rig rig(stepOf(Control::samples));
    const std::uint32_t before = rig.state().settings.samples;
    rig.driver.dragBy("Controls/N", 100, 0);
    CHECK(rig.state().settings.samples >= 2 * before);
    rig.driver.dragBy("Controls/N", -4000, 0);
    CHECK(rig.state().settings.samples == 1);
    rig.driver.typeNumber("Controls/N", "200");
    CHECK(rig.state().settings.samples == 200);
    rig.settle();
    CHECK(rig.state().answer->asked.settings.samples == 200);
    CHECK(rig.state().answer->contributions.size() == 200);
    rig.driver.typeNumber("Controls/N", "999999");
    CHECK(rig.state().settings.samples == kMostLessonSamples);
    rig.driver.typeNumber("Controls/N", "0");
    CHECK(rig.state().settings.samples == 1);
}

TEST_CASE("a double click on N types it, too") {
    Rig rig(stepOf(Control::samples));
    rig.driver.doubleClick("Controls/N");
    rig.driver.typeText("33");
    rig.driver.pressKey(Key::enter);
    CHECK(rig.state().settings.samples == 33);
}

TEST_CASE("another seed is typed and gives another run; the old one gives the old run again") {
    Rig rig(stepOf(Control::seed));
    const std::uint64_t seed = rig.state().settings.seed;
    const Rgb before = rig.state().answer->estimate.total();
    rig.driver.typeNumber("Controls/seed", "18446744073709551615");
    CHECK(rig.state().settings.seed == UINT64_MAX);
    rig.settle();
    CHECK(rig.state().answer->estimate.total() != before);
    rig.driver.typeNumber("Controls/seed", std::to_string(seed));
    rig.settle();
    CHECK(rig.state().answer->estimate.total() == before);
}

TEST_CASE("depth is typed; deeper runs cast more rays") {
    Rig rig(stepOf(Control::depth));
    const std::uint64_t before = rig.state().answer->rays;
    rig.driver.typeNumber("Controls/maxDepth", "2");
    CHECK(rig.state().settings.maxDepth == 2);
    rig.settle();
    CHECK(rig.state().answer->rays > 2 * before);
    rig.driver.typeNumber("Controls/maxDepth", "99");
    CHECK(rig.state().settings.maxDepth == kMostLessonDepth);
}

TEST_CASE("samplers and emitters are chosen by name") {
    Rig rig(stepOf(Control::sampler));
    for (const Named<Sampler>& sampler : {kSamplers[1], kSamplers[2], kSamplers[0]}) {
        choose(rig, "Controls/sampler", sampler.name);
        CHECK(rig.state().settings.sampler == sampler.value);
    }
    rig.apply(GoTo{"controls", static_cast<std::size_t>(Control::emitters)});
    for (const Named<Emitters>& emitters : {kEmitters[1], kEmitters[2], kEmitters[0]}) {
        choose(rig, "Controls/emitters", emitters.name);
        CHECK(rig.state().settings.emitters == emitters.value);
    }
}

TEST_CASE("each defect has its switch, and the code panel shows the listing that runs") {
    Rig rig(stepOf(Control::defects));
    // The shortest line that only one of the two listings has: it is not broken.
    const auto onlyIn = [](const Listing& one, const Listing& other) {
        std::string shortest;
        for (const ListingLine& line : one) {
            if (std::any_of(other.begin(), other.end(), [&](const auto& o) { return o.text == line.text; }))
                continue;
            if (shortest.empty() || line.text.size() < shortest.size()) shortest = line.text;
        }
        return "Stage/" + shortest;
    };
    const std::string corrected = onlyIn(rig.session.listings.corrected, rig.session.listings.asPrinted);
    const std::string printed = onlyIn(rig.session.listings.asPrinted, rig.session.listings.corrected);
    CHECK((shows(rig, corrected) && !shows(rig, printed)));
    for (const Named<Defect>& defect : kDefects) {
        const std::string name = "Controls/" + std::string(defect.name);
        rig.driver.click(name);
        DefectSet only;
        only.set(defect.value, true);
        CHECK(rig.state().settings.defects == only);
        rig.driver.frames();
        CHECK((!shows(rig, corrected) && shows(rig, printed)));
        rig.driver.click(name);
        CHECK(rig.state().settings.defects == DefectSet{});
    }
    rig.driver.click("Controls/as printed");
    CHECK(rig.state().settings.defects == DefectSet::all());
    rig.driver.click("Controls/frame");
    CHECK_FALSE(rig.state().settings.defects.has(Defect::frame));
    rig.settle();
    CHECK(rig.state().answer->asked.settings.defects == rig.state().settings.defects);
}

TEST_CASE("the answer to the question shows when asked for, and hides at the next step") {
    Rig rig("controls:1");
    CHECK_FALSE(rig.state().answerShown);
    CHECK_FALSE(shows(rig, "Lesson/Yes."));
    rig.driver.click("Lesson/Show the answer");
    rig.driver.frames();
    CHECK(rig.state().answerShown);
    CHECK(shows(rig, "Lesson/Yes."));
    rig.driver.click("Lesson/Next");
    rig.driver.click("Lesson/Previous");
    rig.driver.frames();
    CHECK_FALSE(rig.state().answerShown);
    CHECK(shows(rig, "Lesson/Show the answer"));
}

TEST_CASE("Reset returns to how the step began") {
    Rig rig(stepOf(Control::seed));
    const Camera camera = rig.state().camera;
    rig.driver.click("Controls/Unlock all");
    rig.driver.typeNumber("Controls/N", "77");
    rig.driver.typeNumber("Controls/seed", "5");
    rig.driver.dragTo("Stage/P", rig.screen({1.5, 0.0}).x, rig.screen({1.5, 0.0}).y);
    rig.driver.wheel("Stage/canvas", 3);
    const StepValues& values = rig.state().currentStep()->values;
    CHECK(rig.state().settings != values.settings);
    CHECK(rig.state().at != values.at);
    CHECK(rig.state().camera != camera);
    rig.driver.click("Controls/Reset");
    rig.driver.frames(2);
    CHECK(rig.state().settings == values.settings);
    CHECK(rig.state().at == values.at);
    CHECK(rig.state().camera == camera);
}

TEST_CASE("a run of too many rays is refused with a message, and a smaller one goes on") {
    Rig rig(stepOf(Control::samples));
    rig.driver.click("Controls/Unlock all");
    rig.driver.typeNumber("Controls/N", "4096");
    rig.driver.typeNumber("Controls/maxDepth", "8");
    rig.settle();
    CHECK(rig.state().answer->tooManyRays);
    rig.driver.frames(2);
    rig.driver.typeNumber("Controls/N", "2");
    rig.driver.typeNumber("Controls/maxDepth", "1");
    rig.settle();
    CHECK_FALSE(rig.state().answer->tooManyRays);
    CHECK(rig.state().answer->contributions.size() == 2);
}
