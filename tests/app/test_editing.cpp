// Can a scene be changed by hand, taken back, and saved, without ever losing anything?
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>

#include "app/edit_commands.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

/// A small room by itself, with editing on and nothing snapping.
struct Bench {
    LessonsCopy folder;
    Rig rig;

    static AppState opened(const std::filesystem::path& folder) {
        std::ofstream(folder / "room.toml") << kRoom;
        return openScene(folder, folder / "room.toml");
    }
    Bench() : rig(opened(folder.folder)) {
        rig.driver.click("Stage/Edit");
        rig.driver.click("Controls/Snap");
        rig.driver.frames(2);
    }

    const SceneDescription& scene() const { return rig.state().scene->description; }
    std::string file(const char* name) const { return (folder.folder / name).string(); }

    void drag(Vec2 from, Vec2 to) {
        const ImVec2 a = rig.screen(from), b = rig.screen(to);
        rig.driver.moveTo(a.x, a.y);
        rig.driver.press();
        rig.driver.moveTo((a.x + b.x) / 2, (a.y + b.y) / 2);
        rig.driver.moveTo(b.x, b.y);
        rig.driver.release();
        rig.driver.frames(2);
    }
    void use(const char* tool) {
        rig.driver.click(std::string("Controls/") + tool);
        rig.driver.frames();
    }

    static constexpr const char* kRoom = R"(title = "Room"
[material.white]
type = "diffuse"
albedo = 0.5
[[segment]]
name = "floor"
a = [0.0, 0.0]
b = [4.0, 0.0]
material = "white"
[[box]]
name = "block"
min = [1.0, 1.0]
max = [2.0, 2.0]
material = "white"
[[light]]
type = "point"
position = [3.0, 3.0]
)";
};

bool near(Vec2 a, Vec2 b) {
    return glm::length(a - b) < 0.02;  // a pixel or two
}

const SegmentShape& segment(const SceneDescription& scene, std::size_t i) {
    return std::get<SegmentShape>(scene.shapes.at(i).geometry);
}

}  // namespace

TEST_CASE("a wall is drawn from end to end, and undone and redone in one") {
    Bench bench;
    const SceneDescription before = bench.scene();
    bench.use("Wall");
    bench.drag({0.5, 2.5}, {1.5, 3.0});
    REQUIRE(bench.scene().shapes.size() == 3);
    CHECK(near(segment(bench.scene(), 2).a, {0.5, 2.5}));
    CHECK(near(segment(bench.scene(), 2).b, {1.5, 3.0}));
    CHECK(bench.scene().shapes[2].material == "white");
    CHECK(bench.rig.state().editing.history.past.size() == 1);
    CHECK(isEdited(bench.rig.state()));
    const SceneDescription after = bench.scene();
    bench.rig.driver.click("Controls/Undo");
    CHECK(bench.scene() == before);
    CHECK_FALSE(isEdited(bench.rig.state()));
    bench.rig.driver.click("Controls/Redo");
    CHECK(bench.scene() == after);
    bench.rig.driver.pressKey(Key::ctrl, Key::z);
    CHECK(bench.scene() == before);
}

TEST_CASE("each tool adds its thing") {
    Bench bench;
    for (const Named<Tool>& tool : kTools) {
        if (tool.value == Tool::select) continue;
        const std::size_t things = thingsOf(bench.scene()).size();
        bench.use(std::string(tool.name).c_str());
        bench.drag({2.6, 1.2}, {3.3, 1.9});
        CAPTURE(tool.name);
        CAPTURE(bench.rig.state().editing.message);
        CHECK(thingsOf(bench.scene()).size() == things + 1);
        CHECK_FALSE(bench.rig.state().editing.selected.empty());
    }
    bench.rig.settle();
    CHECK(bench.rig.state().answer->complete);
}

TEST_CASE("a thing is selected and dragged, by itself and by its handles") {
    Bench bench;
    bench.drag({1.5, 1.0}, {2.0, 1.5});  // the lower edge of the block
    CHECK(bench.rig.state().editing.selected == Thing{ThingKind::shape, 1});
    const auto& moved = std::get<BoxShape>(bench.scene().shapes[1].geometry);
    CHECK(near(moved.min, {1.5, 1.5}));
    CHECK(near(moved.max, {2.5, 2.5}));
    bench.drag(moved.max, {3.0, 2.75});
    CHECK(near(std::get<BoxShape>(bench.scene().shapes[1].geometry).max, {3.0, 2.75}));
    CHECK(bench.rig.state().editing.history.past.size() == 2);
    bench.drag({3.0, 3.0}, {3.5, 2.0});
    CHECK(near(std::get<PointLight>(bench.scene().lights[0]).position, {3.5, 2.0}));
}

TEST_CASE("a click on nothing lets go, and dragging it pans") {
    Bench bench;
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 1}});
    const Camera camera = bench.rig.state().camera;
    const SceneDescription before = bench.scene();
    bench.drag({0.3, 2.7}, {0.6, 2.9});
    CHECK(bench.rig.state().editing.selected.empty());
    CHECK_FALSE(bench.rig.state().camera == camera);
    CHECK(bench.scene() == before);
}

TEST_CASE("snapping brings an end to another end, and to the grid") {
    Bench bench;
    bench.rig.driver.click("Controls/Snap");
    bench.use("Wall");
    bench.drag({4.02, 0.03}, {4.01, 1.99});
    REQUIRE(bench.scene().shapes.size() == 3);
    CHECK(segment(bench.scene(), 2).a == Vec2(4.0, 0.0));
    CHECK(segment(bench.scene(), 2).b == Vec2(4.0, 2.0));
}

TEST_CASE("P stays on its wall while others come and go, and finds another when its own is deleted") {
    Bench bench;
    bench.rig.apply(MovePoint{{0, 0.25}});
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 1}});
    bench.rig.driver.click("Controls/Delete");
    CHECK(bench.scene().shapes.size() == 1);
    CHECK(bench.rig.state().at == WallPoint{0, 0.25});
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    bench.rig.driver.click("Controls/Delete");
    CHECK(bench.scene().shapes.size() == 1);
    CHECK(bench.rig.state().editing.message.find("last wall") != std::string::npos);
    bench.rig.apply(Undo{});
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    bench.rig.driver.click("Controls/Delete");
    CHECK(bench.scene().shapes.size() == 1);
    CHECK(bench.rig.state().at.segment < 4);
    bench.rig.settle();
}

TEST_CASE("numbers are typed, names too, and one held control is one step back") {
    Bench bench;
    bench.rig.apply(SelectThings{Thing{ThingKind::light, 0}});
    bench.rig.driver.frames(2);
    bench.rig.driver.typeNumber("Controls/position.0", "2.5");
    CHECK(std::get<PointLight>(bench.scene().lights[0]).position.x == 2.5);
    bench.rig.driver.dragBy("Controls/position", 60, 0);
    CHECK(std::get<PointLight>(bench.scene().lights[0]).position.y > 3.05);
    CHECK(bench.rig.state().editing.history.past.size() == 2);
    bench.rig.driver.click("Controls/Undo");
    CHECK(std::get<PointLight>(bench.scene().lights[0]).position.y == 3.0);
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    bench.rig.driver.frames(2);
    bench.rig.driver.replaceText("Controls/name", "ground");
    CHECK(bench.scene().shapes[0].name == "ground");
    bench.rig.driver.replaceText("Controls/name", "block");
    CHECK(bench.scene().shapes[0].name != "block");  // the box has it
}

TEST_CASE("a wrong value is told and not taken") {
    Bench bench;
    SceneDescription flat = bench.scene();
    std::get<SegmentShape>(flat.shapes[0].geometry).b = {0.0, 0.0};
    const SceneDescription before = bench.scene();
    bench.rig.apply(EditScene{flat, std::nullopt, false});
    CHECK(bench.scene() == before);
    CHECK(bench.rig.state().editing.message.find("zero length") != std::string::npos);
    CHECK(bench.rig.state().editing.history.past.empty());
}

TEST_CASE("the material of a thing is chosen, made anew and changed") {
    Bench bench;
    bench.rig.apply(SelectThings{Thing{ThingKind::shape, 0}});
    bench.rig.driver.frames(2);
    bench.rig.scrollTo("Controls/new", "Controls/Undo");
    bench.rig.driver.click("Controls/new");
    bench.rig.driver.frames(2);
    bench.rig.driver.click("Controls/new/mirror");
    bench.rig.driver.frames(2);
    CHECK(bench.scene().shapes[0].material == "mirror");
    CHECK(bench.scene().shapes[1].material == "white");
    bench.rig.scrollTo("Controls/reflectance", "Controls/Undo");
    bench.rig.driver.typeNumber("Controls/reflectance", "0.25");
    CHECK(std::get<Mirror>(bench.scene().materials.back().material).reflectance.z == 0.25);
    bench.rig.settle();
}

TEST_CASE("what is saved reads back the same; comments go only when that was said") {
    Bench bench;
    bench.use("Lamp");
    bench.drag({2.0, 3.5}, {1.0, 3.5});
    bench.rig.apply(SaveScene{bench.file("mine.toml")});
    CHECK(loadScene(bench.file("mine.toml")) == bench.scene());
    CHECK_FALSE(isEdited(bench.rig.state()));
    std::ofstream(bench.file("mine.toml")) << "# my notes\n" << Bench::kRoom;
    bench.rig.apply(SaveScene{bench.file("mine.toml")});
    CHECK(bench.rig.state().editing.message.find("comments") != std::string::npos);
    CHECK(loadScene(bench.file("mine.toml")) != bench.scene());
    bench.rig.apply(SaveScene{bench.file("mine.toml")});
    CHECK(loadScene(bench.file("mine.toml")) == bench.scene());
    bench.rig.apply(SaveScene{bench.file("mine.txt")});
    CHECK(bench.rig.state().editing.message.find(".toml") != std::string::npos);
    bench.rig.apply(SaveScene{"/no/such/folder/x.toml"});
    CHECK(bench.rig.state().editing.message.find("/no/such/folder/x.toml") != std::string::npos);
}

TEST_CASE("in a lesson Reset brings its scene back, and Undo the changes") {
    Rig rig("controls:2");
    const SceneDescription own = rig.state().scene->description;
    rig.apply(SetEditing{true});
    SceneDescription changed = own;
    moveBy(changed, {ThingKind::shape, 0}, {0.0, 0.5});
    rig.apply(EditScene{changed, std::nullopt, false});
    CHECK(rig.state().scene->description == changed);
    rig.apply(ResetStep{});
    CHECK(rig.state().scene->description == own);
    CHECK(rig.state().settings == rig.state().currentStep()->values.settings);
    rig.apply(Undo{});
    CHECK(rig.state().scene->description == changed);
}

TEST_CASE("another step puts unsaved changes aside: they are told, kept, and come back") {
    Rig rig("controls:2");
    SceneDescription changed = rig.state().scene->description;
    moveBy(changed, {ThingKind::shape, 0}, {0.0, 0.5});
    rig.apply(EditScene{changed, std::nullopt, false});
    rig.apply(NextStep{});
    CHECK_FALSE(rig.state().scene->description == changed);
    CHECK(rig.state().editing.message.find("put aside") != std::string::npos);
    REQUIRE(unsavedScene(rig.state()));
    CHECK(unsavedScene(rig.state())->description == changed);
    rig.apply(Undo{});
    CHECK(rig.state().scene->description == changed);
    CHECK(isEdited(rig.state()));
    rig.apply(GoTo{"field", 0});
    const SceneDescription other = rig.state().scene->description;
    rig.apply(Redo{});  // what was undone belongs to another scene
    CHECK(rig.state().scene->description == other);
}

TEST_CASE("a lesson that is read again leaves a scene changed by hand alone") {
    const LessonsCopy lessons;
    Rig rig(openLesson(lessons.folder, LessonRef{"controls", 3}));
    SceneDescription changed = rig.state().scene->description;
    moveBy(changed, {ThingKind::shape, 0}, {0.0, 0.5});
    rig.apply(EditScene{changed, std::nullopt, false});
    rig.apply(SaveScene{(lessons.folder / "mine.toml").string()});  // the folder has changed, too
    rig.apply(Reload{});
    CHECK(rig.state().scene->description == changed);
    CHECK(rig.state().step == 2);
}

TEST_CASE(
    "each scene has a file name of its own, and another's file is only written over when that was said") {
    const LessonsCopy lessons;
    Rig rig(openLesson(lessons.folder, LessonRef{"controls", 1}));
    rig.apply(SetEditing{true});
    const std::string first = rig.state().editing.path;
    rig.apply(SetEditing{false});
    rig.apply(GoTo{"field", 0});
    rig.apply(SetEditing{true});
    CHECK(rig.state().editing.path != first);
    const std::string file = (lessons.folder / "mine.toml").string();
    std::ofstream(file) << Bench::kRoom;  // without comments
    rig.apply(SaveScene{file});
    CHECK(rig.state().editing.message.find("is there already") != std::string::npos);
    CHECK(loadScene(file).title == "Room");
    rig.apply(SaveScene{file});
    CHECK(loadScene(file) == rig.state().scene->description);
    rig.apply(SaveScene{file});  // its own
    CHECK(rig.state().editing.message.find("saved") != std::string::npos);
}

TEST_CASE("a sky's picture that does not lie beside the new file goes along as colours") {
    SceneDescription scene = loadScene(testLessons() / "scenes/box.toml");
    scene.environment.image = "far.png";
    scene.environment.light.strip = {Rgb(1.0), Rgb(0.5)};
    const LessonsCopy folder;
    const SceneDescription moved = withoutFarImage(scene, folder.folder / "x.toml");
    CHECK(moved.environment.image.empty());
    CHECK(moved.environment.light.strip.size() == 2);
    std::ofstream(folder.folder / "far.png") << "there";
    CHECK(withoutFarImage(scene, folder.folder / "x.toml") == scene);
}

TEST_CASE("unsaved changes are not lost when the file changes on the disk") {
    Bench bench;
    bench.use("Wall");
    bench.drag({0.5, 2.5}, {1.5, 3.0});
    const SceneDescription mine = bench.scene();
    bench.rig.apply(Reload{});
    CHECK(bench.scene() == mine);
    CHECK(bench.rig.state().banner.find("unsaved changes") != std::string::npos);
}

TEST_CASE("a history takes no more memory than it may, and keeps the newest") {
    Bench bench;
    SceneDescription scene = bench.scene();
    scene.shapes.push_back(
        {"big", CircleShape{{2.0, 2.0}, 1.0, 100'000, Facing::out, false}, "white", Rgb(0.0), false});
    for (int i = 0; i < 8; ++i) {
        std::get<PointLight>(scene.lights[0]).position.x = i;
        bench.rig.apply(EditScene{scene, std::nullopt, false});
    }
    const auto& past = bench.rig.state().editing.history.past;
    CHECK(past.size() >= 1);
    CHECK(past.size() < 8);
    std::size_t bytes = 0;
    for (const auto& kept : past) bytes += bytesOf(*kept);
    CHECK(bytes <= kUndoBytes + bytesOf(*past.front()));
    CHECK(std::get<PointLight>(past.back()->description.lights[0]).position.x == 6.0);
}
