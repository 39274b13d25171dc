// Are walls cut where a light comes into sight past a corner, and nowhere else?
#include <doctest/doctest.h>

#include <algorithm>

#include "core/patches.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// Along the wall, of one side.
std::vector<double> on(const std::vector<WallPlace>& edges, std::uint32_t segment, bool front = true) {
    std::vector<double> places;
    for (const WallPlace& edge : edges)
        if (edge.segment == segment && edge.front == front) places.push_back(edge.u);
    std::sort(places.begin(), places.end());
    return places;
}

Scene emptyRoom() {
    return polygonRoom({{0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}, {0.0, 2.0}}, Rgb(0.5));
}

}  // namespace

TEST_CASE("shadow edges: a room without shadows has none") {
    Scene room = emptyRoom();
    room.segments[2].emission = Rgb(1.0);
    room.lights.emplace_back(PointLight{{1.0, 1.0}, Rgb(1.0)});
    const SegmentIndex index(room);
    CHECK(shadowEdges(Visibility(index)).empty());
}

TEST_CASE("shadow edges: of a block under a bulb and under the sun, by similar triangles") {
    // Bulb 1.5 m above the floor, block 0.5 m: the shadow is 1.5 times the block, from the bulb's foot.
    Scene room = emptyRoom();
    addWall(room, {1.8, 0.5}, {2.2, 0.5}, Rgb(0.5), Rgb(0.0), true);
    room.lights.emplace_back(PointLight{{1.0, 1.5}, Rgb(1.0)});
    {
        const SegmentIndex index(room);
        const std::vector<double> places = on(shadowEdges(Visibility(index)), 0);
        REQUIRE(places.size() == 2);
        CHECK(4.0 * places[0] == doctest::Approx(1.0 + 1.5 * 0.8).epsilon(1e-5));
        CHECK(4.0 * places[1] == doctest::Approx(1.0 + 1.5 * 1.2).epsilon(1e-5));
    }
    // Without a ceiling, under a slanting sun: as long as the block, farther right by its height.
    room.lights = {DirectionalLight{glm::normalize(Vec2(1.0, -1.0)), Rgb(1.0)}};
    std::swap(room.segments[2], room.segments.back());
    room.segments.pop_back();
    const SegmentIndex index(room);
    const std::vector<double> places = on(shadowEdges(Visibility(index)), 0);
    // The left wall's shadow falls right of its foot: the wall is 2 m high.
    REQUIRE(places.size() == 3);
    CHECK(4.0 * places[0] == doctest::Approx(2.0).epsilon(1e-5));
    CHECK(4.0 * places[1] == doctest::Approx(2.3).epsilon(1e-5));
    CHECK(4.0 * places[2] == doctest::Approx(2.7).epsilon(1e-5));
}

TEST_CASE("shadow edges: both ends of a lamp cast one, and patches end there") {
    Scene room = emptyRoom();
    addWall(room, {2.5, 1.9}, {1.5, 1.9}, Rgb(0.5), Rgb(1.0));
    addWall(room, {1.0, 1.0}, {3.0, 1.0}, Rgb(0.5), Rgb(0.0), true);
    const SegmentIndex index(room);
    const Visibility visibility(index);
    const std::vector<WallPlace> edges = shadowEdges(visibility);
    // By an end at x past a corner at c: on the floor at x + (c - x) 1.9 / 0.9.
    const auto seen = [](double x, double c) { return (x + (c - x) * 1.9 / 0.9) / 4.0; };
    for (const double place : {seen(1.5, 1.0), seen(2.5, 3.0)}) {
        CAPTURE(place);
        const std::vector<double> places = on(edges, 0);
        CHECK(
            std::any_of(places.begin(), places.end(), [&](double u) { return std::abs(u - place) < 1e-5; }));
        const Patches patches(visibility, {20, edges});
        const auto [first, end] = patches.of(0, true);
        CHECK(std::any_of(patches.all().begin() + static_cast<std::ptrdiff_t>(first),
                          patches.all().begin() + static_cast<std::ptrdiff_t>(end),
                          [&](const Patch& patch) { return std::abs(patch.uFrom - place) < 1e-5; }));
    }
    CHECK(on(edges, 5).empty());         // the lamp sees all of the screen's upper side
    CHECK(on(edges, 5, false).empty());  // and nothing of its lower one
}
