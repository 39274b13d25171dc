// Can one take hold of P, look around and zoom, and does the picture stay where it belongs?
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <cmath>

#include "app/canvas.h"
#include "rig.h"

using namespace halfdisk;

namespace {

void dragPointTo(Rig& rig, Vec2 world) {
    const ImVec2 target = rig.screen(world);
    rig.driver.dragTo("Stage/P", target.x, target.y);
}

/// One pixel, m.
double pixel(const Rig& rig) {
    return 1.0 / rig.state().camera.pixelsPerMeter;
}

void checkNear(Vec2 a, Vec2 b, double tolerance) {
    CHECK(std::abs(a.x - b.x) <= tolerance);
    CHECK(std::abs(a.y - b.y) <= tolerance);
}

/// A grid without end would take all memory of the machine before CTest's time is up.
void limitMemory() {
#ifndef __SANITIZE_ADDRESS__  // which itself reserves far more than it uses
    constexpr rlim_t kMost = rlim_t{4} << 30;
    const rlimit limit{kMost, kMost};
    setrlimit(RLIMIT_AS, &limit);
#endif
}

void checkAllInSight(Rig& rig) {
    const CanvasRect canvas = rig.canvas();
    for (const Segment& s : rig.state().scene->scene.segments)
        for (const Vec2 end : {s.a, s.b}) CHECK(canvas.contains(rig.screen(end)));
}

}  // namespace

TEST_CASE("P is dragged along its wall and on to the next, and the answer follows") {
    Rig rig("controls:1");
    const Rgb first = rig.state().answer->estimate.total();
    dragPointTo(rig, {1.5, 0.0});
    CHECK(rig.state().at.segment == 0);
    CHECK(rig.state().at.t == doctest::Approx(0.75).epsilon(pixel(rig)));
    rig.settle();
    CHECK(rig.state().answer->asked.at == rig.state().at);
    CHECK(rig.state().answer->estimate.total() != first);
    const Rect p = rig.driver.get("Stage/P").rect;
    checkNear(rig.world({p.centerX(), p.centerY()}), {1.5, 0.0}, 1.01 * pixel(rig));

    dragPointTo(rig, {2.0, 1.0});
    CHECK(rig.state().at.segment == 1);
    CHECK(rig.state().at.t == doctest::Approx(0.5).epsilon(pixel(rig)));
    rig.settle();
    CHECK(rig.state().answer->asked.at == rig.state().at);
    CHECK(rig.state().answer->point.N == Vec2(-1.0, 0.0));
}

TEST_CASE("a pointer off the walls takes P to the nearest point of one") {
    Rig rig("controls:1");
    dragPointTo(rig, {1.0, 0.3});
    CHECK(rig.state().at.segment == 0);
    CHECK(rig.state().at.t == doctest::Approx(0.5).epsilon(pixel(rig)));
    dragPointTo(rig, {2.3, -0.2});  // past the corner
    CHECK((rig.state().at == WallPoint{0, 1.0} || rig.state().at == WallPoint{1, 0.0}));
}

TEST_CASE("nearest wall points") {
    Scene scene;
    scene.segments = {Segment{{0, 0}, {4, 0}}, Segment{{0, 2}, {0, 3}}};
    CHECK(nearestWallPoint(scene, {1.0, 0.5}) == WallPoint{0, 0.25});
    CHECK(nearestWallPoint(scene, {-1.0, 2.5}) == WallPoint{1, 0.5});
    CHECK(nearestWallPoint(scene, {9.0, 0.5}) == WallPoint{0, 1.0});
}

TEST_CASE("P stays where it is when the step does not unlock it") {
    Rig rig("controls:2");
    const WallPoint before = rig.state().at;
    dragPointTo(rig, {1.5, 0.0});
    CHECK(rig.state().at == before);
    rig.driver.click("Controls/Unlock all");
    dragPointTo(rig, {1.5, 0.0});
    CHECK(rig.state().at != before);
}

TEST_CASE("P is let go with the button, and a press elsewhere does not take it") {
    Rig rig("controls:1");
    dragPointTo(rig, {1.0, 0.0});
    const WallPoint there = rig.state().at;
    rig.driver.moveTo(rig.screen({0.3, 0.0}).x, rig.screen({0.3, 0.0}).y);
    rig.driver.frames(2);
    CHECK(rig.state().at == there);
    CHECK(rig.state().grip == Grip::none);
    const ImVec2 from = rig.screen({0.5, 1.5});
    rig.driver.moveTo(from.x, from.y);
    rig.driver.press();
    rig.driver.moveTo(from.x + 20, from.y + 20);
    rig.driver.release();
    rig.driver.frames();
    CHECK(rig.state().at == there);
}

TEST_CASE("the wheel zooms about the point under the cursor") {
    Rig rig("controls:1");
    const ImVec2 there = rig.screen({0.4, 1.3}), cursor{std::floor(there.x), std::floor(there.y)};
    rig.driver.moveTo(cursor.x, cursor.y);
    const Vec2 under = rig.world(cursor);
    double before = rig.state().camera.pixelsPerMeter;
    for (const float up : {1.0f, 4.0f, -2.0f, -9.0f, 6.0f}) {
        rig.host->queue(MouseWheel{up, 0});
        rig.driver.frames(2);
        CHECK((rig.state().camera.pixelsPerMeter > before) == (up > 0));
        checkNear(rig.world(cursor), under, 1e-9);
        before = rig.state().camera.pixelsPerMeter;
    }
}

TEST_CASE("dragging the canvas pans, and Fit brings all back") {
    Rig rig("controls:1");
    const Camera fitted = rig.state().camera;
    checkAllInSight(rig);
    const ImVec2 there = rig.screen({1.0, 1.0}), from{std::floor(there.x), std::floor(there.y)};
    const Vec2 held = rig.world(from);
    rig.driver.moveTo(from.x, from.y);
    rig.driver.press();
    for (const float part : {0.2f, 0.6f, 1.0f}) rig.driver.moveTo(from.x + 60 * part, from.y - 35 * part);
    rig.driver.release();
    rig.driver.frames();
    checkNear(rig.world({from.x + 60, from.y - 35}), held, 1e-9);
    CHECK(rig.state().camera != fitted);
    rig.driver.click("Stage/Fit");
    rig.driver.frames(2);
    CHECK(rig.state().camera == fitted);
}

TEST_CASE("resizing and larger letters keep a fitted scene in sight") {
    Rig rig("controls:1", 1920, 1080);
    checkAllInSight(rig);
    rig.host->resize(960, 600);
    rig.driver.frames(4);
    checkAllInSight(rig);
    rig.host->resize(1280, 800);
    rig.driver.frames(4);
    rig.apply(SetUiScale{2.0f});
    rig.driver.frames(4);
    checkAllInSight(rig);
}

TEST_CASE("A+ and A- change the size of everything, within limits") {
    Rig rig("controls:1");
    const float before = rig.driver.get("Lesson/Next").rect.height();
    rig.driver.click("Stage/A+");
    rig.driver.frames(3);
    CHECK(rig.state().uiScale == 1.25f);
    CHECK(rig.host->uiScale() == 1.25f);
    CHECK(rig.driver.get("Lesson/Next").rect.height() > 1.15f * before);
    rig.driver.click("Stage/A-");
    rig.driver.frames(3);
    CHECK(rig.host->uiScale() == 1.0f);
    CHECK(rig.driver.get("Lesson/Next").rect.height() == before);
    for (const float scale : {1e9f, -1.0f, 0.0f}) {
        rig.apply(SetUiScale{scale});
        rig.driver.frames(2);
        CHECK((rig.host->uiScale() >= 0.5f && rig.host->uiScale() <= 6.0f));
    }
}

TEST_CASE("the grid is switched") {
    Rig rig("controls:1");
    CHECK_FALSE(rig.state().shows(View::grid));
    rig.driver.click("Stage/Grid");
    CHECK(rig.state().shows(View::grid));
    rig.driver.click("Stage/Grid");
    CHECK_FALSE(rig.state().shows(View::grid));
}

TEST_CASE("far away and at any magnification the grid ends and the camera stays finite") {
    limitMemory();
    Rig rig("controls:1");
    rig.apply(SetView{View::grid, true});
    for (const double distance : {0.0, 1e3, 1e9, 1e15})
        for (const double magnification : {1e-6, 1e-2, 1e2, 1e6, 1e12}) {
            CAPTURE(distance);
            CAPTURE(magnification);
            rig.apply(SetCamera{Camera{Vec2(distance, -distance), magnification}});
            rig.driver.wheel("Stage/canvas", 1.0f);
            const Camera& camera = rig.state().camera;
            CHECK((isFinite(camera.center) && std::isfinite(camera.pixelsPerMeter)));
            CHECK(camera.pixelsPerMeter > 0.0);
        }
}

TEST_CASE("a wall far larger than the screen is drawn where it is") {
    // Both ends of the wall are millions of pixels away; its middle is on the screen.
    const CanvasRect canvas{{0, 0}, {1000, 1000}};
    const Camera camera{{0.0, 0.0}, 1e7};
    const ImVec2 a = toScreen(camera, canvas, {-1.0, -0.5}), b = toScreen(camera, canvas, {1.0, 0.5});
    const double slope = (b.y - a.y) / (b.x - a.x);
    CHECK(slope == doctest::Approx(-0.5));
}
