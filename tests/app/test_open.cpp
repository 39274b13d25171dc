// Are files found, opened, saved under other names and remembered, without losing one?
#include <doctest/doctest.h>

#include <fstream>

#include "app/autosave.h"
#include "app/recent_files.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void openList(Rig& rig) {
    rig.driver.pressKey(Key::ctrl, Key::o);
    rig.driver.frames(2);
    REQUIRE(rig.state().files.shown);
}

/// In place of the path in the field.
void retype(Rig& rig, const std::filesystem::path& path) {
    rig.driver.frames(3);
    rig.driver.pressKey(Key::ctrl, Key::a);
    rig.driver.typeText(path.string());
    REQUIRE(rig.state().files.path == path.string());
}

std::vector<std::string> namesOf(const std::vector<FileChoice>& choices) {
    std::vector<std::string> names;
    for (const FileChoice& choice : choices) names.push_back(choice.name);
    return names;
}

}  // namespace

TEST_CASE("a folder lists its lessons and scenes, then its folders, nothing hidden and nothing else") {
    const LessonsCopy files;
    std::ofstream(files.folder / "notes.txt") << "x";
    std::ofstream(files.folder / ".hidden.toml") << "x";
    CHECK(namesOf(listFolder(files.folder)) ==
          std::vector<std::string>{"01-controls.toml", "02-field.toml", "03-broken.toml", "scenes/"});
    CHECK(listFolder(files.folder / "nowhere").empty());
    CHECK(listFolder(files.folder / "notes.txt").empty());
}

TEST_CASE("a scene and a lesson are opened by keys alone") {
    const LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 2}));
    openList(rig);
    CHECK(rig.state().files.path == (files.folder / "scenes/").string());
    rig.driver.typeText("fie");
    rig.driver.pressKey(Key::enter);
    CHECK_FALSE(rig.state().files.shown);
    CHECK(rig.state().scene->scene.title == "Field");
    CHECK_FALSE(rig.state().lesson.has_value());
    openList(rig);
    for (int i = 0; i < 7; ++i) rig.driver.pressKey(Key::backspace);  // "scenes/"
    rig.driver.typeText("cont");
    CHECK(rig.state().files.path == (files.folder / "cont").string());
    rig.driver.pressKey(Key::enter);
    CHECK(rig.state().lesson->slug == "controls");
}

TEST_CASE("a folder is gone into, Tab takes a name, and the typing goes on behind it") {
    const LessonsCopy files;
    Rig rig(openScene(files.folder, files.folder / "scenes/field.toml"));
    rig.apply(ShowFiles{true});
    retype(rig, files.folder / "sce");
    rig.driver.pressKey(Key::tab);
    rig.driver.frames(3);
    CHECK(rig.state().files.path == (files.folder / "scenes/").string());
    rig.driver.typeText("bo");
    CHECK(rig.state().files.path == (files.folder / "scenes/bo").string());
    rig.driver.pressKey(Key::tab);
    rig.driver.frames(3);
    CHECK(rig.state().files.path == (files.folder / "scenes/box.toml").string());
    rig.driver.pressKey(Key::enter);
    CHECK_FALSE(rig.state().files.shown);
    CHECK(rig.state().scene->scene.title == "Box");
}

TEST_CASE("what cannot be opened is told, the list stays, and nothing changes") {
    const LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 2}));
    const auto scene = rig.state().scene;
    openList(rig);
    retype(rig, files.folder / "03-broken.toml");
    rig.driver.pressKey(Key::enter);
    CHECK(rig.state().files.shown);
    CHECK(rig.state().banner.find("03-broken.toml") != std::string::npos);
    CHECK(rig.state().scene == scene);
    CHECK(rig.state().recent.empty());
    retype(rig, "/no/such/folder/x.toml");
    rig.driver.pressKey(Key::enter);
    CHECK(rig.state().banner.find("/no/such/folder/x.toml") != std::string::npos);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().files.shown);
    CHECK(rig.state().banner.empty());
}

TEST_CASE("hostile paths are harmless") {
    Rig rig("controls:1");
    openList(rig);
    for (const std::string& path :
         {std::string(10'000, '/'), std::string(10'000, 'a'), std::string("\xff\xfe/"), std::string("~/"),
          std::string("/dev/"), std::string("../../../../../"), std::string("a\0b/", 4), std::string()}) {
        rig.apply(SetFilePath{path});
        rig.driver.frames(2);
        CHECK(choicesOf(rig.state().files).size() <= kMostFilesListed + kMostRecent);
    }
    rig.apply(SelectFile{SIZE_MAX});
    rig.driver.frames(2);
    rig.driver.pressKey(Key::escape);
    CHECK_FALSE(rig.state().files.shown);
}

TEST_CASE("the last files come first in the list, the missing ones told from the others") {
    const LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 1}));
    rig.apply(OpenFile{files.folder / "scenes/field.toml"});
    rig.apply(SetEditing{true});
    rig.apply(SaveScene{(files.folder / "mine.toml").string()});
    std::filesystem::remove(files.folder / "scenes/field.toml");
    REQUIRE(rig.state().recent.size() == 2);
    rig.apply(ShowFiles{true});
    const std::vector<FileChoice> choices = choicesOf(rig.state().files);
    REQUIRE(choices.size() > 2);
    CHECK(choices[0].path == files.folder / "mine.toml");
    CHECK_FALSE(choices[0].isMissing);
    CHECK(choices[1].path == files.folder / "scenes/field.toml");
    CHECK(choices[1].isMissing);
    CHECK_FALSE(choices[2].isRecent);
    rig.session.state.files.path += "min";  // a name finds the last files wherever they are
    REQUIRE(choicesOf(rig.state().files).size() == 1);
    CHECK(choicesOf(rig.state().files)[0].path == files.folder / "mine.toml");
    rig.apply(ShowFiles{true});
    rig.driver.frames(3);
    rig.driver.click("Files/" + (files.folder / "mine.toml").string());
    CHECK_FALSE(rig.state().files.shown);
    CHECK(rig.state().sceneOverride == files.folder / "mine.toml");
}

TEST_CASE("ten files are remembered, none twice") {
    std::vector<std::filesystem::path> recent;
    for (int i = 0; i < 15; ++i) remember(recent, "/folder/" + std::to_string(i) + ".toml");
    CHECK(recent.size() == kMostRecent);
    CHECK(recent.front() == "/folder/14.toml");
    remember(recent, "/folder/x/../9.toml");
    CHECK(recent.front() == "/folder/9.toml");
    CHECK(recent.size() == kMostRecent);
    remember(recent, "here.toml");
    CHECK(recent.front().is_absolute());
}

TEST_CASE("the list of last files outlives the program, and two windows share it") {
    const LessonsCopy files;
    const auto keep = files.folder / "state/halfdisk";
    AppState one = openLesson(files.folder, LessonRef{"controls", 1});
    AppState two = one;
    RecentFiles first(keep), second(keep);
    CHECK(first.read().empty());
    first.look(one);
    CHECK_FALSE(std::filesystem::exists(first.file()));
    apply(one, OpenFile{files.folder / "scenes/box.toml"});
    first.look(one);
    apply(two, OpenFile{files.folder / "scenes/field.toml"});
    second.look(two);
    CHECK(RecentFiles(keep).read() == std::vector<std::filesystem::path>{files.folder / "scenes/field.toml",
                                                                         files.folder / "scenes/box.toml"});
    const auto written = std::filesystem::last_write_time(first.file());
    second.look(two);
    CHECK(std::filesystem::last_write_time(first.file()) == written);
    RecentFiles third(keep);  // the next start: nothing new
    AppState three = openLesson(files.folder, LessonRef{"controls", 1});
    three.recent = third.read();
    std::filesystem::remove(first.file());
    third.look(three);
    CHECK_FALSE(std::filesystem::exists(first.file()));
}

TEST_CASE("a list that is damaged, or cannot be written, stops nobody") {
    const LessonsCopy files;
    RecentFiles recent(files.folder);
    std::ofstream(recent.file(), std::ios::binary)
        << "not absolute\n\n/a.toml\n/a.toml\n\xff\xfe\n/b\0c\n/d.toml";
    CHECK(recent.read().size() == 2);
    std::ofstream(recent.file(), std::ios::binary) << std::string(200'000, '/');
    CHECK(recent.read().empty());
    AppState state = openLesson(files.folder, LessonRef{"controls", 1});
    std::ofstream(files.folder / "file") << "x";
    RecentFiles nowhere(files.folder / "file");
    apply(state, OpenFile{files.folder / "scenes/box.toml"});
    nowhere.look(state);
    CHECK(state.banner.find("cannot be remembered") != std::string::npos);
    state.banner.clear();
    apply(state, OpenFile{files.folder / "scenes/field.toml"});
    nowhere.look(state);
    CHECK(state.banner.empty());
}

TEST_CASE("a kiosk opens and remembers nothing") {
    const LessonsCopy files;
    Rig rig(openLesson(files.folder, LessonRef{"controls", 1}));
    rig.session.state.rules.kiosk = true;
    rig.driver.pressKey(Key::ctrl, Key::o);
    CHECK_FALSE(rig.state().files.shown);
    remember(rig.session.state.recent, files.folder / "scenes/box.toml");
    RecentFiles recent(files.folder / "state");
    recent.look(rig.session.state);
    CHECK_FALSE(std::filesystem::exists(recent.file()));
}

TEST_CASE("saving under another name leaves the first file, and asks before it writes over a third") {
    const LessonsCopy files;
    Rig rig(openScene(files.folder, files.folder / "scenes/box.toml"));
    const std::string own = files.read("scenes/box.toml"), other = files.read("scenes/field.toml");
    rig.driver.click("Stage/Edit");
    rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    rig.apply(ActOnSelected{EditAct::copy});
    rig.driver.frames(2);
    rig.scrollTo("Controls/file", "Controls/Undo");
    rig.driver.replaceText("Controls/file", (files.folder / "new.toml").string());
    rig.driver.pressKey(Key::ctrl, Key::s);
    CHECK(loadScene(files.folder / "new.toml") == rig.state().scene->description);
    CHECK(files.read("scenes/box.toml") == own);
    const auto third = (files.folder / "scenes/field.toml").string();
    rig.driver.replaceText("Controls/file", third);
    rig.driver.pressKey(Key::ctrl, Key::s);
    CHECK(files.read("scenes/field.toml") == other);
    CHECK(rig.state().editing.message.find("Save again") != std::string::npos);
    rig.apply(SetScenePath{third});  // asked again for each name
    rig.driver.pressKey(Key::ctrl, Key::s);
    CHECK(files.read("scenes/field.toml") == other);
    rig.driver.pressKey(Key::ctrl, Key::s);
    CHECK(loadScene(third) == rig.state().scene->description);
}

TEST_CASE(
    "a file of one's own is saved under its name at once, a course's under another or when one insists") {
    const LessonsCopy course, home;
    Rig rig(openScene(course.folder, home.folder / "scenes/field.toml"));
    rig.apply(SetEditing{true});
    rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    CHECK(rig.state().editing.path == (home.folder / "scenes/field.toml").string());
    rig.apply(ActOnSelected{EditAct::copy});
    rig.apply(SaveScene{rig.state().editing.path});  // it has comments, which is told
    rig.apply(SaveScene{rig.state().editing.path});
    rig.apply(ActOnSelected{EditAct::copy});
    rig.apply(SaveScene{rig.state().editing.path});
    CHECK(loadScene(home.folder / "scenes/field.toml") == rig.state().scene->description);

    const SceneDescription mine = rig.state().scene->description;
    const Selection selected = rig.state().editing.selected;
    const std::size_t steps = rig.state().editing.history.past.size();
    rig.apply(Reload{});  // as the window does when it sees that the file has changed
    CHECK(rig.state().editing.selected == selected);
    CHECK(rig.state().editing.history.past.size() == steps);

    rig.apply(OpenFile{course.folder / "scenes/field.toml"});
    CHECK(rig.state().editing.path == "my_field.toml");
    const auto plain = course.folder / "scenes/plain.toml";
    saveScene(mine, plain);  // without comments
    rig.apply(OpenFile{plain});
    rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    rig.apply(ActOnSelected{EditAct::copy});
    rig.apply(SaveScene{plain.string()});
    CHECK(loadScene(plain) == mine);
    CHECK(rig.state().editing.message.find("is there already") != std::string::npos);
}

TEST_CASE("what was saved is not replaced by the next scene that is opened") {
    const LessonsCopy course, home;
    Rig rig(openScene(course.folder, home.folder / "scenes/field.toml"));
    rig.apply(SetEditing{true});
    const auto mine = home.folder / "mine.toml";
    rig.apply(SaveScene{mine.string()});
    const std::string saved = bytesOf(mine);
    for (const Command& command :
         {Command(OpenFile{home.folder / "scenes/box.toml"}), Command(GoTo{"controls", 0})}) {
        rig.apply(SetScenePath{mine.string()});
        rig.apply(command);
        CHECK(rig.state().editing.path != mine.string());
        rig.apply(SaveScene{mine.string()});  // asked for by name: it is told first
        CHECK(bytesOf(mine) == saved);
    }
}
