// Which rules does an intersection keep beside geometry? Skips, coincident walls, backs, ends of a shadow
// ray, bad scenes.
#include <doctest/doctest.h>

#include <stdexcept>

#include "core/intersect.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("intersect: a ray meets the front or the back, at t and u") {
    Scene scene;
    addWall(scene, {0.0, 1.0}, {4.0, 1.0});  // faces up
    const SegmentIndex index(scene);
    const Hit fromAbove = index.closestHit({{1.0, 3.0}, {0.0, -0.5}});
    CHECK(fromAbove.front);
    CHECK(fromAbove.t == 4.0);  // in lengths of the direction
    CHECK(fromAbove.u == 0.25);
    const Hit fromBelow = index.closestHit({{3.0, 0.0}, {0.0, 1.0}});
    CHECK(fromBelow);
    CHECK_FALSE(fromBelow.front);
    CHECK(fromBelow.u == 0.75);
    CHECK_FALSE(index.closestHit({{5.0, 0.0}, {0.0, 1.0}}));
    CHECK_FALSE(index.closestHit({{1.0, 3.0}, {0.0, 1.0}}));
    CHECK_FALSE(index.closestHit({{-1.0, 1.0}, {1.0, 0.0}}));  // along its line: a wall has no thickness
}

TEST_CASE("intersect: u runs from a to b in either direction") {
    Scene scene;
    addWall(scene, {4.0, 1.0}, {0.0, 1.0});
    const Hit hit = SegmentIndex(scene).closestHit({{1.0, 0.0}, {0.0, 1.0}});
    CHECK(hit.u == 0.75);
    CHECK(hit.front);
}

TEST_CASE("intersect: a ray does not meet the wall that it leaves") {
    Scene scene;
    addWall(scene, {0.0, 0.0}, {1.0, 0.0});
    addWall(scene, {0.0, -1.0}, {1.0, -1.0});
    const SegmentIndex index(scene);
    CHECK(index.closestHit({{0.5, 1.0}, {0.0, -1.0}}).segment == 0);
    CHECK(index.closestHit({{0.5, 1.0}, {0.0, -1.0}, 0}).segment == 1);
    CHECK(index.occluded({{0.5, 1.0}, {0.0, -1.0}, 0}, 3.0));
    CHECK_FALSE(index.occluded({{0.5, 1.0}, {0.0, -1.0}, 0}, 1.5));
    CHECK_FALSE(index.occluded({{0.5, 1.0}, {0.0, -1.0}, 0}, 3.0, 1));
}

TEST_CASE("intersect: of equal walls the lower index is met") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 a = random.pointIn(-1.0, 1.0), b = random.pointIn(-1.0, 1.0);
        Scene scene;
        addWall(scene, a, b);
        addWall(scene, a, b);
        addWall(scene, a, b);
        const SegmentIndex index(scene);
        const Vec2 target = a + random.in(0.0, 1.0) * (b - a);
        const Vec2 from = random.pointIn(-2.0, 2.0);
        const Hit hit = index.closestHit({from, target - from});
        REQUIRE(hit.segment == 0);
        REQUIRE(index.closestHit({from, target - from, 0}).segment == 1);
    }
}

TEST_CASE("intersect: of walls back to back the one that faces the ray is met") {
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 a = random.pointIn(-1.0, 1.0), b = random.pointIn(-1.0, 1.0);
        Scene scene;
        addWall(scene, a, b);
        addWall(scene, b, a);
        addWall(scene, b, a);
        const SegmentIndex index(scene);
        const Vec2 target = a + random.in(0.0, 1.0) * (b - a);
        const Vec2 from = random.pointIn(-2.0, 2.0);
        const Hit hit = index.closestHit({from, target - from});
        const bool leftOfFirst = cross(b - a, from - a) > 0.0;
        REQUIRE(hit.front);
        REQUIRE(hit.segment == (leftOfFirst ? 0u : 1u));
    }
}

TEST_CASE("intersect: occluded agrees with closestHit at any distance") {
    Random random(3);
    Scene scene;
    for (int i = 0; i < 15; ++i) {
        const Vec2 a = random.pointIn(-1.0, 1.0);
        addWall(scene, a, random.pointIn(-1.0, 1.0));
    }
    const SegmentIndex index(scene);
    int blocked = 0;
    for (int i = 0; i < 200'000; ++i) {
        Ray ray = {random.pointIn(-1.0, 1.0), random.direction()};
        if (i % 3 == 0) ray.skip = static_cast<std::uint32_t>(random.integer(0, 14));
        const double tMax = i % 10 == 0 ? kInfinity : random.in(0.0, 2.0);
        const Hit hit = index.closestHit(ray);
        REQUIRE(index.occluded(ray, tMax) == (hit && hit.t < tMax));
        if (!hit) continue;
        ++blocked;
        // A light on the wall itself is hidden from the wall's back only.
        REQUIRE(index.occluded(ray, hit.t) == !hit.front);
        REQUIRE(index.occluded(ray, hit.t * (1.0 + 1e-9)));
        REQUIRE_FALSE(index.occluded(ray, hit.t * (1.0 - 1e-9)));
        // Without the wall in front, what blocks is what the ray meets behind it.
        Ray behind = ray;
        if (ray.skip != kNoSegment) continue;
        behind.skip = hit.segment;
        REQUIRE(index.occluded(ray, tMax, hit.segment) == (index.closestHit(behind).t < tMax));
    }
    CHECK(blocked > 100'000);
}

TEST_CASE("intersect: points on a wall stay clear of its ends and on its line") {
    Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        Scene scene;
        const double far = random.in(0.0, 1e3);
        const Vec2 offset = far * random.direction();
        const Vec2 a = offset + random.pointIn(-1.0, 1.0), b = offset + random.pointIn(-1.0, 1.0);
        addWall(scene, a, b);
        const SegmentIndex index(scene);
        for (const double u : {0.0, 1e-17, 0.3, 1.0 - 0x1p-53, 1.0}) {
            const Vec2 p = index.pointOn(0, u);
            REQUIRE(glm::length(p - (a + u * (b - a))) <= 2050.0 * index.originShift(0));
            REQUIRE(std::abs(glm::dot(p - a, index.normal(0))) <= index.originShift(0));
            REQUIRE(glm::dot(p - a, b - a) > 0.0);
            REQUIRE(glm::dot(p - b, a - b) > 0.0);
        }
        const double u = random.in(0.1, 0.9);
        REQUIRE(std::abs(glm::length(index.pointOn(0, u) - a) - u * index.length(0)) <=
                2.0 * index.originShift(0));
    }
}

TEST_CASE("intersect: a scene that cannot be is refused") {
    const auto refused = [](Segment s, std::size_t materials = 1) {
        Scene scene;
        scene.materials.resize(materials);
        scene.segments = {{{0.0, 0.0}, {1.0, 0.0}}, s};
        if (materials == 0) scene.segments = {s};
        try {
            SegmentIndex index(scene);
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    };
    CHECK_FALSE(refused({{0.0, 0.0}, {0.0, 1.0}}));
    CHECK(refused({{0.5, 0.5}, {0.5, 0.5}}));
    CHECK(refused({{0.0, 0.0}, {std::nan(""), 1.0}}));
    CHECK(refused({{0.0, 0.0}, {INFINITY, 1.0}}));
    CHECK(refused({{0.0, 0.0}, {0.0, 1.0}, 1}));
    CHECK(refused({{0.0, 0.0}, {0.0, 1.0}, 0}, 0));
    CHECK(refused({{-1e308, -1e308}, {1e308, 1e308}}));  // its length overflows
    CHECK(refused({{0.0, 0.0}, {1e-200, 1e-200}}));      // its length underflows to 0
}
