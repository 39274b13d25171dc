// Do several things that are selected move, turn, grow, change and go together, and come back by Undo?
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "app/edit_commands.h"
#include "lessons/scene_file.h"
#include "rig.h"

using namespace halfdisk;

namespace {

constexpr Thing kFloor{ThingKind::shape, 0}, kBlock{ThingKind::shape, 1}, kDisk{ThingKind::shape, 2},
    kBulb{ThingKind::light, 0}, kSun{ThingKind::light, 1}, kEye{ThingKind::eye, 0};

constexpr const char* kRoom = R"(title = "Room"
[material.white]
type = "diffuse"
albedo = 0.5
[material.silver]
type = "mirror"
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
[[circle]]
name = "disk"
center = [3.0, 2.0]
radius = 0.4
segments = 32
[[light]]
type = "point"
position = [3.0, 3.0]
[[light]]
type = "directional"
direction = [0.0, -1.0]
[eye]
position = [0.5, 3.0]
direction = [1.0, 0.0]
)";

SceneDescription room() {
    return parseScene(kRoom, "room");
}

Selection of(std::initializer_list<Thing> things) {
    Selection selection;
    for (const Thing thing : things) selection.add(thing);
    return selection;
}

/// The room with editing on and nothing snapping.
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
    const Selection& selected() const { return rig.state().editing.selected; }
    std::size_t steps() const { return rig.state().editing.history.past.size(); }
    void drag(Vec2 from, Vec2 to) {
        const ImVec2 a = rig.screen(from), b = rig.screen(to);
        rig.driver.frames(20);
        rig.driver.moveTo(a.x, a.y);
        rig.driver.press();
        rig.driver.moveTo((a.x + b.x) / 2, (a.y + b.y) / 2);
        rig.driver.moveTo(b.x, b.y);
        rig.driver.release();
        rig.driver.frames(2);
    }
    void click(Vec2 place) {
        const ImVec2 at = rig.screen(place);
        rig.driver.clickAt(at.x, at.y);
    }
    template <class Act>
    void withShift(const Act& act) {
        rig.host->queue(KeyChange{Key::shift, true});
        rig.driver.frames();
        act();
        rig.host->queue(KeyChange{Key::shift, false});
        rig.driver.frames(2);
    }
};

bool near(Vec2 a, Vec2 b) {
    return glm::length(a - b) < 0.02;  // a pixel or two
}

const BoxShape& block(const SceneDescription& scene) {
    return std::get<BoxShape>(scene.shapes.at(1).geometry);
}
const CircleShape& disk(const SceneDescription& scene) {
    return std::get<CircleShape>(scene.shapes.at(2).geometry);
}
Vec2 bulb(const SceneDescription& scene) {
    return std::get<PointLight>(scene.lights.at(0)).position;
}

}  // namespace

TEST_CASE("a selection has nothing twice, and the last one is the primary one") {
    Selection selection = of({kFloor, kBlock, kFloor});
    CHECK(selection.size() == 2);
    CHECK(selection.primary() == kFloor);
    CHECK_FALSE(selection.single());
    selection.toggle(kFloor);
    CHECK(selection.single() == kBlock);
    selection.toggle(kBlock);
    CHECK(selection.empty());
    CHECK(existing(room(), of({kFloor, {ThingKind::shape, 9}, {ThingKind::light, 7}})) == Selection(kFloor));
}

TEST_CASE("several things turn and grow about their common middle, and keep their places to each other") {
    SceneDescription scene = room();
    const Selection things = of({kBlock, kDisk, kBulb});
    const Vec2 middle = (Vec2(1.5, 1.5) + Vec2(3.0, 2.0) + Vec2(3.0, 3.0)) / 3.0;
    CHECK(glm::length(commonMiddle(scene, things) - middle) < 1e-12);
    turnBy(scene, things, 90.0);
    CHECK(glm::length(commonMiddle(scene, things) - middle) < 1e-12);
    const auto quarter = [&](Vec2 p) { return middle + Vec2(-(p.y - middle.y), p.x - middle.x); };
    CHECK(glm::length(disk(scene).center - quarter({3.0, 2.0})) < 1e-12);
    CHECK(glm::length(bulb(scene) - quarter({3.0, 3.0})) < 1e-12);
    CHECK(glm::length((block(scene).min + block(scene).max) / 2.0 - quarter({1.5, 1.5})) < 1e-12);
    for (int i = 0; i < 3; ++i) turnBy(scene, things, 90.0);
    CHECK(glm::length(disk(scene).center - Vec2(3.0, 2.0)) < 1e-12);
    CHECK(glm::length(block(scene).max - Vec2(2.0)) < 1e-12);
    scaleBy(scene, things, 2.0);
    CHECK(disk(scene).radius == doctest::Approx(0.8));
    CHECK(glm::length(disk(scene).center - (middle + 2.0 * (Vec2(3.0, 2.0) - middle))) < 1e-12);
    CHECK(glm::length(bulb(scene) - (middle + 2.0 * (Vec2(3.0, 3.0) - middle))) < 1e-12);
}

TEST_CASE("one thing turns and grows as it did alone; the eye and the sun turn, too") {
    SceneDescription scene = room();
    turnBy(scene, Selection(kBlock), 90.0);
    SceneDescription alone = room();
    turnBy(alone, kBlock, 90.0);
    CHECK(scene == alone);
    scene = room();
    turnBy(scene, of({kSun, kEye}), 90.0);
    CHECK(glm::length(std::get<DirectionalLight>(scene.lights[1]).direction - Vec2(1.0, 0.0)) < 1e-12);
    CHECK(glm::length(scene.eye->direction - Vec2(0.0, 1.0)) < 1e-12);
    CHECK(scene.eye->position == Vec2(0.5, 3.0));
}

TEST_CASE("several are copied and removed, whatever their order") {
    SceneDescription scene = room();
    const Selection copies = copyOf(scene, of({kDisk, kBulb, kFloor}), {0.1, 0.1});
    CHECK(scene.shapes.size() == 5);
    CHECK(scene.lights.size() == 3);
    CHECK(copies == of({{ThingKind::shape, 3}, {ThingKind::light, 2}, {ThingKind::shape, 4}}));
    remove(scene, copies);
    CHECK(scene == room());
    remove(scene, of({kFloor, kDisk, kEye, kBulb}));
    REQUIRE(scene.shapes.size() == 1);
    CHECK(scene.shapes[0].name == "block");
    CHECK(scene.lights.size() == 1);
    CHECK_FALSE(scene.eye);
}

TEST_CASE("what lies wholly in a rectangle is found, from whichever corner") {
    const SceneDescription scene = room();
    CHECK(within(scene, {0.9, 0.9}, {3.5, 2.5}) == of({kBlock, kDisk}));
    CHECK(within(scene, {3.5, 2.5}, {0.9, 0.9}) == of({kBlock, kDisk}));
    CHECK(within(scene, {0.9, 0.9}, {3.1, 3.1}) == of({kBlock, kBulb}));  // the disk reaches out
    CHECK(within(scene, {-9, -9}, {9, 9}) == of({kFloor, kBlock, kDisk, kBulb, kEye}));
    CHECK(within(scene, {8, 8}, {9, 9}).empty());
}

TEST_CASE("Shift and a click add a thing and take it away again") {
    Bench bench;
    bench.click({1.5, 1.0});
    CHECK(bench.selected() == Selection(kBlock));
    bench.withShift([&] { bench.click({3.0, 1.6}); });
    CHECK(bench.selected() == of({kBlock, kDisk}));
    bench.withShift([&] { bench.click({3.0, 3.0}); });
    CHECK(bench.selected() == of({kBlock, kDisk, kBulb}));
    bench.withShift([&] { bench.click({1.5, 1.0}); });
    CHECK(bench.selected() == of({kDisk, kBulb}));
    bench.click({3.0, 1.6});  // without Shift: this one
    CHECK(bench.selected() == Selection(kDisk));
    bench.withShift([&] { bench.click({0.5, 2.5}); });  // on nothing: they stay
    CHECK(bench.selected() == Selection(kDisk));
    bench.click({0.5, 2.5});
    CHECK(bench.selected().empty());
    bench.click({3.0, 3.0});
    bench.withShift([&] { bench.click({3.0, 3.0}); });
    CHECK(bench.selected().empty());
    CHECK(bench.steps() == 0);
}

TEST_CASE("Shift and a drag on empty ground select what lies inside, and the picture stays") {
    Bench bench;
    const Camera camera = bench.rig.state().camera;
    bench.withShift([&] { bench.drag({0.8, 0.7}, {3.6, 2.6}); });
    CHECK(bench.selected() == of({kBlock, kDisk}));
    bench.withShift([&] { bench.drag({2.6, 2.7}, {3.4, 3.4}); });
    CHECK(bench.selected() == of({kBlock, kDisk, kBulb}));
    CHECK(bench.rig.state().camera == camera);
    CHECK(bench.rig.state().grip == Grip::none);
    CHECK(bench.steps() == 0);
}

TEST_CASE("all that is selected is dragged together, in one step back") {
    Bench bench;
    const SceneDescription before = bench.scene();
    bench.rig.apply(SelectThings{of({kBlock, kBulb, kDisk})});
    bench.drag({1.5, 1.0}, {1.75, 1.25});  // by the lower edge of the block
    CHECK(near(block(bench.scene()).min, {1.25, 1.25}));
    CHECK(near(disk(bench.scene()).center, {3.25, 2.25}));
    CHECK(near(bulb(bench.scene()), {3.25, 3.25}));
    CHECK(bench.selected().size() == 3);
    CHECK(bench.selected().primary() == kBlock);
    CHECK(bench.steps() == 1);
    bench.rig.apply(Undo{});
    CHECK(bench.scene() == before);
}

TEST_CASE("held arrow keys are one step back, and a new press another") {
    Bench bench;
    const SceneDescription before = bench.scene();
    bench.rig.driver.pressKey(Key::ctrl, Key::a);
    CHECK(bench.selected().size() == 6);
    bench.rig.host->queue(KeyChange{Key::right, true});
    bench.rig.driver.frames(60);
    bench.rig.host->queue(KeyChange{Key::right, false});
    bench.rig.driver.frames(3);
    const double moved = bulb(bench.scene()).x - 3.0;
    CHECK(moved > 0.0);
    CHECK(bench.steps() == 1);
    const SceneDescription held = bench.scene();
    bench.rig.driver.pressKey(Key::up);
    CHECK(bench.steps() == 2);
    const double once = bulb(bench.scene()).y - 3.0;
    CHECK(moved > 5.0 * once);
    bench.rig.driver.pressKey(Key::ctrl, Key::z);
    CHECK(bench.scene() == held);
    bench.rig.driver.pressKey(Key::ctrl, Key::z);
    CHECK(bench.scene() == before);
}

TEST_CASE("buttons and keys act on all, and the last wall stays") {
    Bench bench;
    bench.rig.apply(SelectThings{of({kBlock, kDisk})});
    bench.rig.driver.frames(2);
    bench.rig.driver.pressKey(Key::ctrl, Key::d);
    CHECK(bench.scene().shapes.size() == 5);
    CHECK(bench.selected() == of({{ThingKind::shape, 3}, {ThingKind::shape, 4}}));
    bench.rig.driver.click("Controls/Larger");
    bench.rig.driver.click("Controls/Flip");
    CHECK(std::get<BoxShape>(bench.scene().shapes[3].geometry).facing == Facing::in);
    CHECK(std::get<CircleShape>(bench.scene().shapes[4].geometry).facing == Facing::in);
    CHECK(std::get<CircleShape>(bench.scene().shapes[4].geometry).radius == doctest::Approx(0.44));
    CHECK(disk(bench.scene()).facing == Facing::out);
    bench.rig.driver.pressKey(Key::del);
    CHECK(bench.scene().shapes.size() == 3);
    bench.rig.driver.pressKey(Key::ctrl, Key::a);
    bench.rig.driver.pressKey(Key::del);
    CHECK(bench.scene().shapes.size() == 3);
    CHECK(bench.rig.state().editing.message.find("last wall") != std::string::npos);
}

TEST_CASE("a material, the emission and the sides are set for all selected shapes") {
    Bench bench;
    bench.rig.apply(SelectThings{of({kFloor, kBulb, kDisk, kBlock})});
    bench.rig.driver.frames(2);
    bench.rig.scrollTo("Controls/material", "Controls/Undo");
    bench.rig.driver.click("Controls/material");
    bench.rig.driver.frames(2);
    bench.rig.driver.click("Controls/material/silver");
    bench.rig.driver.frames(2);
    for (const Shape& shape : bench.scene().shapes) CHECK(shape.material == "silver");
    CHECK(bench.steps() == 1);
    bench.rig.driver.click("Controls/twoSided");
    for (const Shape& shape : bench.scene().shapes) CHECK(shape.twoSided);
    bench.rig.driver.typeNumber("Controls/emission.0", "2");
    for (const Shape& shape : bench.scene().shapes) CHECK(shape.emission.x == 2.0);
    bench.rig.apply(AddMaterial{0});
    for (const Shape& shape : bench.scene().shapes) CHECK(shape.material == "diffuse");
    CHECK(bench.selected().size() == 4);
    bench.rig.apply(Undo{});
    for (const Shape& shape : bench.scene().shapes) CHECK(shape.material == "silver");
}

TEST_CASE("a selection whose things are gone is forgotten") {
    Bench bench;
    bench.rig.apply(SelectThings{of({kBlock, kDisk})});
    bench.rig.apply(ActOnSelected{EditAct::copy});
    bench.rig.apply(Undo{});
    CHECK(bench.selected().empty());
    bench.rig.apply(SelectThings{everything(bench.scene())});
    bench.rig.apply(OpenFile{bench.folder.folder / "scenes/box.toml"});
    CHECK(bench.selected().empty());
    bench.rig.apply(SelectThings{of({{ThingKind::shape, 77}})});
    CHECK(bench.selected().empty());
}

TEST_CASE("after random changes of many things at once, undo returns to the first state") {
    for (const unsigned seed : {1u, 2u, 3u}) {
        CAPTURE(seed);
        std::mt19937 engine(seed);
        const auto below = [&](std::size_t n) { return engine() % n; };
        Bench bench;
        AppState& state = bench.rig.session.state;
        const SceneDescription first = bench.scene();
        for (int i = 0; i < 400; ++i) {
            Selection some;
            for (const Thing thing : thingsOf(bench.scene()))
                if (below(2) == 0) some.add(thing);
            halfdisk::apply(state, SelectThings{some});
            const bool many = thingsOf(bench.scene()).size() > 24;
            switch (below(8)) {
                case 0:
                    halfdisk::apply(
                        state, MoveSelected{Vec2(0.01 * static_cast<double>(below(100))), below(2) == 0});
                    break;
                case 1:
                    halfdisk::apply(state, SetMaterial{below(2) == 0 ? "white" : "silver"});
                    break;
                case 2:
                    halfdisk::apply(state, Undo{});
                    break;
                case 3:
                    halfdisk::apply(state, many ? Command(Undo{}) : Command(AddMaterial{below(3)}));
                    break;
                default: {
                    const EditAct act = kEditActs[below(kEditActs.size())].value;
                    halfdisk::apply(
                        state, many && act == EditAct::copy ? Command(Undo{}) : Command(ActOnSelected{act}));
                }
            }
            REQUIRE(faultOf(bench.scene()).empty());
            REQUIRE(existing(bench.scene(), bench.selected()) == bench.selected());
        }
        const SceneDescription last = bench.scene();
        const std::size_t steps = bench.steps();
        REQUIRE(steps > 20);
        while (bench.steps() > 0) halfdisk::apply(state, Undo{});
        CHECK(bench.scene() == first);
        for (std::size_t i = 0; i < steps; ++i) halfdisk::apply(state, Redo{});
        bench.rig.driver.frames();
        CHECK(bench.scene() == last);
    }
}
