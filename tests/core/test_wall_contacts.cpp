// Are all places found where walls touch, and only these?
#include <doctest/doctest.h>

#include <algorithm>

#include "core/wall_chains.h"
#include "core/wall_contacts.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// Of two walls, by Cramer's rule in long double; empty where they do not cross within both.
std::vector<Vec2> crossingOf(const Segment& s, const Segment& other) {
    const long double ex = s.b.x - s.a.x, ey = s.b.y - s.a.y, fx = other.b.x - other.a.x,
                      fy = other.b.y - other.a.y, dx = other.a.x - s.a.x, dy = other.a.y - s.a.y;
    const long double determinant = ex * fy - ey * fx;
    const long double u = (dx * fy - dy * fx) / determinant, v = (dx * ey - dy * ex) / determinant;
    if (!(u > 0 && u < 1 && v > 0 && v < 1)) return {};
    return {Vec2(static_cast<double>(s.a.x + u * ex), static_cast<double>(s.a.y + u * ey))};
}

}  // namespace

TEST_CASE("contacts: corners are all ends and crossings, as pair by pair") {
    Random random(11);
    Scene scene;
    for (int i = 0; i < 300; ++i) {
        const Vec2 a = random.pointIn(-1.0, 1.0);
        addWall(scene, a, a + random.direction() * random.in(0.01, 0.6));
    }
    // Upright ones share all of their x.
    for (int i = 0; i < 10; ++i) addWall(scene, {0.1 * i, -1.0}, {0.1 * i, 1.0});
    std::vector<Vec2> expected;
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        expected.push_back(scene.segments[i].a);
        expected.push_back(scene.segments[i].b);
        for (std::size_t k = 0; k < i; ++k)
            for (const Vec2 point : crossingOf(scene.segments[i], scene.segments[k]))
                expected.push_back(point);
    }
    const std::vector<Vec2> found = cornersOf(scene.segments);
    REQUIRE(found.size() == expected.size());
    CHECK(expected.size() > 1000);
    for (const Vec2 point : expected) {
        const auto near = [&](Vec2 corner) { return glm::length(corner - point) < 1e-12; };
        REQUIRE(std::any_of(found.begin(), found.end(), near));
    }
    CHECK(std::is_sorted(found.begin(), found.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; }));
}

TEST_CASE("contacts: what stands on a wall, crosses it or lies on it, and not what only comes near") {
    for (const double turn : {0.0, 0.3, kPi / 2, 2.0}) {
        const auto turned = [&](double x, double y) {
            return Vec2(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y);
        };
        Scene scene;
        addWall(scene, turned(0, 0), turned(4, 0));
        addWall(scene, turned(1, 0), turned(1, 1));         // stands on it
        addWall(scene, turned(1.5, -1), turned(2.5, 1));    // crosses it at 2
        addWall(scene, turned(3.2, 0), turned(2.8, 0));     // lies on it
        addWall(scene, turned(0.5, 1e-6), turned(0.5, 1));  // ends above it
        addWall(scene, turned(4, 0), turned(5, 1));         // goes on from its end
        const auto contacts = contactsOf(scene.segments[0], cornersOf(scene.segments));
        const double expected[] = {0.0, 0.25, 0.5, 0.7, 0.8, 1.0};
        REQUIRE(contacts.size() == 6);
        for (std::size_t i = 0; i < 6; ++i) CHECK(contacts[i] == doctest::Approx(expected[i]).epsilon(1e-9));
        CHECK(contactsOf(scene.segments[1], cornersOf(scene.segments)).size() == 2);
    }
}

TEST_CASE("wall chains: a wall that touches a chain cuts it") {
    Scene scene;
    const auto ring = regularPolygon(8);
    for (std::size_t k = 0; k < 8; ++k)
        scene.segments.push_back(
            {.a = ring[k], .b = ring[(k + 1) % 8], .normalA = ring[k], .normalB = ring[(k + 1) % 8]});
    scene.materials.push_back(Diffuse{});
    const double facet = 2.0 * std::sin(kPi / 8);
    const auto stretchAt = [&](std::uint32_t segment, double u) {
        const SegmentIndex index(scene);
        const WallChains chains(index);
        const ChainPlace place = chains.at(segment, u);
        const ChainStretch stretch = chains.stretchAt(place.chain, place.along);
        return Vec2(stretch.from, stretch.to) / facet;
    };
    const auto check = [&](Vec2 found, double from, double to) {
        CHECK(found.x == doctest::Approx(from).epsilon(1e-12));
        CHECK(found.y == doctest::Approx(to).epsilon(1e-12));
    };
    CHECK(stretchAt(2, 0.5) == Vec2(-kInfinity, kInfinity));
    // In the middle of facet 1: the ring is cut once.
    const Vec2 middle = (ring[1] + ring[2]) / 2.0;
    scene.segments.push_back({.a = middle, .b = 3.0 * middle});
    check(stretchAt(0, 0.5), -6.5, 1.5);
    check(stretchAt(1, 0.9), 1.5, 9.5);
    // And in that of facet 5, by a wall from inside.
    scene.segments.push_back({.a = Vec2(0.0), .b = (ring[5] + ring[6]) / 2.0});
    check(stretchAt(1, 0.1), -2.5, 1.5);
    check(stretchAt(4, 0.5), 1.5, 5.5);
    check(stretchAt(7, 0.5), 5.5, 9.5);
    // At a joint: what was a ring begins and ends there. The cuts are those from before.
    scene.segments.push_back({.a = ring[3], .b = 2.0 * ring[3]});
    check(stretchAt(3, 0.5), 0.0, 2.5);
    check(stretchAt(2, 0.5), 6.5, 8.0);
    check(stretchAt(0, 0.5), 2.5, 6.5);
    // A wall alone is cut too.
    const Vec2 onWall = Vec2(-1.0, 0.0) * 2.0;
    scene.segments.push_back({.a = onWall - Vec2(0.0, facet), .b = onWall + Vec2(0.0, 3.0 * facet)});
    scene.segments.push_back({.a = onWall, .b = onWall - Vec2(1.0, 0.0)});
    check(stretchAt(11, 0.1), 0.0, 1.0);
    check(stretchAt(11, 0.9), 1.0, 4.0);
}
