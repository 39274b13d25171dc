// Does changing a scene by hand do what it says, and never make a scene that a file could not hold?
#include <doctest/doctest.h>

#include <cmath>

#include "lessons/scene_edit.h"
#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

SceneDescription everything() {
    return parseScene(R"(
[material.glass]
type = "dielectric"
[[segment]]
name = "floor"
a = [0, 0]
b = [4, 0]
[[box]]
name = "box"
min = [1, 1]
max = [2, 3]
[[circle]]
name = "disk"
center = [5, 5]
radius = 1
segments = 32
material = "glass"
[[arc]]
name = "arc"
center = [0, 5]
radius = 2
from = 10
to = 100
segments = 8
[[lens]]
name = "lens"
center = [8, 2]
height = 2
thickness = 0.8
radius = 2
segments = 12
material = "glass"
[[polygon]]
points = [[7, 7], [8, 7], [8, 8]]
[[polyline]]
points = [[-1, 0], [-2, 0], [-2, 1]]
[[light]]
type = "point"
position = [3, 3]
[[light]]
type = "directional"
direction = [0, -1]
[eye]
position = [0, 2]
direction = [1, 0]
)",
                      "scene");
}

std::vector<Edge> edges(const SceneDescription& scene, Thing thing) {
    return edgesOf(scene.shapes.at(thing.index).geometry);
}

constexpr Thing kFloor{ThingKind::shape, 0}, kBox{ThingKind::shape, 1}, kDisk{ThingKind::shape, 2},
    kArc{ThingKind::shape, 3}, kLens{ThingKind::shape, 4}, kBulb{ThingKind::light, 0},
    kSun{ThingKind::light, 1}, kEye{ThingKind::eye, 0};

bool near(Vec2 a, Vec2 b) {
    return glm::length(a - b) < 1e-12;
}

}  // namespace

TEST_CASE("edit: all things are listed, and have names") {
    const SceneDescription scene = everything();
    const std::vector<Thing> things = thingsOf(scene);
    CHECK(things.size() == 10);
    for (const Thing& thing : things) {
        CHECK(exists(scene, thing));
        CHECK_FALSE(nameOf(scene, thing).empty());
    }
    CHECK(nameOf(scene, {ThingKind::shape, 5}) == "polygon1");
    CHECK(nameOf(scene, kSun) == "light 2");
    CHECK_FALSE(exists(scene, {ThingKind::shape, 7}));
    CHECK_FALSE(exists(scene, {ThingKind::eye, 1}));
}

TEST_CASE("edit: pulling a handle to a place brings it there, and moving moves all") {
    const SceneDescription scene = everything();
    for (const Thing& thing : thingsOf(scene)) {
        const std::vector<Vec2> handles = handlesOf(scene, thing);
        CAPTURE(nameOf(scene, thing));
        CHECK(handles.empty() == (thing == kSun));
        for (std::size_t k = 0; k < handles.size(); ++k) {
            SceneDescription pulled = scene;
            const Vec2 to = handles[k] + Vec2(0.25, 0.125);
            pullHandle(pulled, thing, k, to);
            // A circle's rim handle lies on its right, a lens' axis keeps its length: they follow in their
            // way.
            const bool own =
                !(thing == kDisk && k == 1) && !(thing == kLens && k >= 1) && !(thing == kEye && k == 1);
            if (own) CHECK(near(handlesOf(pulled, thing)[k], to));
            CHECK(faultOf(pulled).empty());
        }
        SceneDescription moved = scene;
        moveBy(moved, thing, {3.0, -2.0});
        const std::vector<Vec2> after = handlesOf(moved, thing);
        for (std::size_t k = 0; k < handles.size(); ++k) CHECK(near(after[k], handles[k] + Vec2(3.0, -2.0)));
    }
    SceneDescription wide = scene;
    pullHandle(wide, kDisk, 1, {5.0, 8.0});
    CHECK(std::get<CircleShape>(wide.shapes[2].geometry).radius == 3.0);
    pullHandle(wide, kEye, 1, {0.0, 5.0});
    CHECK(wide.eye->direction == Vec2(0.0, 3.0));
}

TEST_CASE("edit: a box pulled over its own corner stays right side out") {
    SceneDescription scene = everything();
    pullHandle(scene, kBox, 2, {0.0, 0.5});
    const auto& box = std::get<BoxShape>(scene.shapes[1].geometry);
    CHECK(box.min == Vec2(0.0, 0.5));
    CHECK(box.max == Vec2(1.0, 1.0));
    CHECK(faultOf(scene).empty());
}

TEST_CASE("edit: an arc's end is pulled the short way round, also over 360 degrees") {
    SceneDescription scene = everything();
    for (const double degrees : {120.0, 170.0, 190.0, 280.0, 350.0}) {
        pullHandle(scene, kArc, 2, Vec2(0.0, 5.0) + 2.0 * unitAtDegrees(degrees));
        CHECK(std::get<ArcShape>(scene.shapes[3].geometry).to == doctest::Approx(degrees).epsilon(1e-12));
    }
}

TEST_CASE("edit: a box that is turned keeps its walls, its front and its edges' order") {
    for (const Facing facing : {Facing::out, Facing::in}) {
        SceneDescription scene = everything();
        std::get<BoxShape>(scene.shapes[1].geometry).facing = facing;
        const std::vector<Edge> before = edges(scene, kBox);
        turnBy(scene, kBox, 30.0);
        CHECK(std::holds_alternative<PolygonShape>(scene.shapes[1].geometry));
        const std::vector<Edge> after = edges(scene, kBox);
        const Vec2 middle(1.5, 2.0), unit = unitAtDegrees(30.0);
        const auto turned = [&](Vec2 p) {
            const Vec2 v = p - middle;
            return middle + Vec2(v.x * unit.x - v.y * unit.y, v.x * unit.y + v.y * unit.x);
        };
        REQUIRE(after.size() == 4);
        for (const Edge& edge : before) {
            int found = 0;
            for (const Edge& other : after)
                found += near(turned(edge.a), other.a) && near(turned(edge.b), other.b) ? 1 : 0;
            CHECK(found == 1);  // also the direction: fronts stay fronts
        }
        CHECK(faultOf(scene).empty());
    }
    SceneDescription quarter = everything();
    turnBy(quarter, kBox, 90.0);
    CHECK(std::get<BoxShape>(quarter.shapes[1].geometry).min == Vec2(0.5, 1.5));
}

TEST_CASE("edit: turning back, scaling back and flipping twice change nothing but roundings") {
    const SceneDescription scene = everything();
    for (const Thing& thing : thingsOf(scene)) {
        if (thing == kBox) continue;
        SceneDescription there = scene;
        turnBy(there, thing, 37.0);
        if (thing.kind == ThingKind::shape && !(thing == kDisk)) CHECK_FALSE(there == scene);
        turnBy(there, thing, -37.0);
        scaleBy(there, thing, 4.0);
        scaleBy(there, thing, 0.25);
        const std::vector<Vec2> before = handlesOf(scene, thing), after = handlesOf(there, thing);
        for (std::size_t k = 0; k < before.size(); ++k) CHECK(near(before[k], after[k]));
        SceneDescription flipped = scene;
        flip(flipped, thing);
        flip(flipped, thing);
        CHECK(flipped == scene);
    }
    SceneDescription dizzy = scene;
    for (int i = 0; i < 1000; ++i) turnBy(dizzy, kArc, 15.0);
    CHECK(faultOf(dizzy).empty());
}

TEST_CASE("edit: flipping turns every wall's front") {
    SceneDescription scene = everything();
    const std::vector<Edge> before = edges(scene, kFloor);
    flip(scene, kFloor);
    CHECK(edges(scene, kFloor)[0].a == before[0].b);
    flip(scene, kDisk);
    CHECK(std::get<CircleShape>(scene.shapes[2].geometry).facing == Facing::in);
}

TEST_CASE("edit: copies have names of their own, and what is removed is gone") {
    SceneDescription scene = everything();
    for (const Thing& thing : thingsOf(everything())) {
        const Thing copy = copyOf(scene, thing, {0.5, 0.5});
        CHECK(exists(scene, copy));
        CHECK(faultOf(scene).empty());
    }
    CHECK(nameOf(scene, {ThingKind::shape, 7}) == "floor 2");
    while (scene.shapes.size() > 1) remove(scene, {ThingKind::shape, scene.shapes.size() - 1});
    remove(scene, kBulb);
    remove(scene, kEye);
    CHECK_FALSE(scene.eye.has_value());
    CHECK(scene.lights.size() == 3);
    CHECK(faultOf(scene).empty());
}

TEST_CASE("edit: what is under the pointer") {
    const SceneDescription scene = everything();
    CHECK(thingAt(scene, {2.5, 0.05}, 0.1) == kFloor);
    CHECK(thingAt(scene, {6.02, 5.0}, 0.1) == kDisk);
    CHECK_FALSE(thingAt(scene, {5.0, 5.0}, 0.1).has_value());  // in the disk, not on it
    CHECK(thingAt(scene, {3.0, 3.05}, 0.1) == kBulb);
    CHECK(thingAt(scene, {0.0, 1.95}, 0.1) == kEye);
    CHECK_FALSE(thingAt(scene, {100.0, 100.0}, 1.0).has_value());
    SceneDescription twice = scene;
    const Thing top = copyOf(twice, kFloor, {0.0, 0.0});
    CHECK(thingAt(twice, {2.5, 0.0}, 0.1) == top);
}

TEST_CASE("edit: what a file could not hold is told") {
    SceneDescription scene = everything();
    pullHandle(scene, kFloor, 1, {0.0, 0.0});
    CHECK(faultOf(scene).find("zero length") != std::string::npos);
    scene = everything();
    moveBy(scene, kFloor, {1e12, 0.0});
    CHECK_FALSE(faultOf(scene).empty());
    scene = everything();
    scene.shapes[0].material = "nothing";
    CHECK(faultOf(scene).find("nothing") != std::string::npos);
}

TEST_CASE("edit: new materials have names of their own and can be written") {
    SceneDescription scene = everything();
    for (std::size_t kind = 0; kind < std::variant_size_v<Material>; ++kind)
        for (int twice = 0; twice < 2; ++twice) {
            const std::string name = addMaterial(scene, kind);
            CHECK(scene.materials.back().name == name);
            CHECK(scene.materials.back().material.index() == kind);
            scene.shapes[0].material = name;
            CHECK(faultOf(scene).empty());
        }
}
