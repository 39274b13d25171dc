// What happens when files are dropped on the window, or change on the disk while they are shown?
#include <doctest/doctest.h>

#include <fstream>
#include <optional>

#include "app/file_watch.h"
#include "rig.h"

using namespace halfdisk;

namespace {

struct Shown {
    std::optional<Lesson> lesson;
    std::size_t step;
    Scene scene;
    Settings settings;
    WallPoint at;
    bool operator==(const Shown&) const = default;
};

Shown shown(const Rig& rig) {
    const AppState& state = rig.state();
    return {state.lesson, state.step, state.scene->scene, state.settings, state.at};
}

/// What the window does now and then between its frames.
bool look(FileWatch& watch, Rig& rig) {
    if (!watch.changed(rig.state())) return false;
    rig.apply(Reload{});
    rig.settle();
    return true;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

bool showsText(const Rig& rig, std::string_view words) {
    for (const Widget& widget : rig.session.widgets.widgets)
        if (widget.name.find(words) != std::string::npos) return true;
    return false;
}

}  // namespace

TEST_CASE("broken files that are dropped show a banner and change nothing") {
    const LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 3}));
    const Shown before = shown(rig);
    std::ofstream(files.folder / "garbage.toml") << "\xff\xfe[[[ = nonsense";
    std::ofstream(files.folder / "empty.toml");
    std::ofstream(files.folder / "zero.toml")
        << "title = \"Zero\"\n[[segment]]\nname = \"s\"\na = [1.0, 1.0]\nb = "
           "[1.0, 1.0]\nmaterial = \"none\"\n";
    for (const std::string name :
         {"garbage.toml", "empty.toml", "zero.toml", "03-broken.toml", "missing.toml", "scenes"}) {
        CAPTURE(name);
        rig.apply(OpenFile{files.folder / name});
        CHECK(rig.state().banner.find(name) != std::string::npos);
        CHECK(shown(rig) == before);
        rig.driver.frames(2);
        rig.driver.click("Message/Dismiss");
        rig.driver.frames();
        CHECK(rig.state().banner.empty());
    }
}

TEST_CASE("a scene that is dropped is shown alone, a lesson at its first step") {
    const LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 3}));
    rig.apply(OpenFile{files.folder / "scenes/field.toml"});
    rig.settle();
    CHECK(rig.state().banner.empty());
    CHECK_FALSE(rig.state().lesson.has_value());
    CHECK(rig.state().scene->scene.title == "Field");
    CHECK(rig.driver.get("Controls/N").enabled);
    rig.driver.typeNumber("Controls/N", "12");
    rig.settle();
    CHECK(rig.state().answer->asked.settings.samples == 12);
    rig.apply(OpenFile{files.folder / "01-controls.toml"});
    rig.settle();
    CHECK(rig.state().lesson->slug == "controls");
    CHECK(rig.state().scene->scene.title == "Box");
}

TEST_CASE("a changed lesson reloads at its step; broken, the last good one stays; mended, the banner goes") {
    LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 3}));
    FileWatch watch;
    CHECK_FALSE(look(watch, rig));
    CHECK_FALSE(look(watch, rig));

    const std::string original = files.read("01-controls.toml");
    files.write("01-controls.toml", replaced(original, "Change depth", "Deeper and deeper"));
    CHECK(look(watch, rig));
    CHECK(rig.state().banner.empty());
    CHECK(rig.state().step == 2);
    CHECK(showsText(rig, "Lesson/Deeper and deeper"));
    CHECK_FALSE(look(watch, rig));

    const Shown good = shown(rig);
    files.write("01-controls.toml", replaced(original, "unlock = \"depth\"", "unlock = \"dpeth\""));
    CHECK(look(watch, rig));
    CHECK(rig.state().banner.find("01-controls.toml") != std::string::npos);
    CHECK(shown(rig) == good);
    CHECK(showsText(rig, "Message/"));

    files.write("01-controls.toml", original);
    CHECK(look(watch, rig));
    CHECK(rig.state().banner.empty());
    CHECK(showsText(rig, "Lesson/Change depth"));
}

TEST_CASE("a changed scene reloads, too, and its light is computed anew") {
    LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"field", 1}));
    FileWatch watch;
    look(watch, rig);
    CHECK(rig.state().answer->exact->x == doctest::Approx(1.0));  // 2 x 0.5
    const std::string original = files.read("scenes/field.toml");
    files.write("scenes/field.toml", replaced(original, "radiance = 0.5", "radiance = 2.0"));
    CHECK(look(watch, rig));
    CHECK(rig.state().answer->exact->x == doctest::Approx(4.0));

    files.write("scenes/field.toml", replaced(original, "b = [3.0, 0.0]", "b = [0.0, 0.0]"));
    CHECK(look(watch, rig));
    CHECK(rig.state().banner.find("field.toml") != std::string::npos);
    CHECK(rig.state().scene->scene.environment.radiance.x == 2.0);
    CHECK(rig.state().answer->exact->x == doctest::Approx(4.0));
}

TEST_CASE("a lesson that loses the step on screen shows its last one; one that vanishes stays on screen") {
    LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"field", 2}));
    FileWatch watch;
    look(watch, rig);
    const std::string original = files.read("02-field.toml");
    files.write("02-field.toml", original.substr(0, original.rfind("[[step]]")));
    CHECK(look(watch, rig));
    CHECK(rig.state().step == 0);
    CHECK(rig.state().lesson->steps.size() == 1);

    const Shown before = shown(rig);
    std::filesystem::remove(files.folder / "02-field.toml");
    rig.apply(Reload{});
    CHECK(shown(rig) == before);
    CHECK_FALSE(rig.state().banner.empty());
}
