// Are the ways of light that are drawn those that light takes?
#include <doctest/doctest.h>

#include "core/light_way.h"
#include "rooms.h"

using namespace halfdisk;

namespace {

/// A lamp that shines down on a floor, with nothing else.
Scene lampOverFloor(const Material& floor) {
    Scene scene;
    scene.materials = {Diffuse{Rgb(0.5)}, floor};
    Segment ground, lamp;
    ground.a = {-1000.0, 0.0};
    ground.b = {1000.0, 0.0};
    ground.material = 1;
    lamp.a = {0.5, 1.0};
    lamp.b = {-0.5, 1.0};
    lamp.emission = Rgb(1.0);
    scene.segments = {ground, lamp};
    scene.segmentNames = {"ground", "lamp"};
    return scene;
}

}  // namespace

TEST_CASE("light ways: they set out on the lamp, and each corner lies on a wall") {
    const Scene scene = lampOverFloor(Diffuse{Rgb(0.5)});
    const SegmentIndex index(scene);
    const std::vector<LightWay> ways = lightWays(index, 500, 3, 1);
    CHECK(ways.size() == 500);
    for (const LightWay& way : ways) {
        REQUIRE(way.corners.size() >= 2);
        CHECK(std::abs(way.corners[0].y - 1.0) < 1e-9);
        CHECK(std::abs(way.corners[0].x) <= 0.5);
        CHECK(way.word.front() == 'L');
        const std::size_t walls = way.word.size() - 1;
        CHECK(way.corners.size() == walls + 1 + (way.escapes ? 1 : 0));
        CHECK(walls <= 4);
        for (std::size_t i = 1; i <= walls; ++i)
            CHECK((std::abs(way.corners[i].y) < 1e-9 || std::abs(way.corners[i].y - 1.0) < 1e-9));
    }
}

TEST_CASE("light ways: a mirror's letter is S, and it sends light where the law says") {
    const Scene scene = lampOverFloor(Mirror{Rgb(1.0)});
    const SegmentIndex index(scene);
    int seen = 0;
    for (const LightWay& way : lightWays(index, 200, 0, 1)) {
        if (way.corners.size() < 3) continue;
        ++seen;
        CHECK(way.word.substr(0, 2) == "LS");
        const Vec2 in = glm::normalize(way.corners[1] - way.corners[0]),
                   out = glm::normalize(way.corners[2] - way.corners[1]);
        CHECK(std::abs(out.x - in.x) < 1e-9);
        CHECK(std::abs(out.y + in.y) < 1e-9);
    }
    CHECK(seen > 100);
}

TEST_CASE("light ways: of a lamp's light, the share that passes a place is what its angle says") {
    // A matt lamp sends per radian cos/2 of its power: of light from a point below the middle, sin(theta)
    // within
    // +- theta. Far from the lamp it is nearly a point.
    Scene scene = lampOverFloor(Diffuse{Rgb(0.0)});
    scene.segments[1].a.x = 1e-3;
    scene.segments[1].b.x = -1e-3;
    const SegmentIndex index(scene);
    constexpr std::uint32_t kCount = 20'000;
    const std::vector<LightWay> ways = lightWays(index, kCount, 0, 1);
    const double expected = std::sin(std::asin(0.3 / 0.8)),
                 share = static_cast<double>(countPassing(ways, {0.0, 0.2}, 0.3)) / kCount;
    // Places are spread evenly, angles are drawn: four standard errors of a share.
    CHECK(std::abs(share - expected) < 4.0 * std::sqrt(expected * (1.0 - expected) / kCount));
    CHECK(countPassing(ways, {0.0, 1.5}, 0.3) == 0);
}

TEST_CASE("light ways: a dark scene has none, the same seed gives the same") {
    Scene dark = lampOverFloor(Diffuse{Rgb(0.5)});
    dark.segments[1].emission = Rgb(0.0);
    CHECK(lightWays(SegmentIndex(dark), 10, 1, 1).empty());
    const Scene scene = lampOverFloor(Diffuse{Rgb(0.5)});
    const SegmentIndex index(scene);
    const auto a = lightWays(index, 20, 3, 5), b = lightWays(index, 20, 3, 5), c = lightWays(index, 20, 3, 6);
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].corners == b[i].corners);
    CHECK(a[0].corners != c[0].corners);
}
