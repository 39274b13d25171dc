// Do expanded shapes have the right walls, fronts, names, and vertices that neighbours share bit for bit?
#include "lessons/scene_expansion.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

bool sameBits(Vec2 a, Vec2 b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

Vec2 middle(const Edge& e) {
    return 0.5 * (e.a + e.b);
}

/// > 0 if the front of `e` looks away from `center`.
double outwardness(const Edge& e, Vec2 center) {
    return glm::dot(perp(e.b - e.a), middle(e) - center);
}

/// The end at which edge k meets edge k + 1, whichever way they face.
void checkShared(const std::vector<Edge>& edges, bool closed, bool reversed) {
    const std::size_t joints = closed ? edges.size() : edges.size() - 1;
    for (std::size_t k = 0; k < joints; ++k) {
        const Edge& next = edges[(k + 1) % edges.size()];
        CHECK(sameBits(reversed ? edges[k].a : edges[k].b, reversed ? next.b : next.a));
    }
}

}  // namespace

TEST_CASE("a segment and the edges of a polyline run as written") {
    const auto segment = edgesOf(SegmentShape{{1, 2}, {3, 4}});
    REQUIRE(segment.size() == 1);
    CHECK(segment[0].a == Vec2(1, 2));
    CHECK(segment[0].b == Vec2(3, 4));
    const auto line = edgesOf(PolylineShape{{{0, 0}, {1, 0}, {1, 1}}});
    REQUIRE(line.size() == 2);
    CHECK(line[1].a == Vec2(1, 0));
    CHECK(line[1].b == Vec2(1, 1));
    checkShared(line, false, false);
}

TEST_CASE("a clockwise polygon faces outward, a counter-clockwise one inward") {
    const std::vector<Vec2> clockwise{{0.5, 0.2}, {0.5, 0.6}, {0.9, 0.6}, {0.9, 0.2}};
    const auto out = edgesOf(PolygonShape{clockwise});
    REQUIRE(out.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(out[k].a == clockwise[k]);
        CHECK(out[k].b == clockwise[(k + 1) % 4]);
        CHECK(outwardness(out[k], {0.7, 0.4}) > 0.0);
    }
    checkShared(out, true, false);
    for (const Edge& e : edgesOf(PolygonShape{{clockwise.rbegin(), clockwise.rend()}}))
        CHECK(outwardness(e, {0.7, 0.4}) < 0.0);
}

TEST_CASE("a box has bottom, right, top, left in this order, facing as told") {
    const Vec2 middles[] = {{1.5, 2}, {2, 3}, {1.5, 4}, {1, 3}};
    for (const Facing facing : {Facing::out, Facing::in}) {
        const auto edges = edgesOf(BoxShape{{1, 2}, {2, 4}, facing});
        REQUIRE(edges.size() == 4);
        for (std::size_t k = 0; k < 4; ++k) {
            CHECK(middle(edges[k]) == middles[k]);
            CHECK((outwardness(edges[k], {1.5, 3}) > 0.0) == (facing == Facing::out));
        }
        checkShared(edges, true, facing == Facing::out);
    }
}

TEST_CASE("edge k of a circle starts at angle 2 pi k / segments and faces as told") {
    const Vec2 center(3, -1);
    for (const std::uint32_t n : {3u, 4u, 7u, 8u, 100u, 4096u}) {
        for (const Facing facing : {Facing::out, Facing::in}) {
            const auto edges = edgesOf(CircleShape{center, 2.5, n, facing});
            REQUIRE(edges.size() == n);
            const bool out = facing == Facing::out;
            checkShared(edges, true, out);
            for (std::uint32_t k = 0; k < n; ++k) {
                CHECK((outwardness(edges[k], center) > 0.0) == out);
                const double angle = 2 * kPi * k / n;
                const Vec2 expected = center + 2.5 * Vec2(std::cos(angle), std::sin(angle));
                CHECK(glm::distance(out ? edges[k].b : edges[k].a, expected) < 1e-14);
            }
        }
    }
}

TEST_CASE("vertices on the axes are exact and circles are symmetric") {
    for (const std::uint32_t n : {4u, 8u, 12u, 1000u}) {
        CHECK(unitAtFraction(0, n) == Vec2(1, 0));
        CHECK(unitAtFraction(n / 4, n) == Vec2(0, 1));
        CHECK(unitAtFraction(n / 2, n) == Vec2(-1, 0));
        CHECK(unitAtFraction(3 * n / 4, n) == Vec2(0, -1));
        CHECK(unitAtFraction(n, n) == Vec2(1, 0));
        for (std::uint32_t k = 0; k <= n / 4; ++k) {
            const Vec2 u = unitAtFraction(k, n), mirrored = unitAtFraction(n / 4 - k, n);
            CHECK(u == Vec2(mirrored.y, mirrored.x));
            CHECK(unitAtFraction(n / 2 - k, n) == Vec2(-u.x, u.y));
        }
    }
    for (const double turn : {-720.0, -360.0, 0.0, 360.0}) {
        CHECK(unitAtDegrees(turn) == Vec2(1, 0));
        CHECK(unitAtDegrees(turn + 90) == Vec2(0, 1));
        CHECK(unitAtDegrees(turn + 180) == Vec2(-1, 0));
        CHECK(unitAtDegrees(turn + 270) == Vec2(0, -1));
    }
    CHECK(glm::distance(unitAtDegrees(-30), Vec2(std::sqrt(3) / 2, -0.5)) < 1e-15);
    CHECK(glm::distance(unitAtDegrees(-1e-20), Vec2(1, 0)) < 1e-15);
}

TEST_CASE("an arc runs from its first to its last angle either way round and faces as told") {
    const Vec2 center(-1, 2);
    struct Case {
        double from, to;
        std::uint32_t segments;
    };
    for (const Case& c :
         {Case{0, 90, 1}, Case{0, 90, 5}, Case{90, 0, 5}, Case{-30, 200, 6}, Case{200, -30, 6},
          Case{350, 370, 2}, Case{0, 180, 2}, Case{10, 370, 9}, Case{370, 10, 9}, Case{0.1, 360.1, 4}}) {
        for (const Facing facing : {Facing::out, Facing::in}) {
            CAPTURE(c.from);
            CAPTURE(c.to);
            const auto edges = edgesOf(ArcShape{center, 2, c.from, c.to, c.segments, facing});
            REQUIRE(edges.size() == c.segments);
            const bool out = facing == Facing::out;
            // A left side that looks inwards belongs to the counter-clockwise direction.
            const bool reversed = out == (c.to > c.from);
            const bool full = std::abs(c.to - c.from) > 359.0;
            checkShared(edges, full, reversed);
            for (const Edge& e : edges) CHECK((outwardness(e, center) > 0.0) == out);
            const auto at = [&](double degrees) {
                return center + 2.0 * Vec2(std::cos(degrees * kPi / 180), std::sin(degrees * kPi / 180));
            };
            const Edge &first = edges.front(), &last = edges.back();
            CHECK(glm::distance(reversed ? first.b : first.a, at(c.from)) < 1e-13);
            CHECK(glm::distance(reversed ? last.a : last.b, at(c.to)) < 1e-12);
        }
    }
}

TEST_CASE("counting costs nothing and agrees with the walls made") {
    CHECK(edgeCount(CircleShape{{0, 0}, 1, 1'000'000'000, Facing::out}) == 1'000'000'000);
    for (const Geometry& shape : std::initializer_list<Geometry>{
             SegmentShape{{0, 0}, {1, 0}}, PolylineShape{{{0, 0}, {1, 0}, {1, 1}}},
             PolygonShape{{{0, 0}, {1, 0}, {1, 1}}}, BoxShape{{0, 0}, {1, 1}, Facing::in},
             CircleShape{{0, 0}, 1, 17, Facing::in}, ArcShape{{0, 0}, 1, 0, 50, 17, Facing::in},
             LensShape{{0, 0}, {1, 0}, 1, 0.5, {1, -1}, 17}, LensShape{{0, 0}, {1, 0}, 1, 0.5, {1, 0}, 17},
             LensShape{{0, 0}, {1, 0}, 2, 2, {1, 1}, 17}})
        CHECK(edgeCount(shape) == edgesOf(shape).size());
}

TEST_CASE("zero length is judged by the size of the coordinates") {
    CHECK(isZeroLength({0, 0}, {0, 0}));
    CHECK(isZeroLength({1e9, 0}, {1e9 + 1e-7, 0}));
    CHECK_FALSE(isZeroLength({1e9, 0}, {1e9 + 1e-3, 0}));
    CHECK_FALSE(isZeroLength({0, 0}, {1e-50, 0}));
    CHECK(isZeroLength({0, 0}, {1e-160, 0}));  // its square would vanish
}

TEST_CASE("walls carry name, material, emission and sides; unknown walls are not found") {
    const Scene scene = expandScene(parseScene(R"(
title = "T"
environment = { radiance = 0.25 }
[material.dark]
albedo = 0.1
[material.bright]
albedo = [0.9, 0.8, 0.7]
[[box]]
name = "room"
min = [0, 0]
max = [4, 4]
facing = "in"
material = "bright"
[[segment]]
name = "lamp"
a = [1, 3]
b = [2, 3]
emission = [1, 2, 3]
twoSided = true
[[light]]
type = "directional"
direction = [3e-200, -4e-200]
)",
                                               "x"));
    CHECK(scene.title == "T");
    CHECK(scene.environment == Rgb(0.25));
    REQUIRE(scene.segments.size() == 5);
    CHECK(scene.segmentNames == std::vector<std::string>{"room.0", "room.1", "room.2", "room.3", "lamp"});
    CHECK(scene.materialNames == std::vector<std::string>{"dark", "bright", "default"});
    CHECK(scene.materials[scene.segments[2].material] == Material(Diffuse{Rgb(0.9, 0.8, 0.7)}));
    CHECK(scene.materials[scene.segments[4].material] == Material(Diffuse{Rgb(0.8)}));
    CHECK(scene.segments[4].emission == Rgb(1, 2, 3));
    CHECK(scene.segments[4].twoSided);
    CHECK_FALSE(scene.segments[0].twoSided);
    CHECK(frontNormal(scene.segments[0]) == Vec2(0, 1));
    CHECK(findSegment(scene, "lamp") == 4u);
    CHECK(findSegment(scene, "room.3") == 3u);
    CHECK_FALSE(findSegment(scene, "room").has_value());
    const auto& sun = std::get<DirectionalLight>(scene.lights.at(0));
    CHECK(sun.direction.x == doctest::Approx(0.6));
    CHECK(sun.direction.y == doctest::Approx(-0.8));
}

TEST_CASE("an eye looks along a unit vector, and its field of view is in radians") {
    CHECK_FALSE(expandScene({}).eye.has_value());
    const auto eyeOf = [](std::string_view keys) {
        return expandScene(parseScene("[eye]\nposition = [1, 2]\n" + std::string(keys), "x")).eye.value();
    };
    const Eye eye = eyeOf("direction = [-1e30, 1e-30]");
    CHECK(eye.position == Vec2(1, 2));
    CHECK(eye.direction.x == -1.0);
    CHECK(std::abs(eye.direction.y * 1e60 - 1.0) < 1e-12);
    CHECK(eye.fov == doctest::Approx(kPi / 2).epsilon(1e-15));
    const Eye other = eyeOf("direction = [3, 4]\nfov = 60");
    CHECK(glm::distance(other.direction, Vec2(0.6, 0.8)) < 1e-15);
    CHECK(other.fov == doctest::Approx(kPi / 3).epsilon(1e-15));
}

TEST_CASE("a file may define the default material itself") {
    const Scene scene =
        expandScene(parseScene("[[segment]]\na=[0,0]\nb=[1,0]\n[material.default]\nalbedo = 0.25", "x"));
    REQUIRE(scene.materials.size() == 1);
    CHECK(scene.materials[0] == Material(Diffuse{Rgb(0.25)}));
    CHECK(expandScene({}).materials.empty());
}

TEST_CASE("made-up names number each kind and never meet a given one") {
    const auto names = [](std::string_view text) { return expandScene(parseScene(text, "x")).segmentNames; };
    const std::string segment = "[[segment]]\na = [0, 0]\nb = [1, 0]\n";
    const std::string circle = "[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = 3\n";
    CHECK(names(segment + circle + segment) ==
          std::vector<std::string>{"segment1", "circle1.0", "circle1.1", "circle1.2", "segment2"});
    CHECK(names(segment + segment + "name = \"segment1\"\n") ==
          std::vector<std::string>{"segment2", "segment1"});
    const auto mixed = names(circle + segment + "name = \"circle1.2\"\n");
    CHECK(std::set<std::string>(mixed.begin(), mixed.end()).size() == 4);
}

TEST_CASE("points on walls are read, and refused with what there is") {
    const Scene scene = expandScene(parseScene("[[segment]]\nname = \"floor 1\"\na=[0,0]\nb=[2,0]", "x"));
    CHECK(parseWallPoint("floor 1:0.25", scene) == WallPoint{0, 0.25});
    CHECK(parseWallPoint("floor 1:1", scene) == WallPoint{0, 1.0});
    CHECK(parseWallPoint("floor 1:2.5e-1", scene) == WallPoint{0, 0.25});
    CHECK(positionOf(scene, {0, 0.25}) == Vec2(0.5, 0));
    const auto refused = [&](std::string_view text, const char* said) {
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(parseWallPoint(text, scene), doctest::Contains(said), InputError);
    };
    refused("floor 1", "expected NAME:T");
    refused("flor 1:0.5", "did you mean \"floor 1\"?");
    for (const char* bad :
         {"floor 1:", "floor 1:x", "floor 1:1.5", "floor 1:-0.1", "floor 1:nan", "floor 1:0x1p-2",
          "floor 1:0.5 ", "floor 1: 0.5", "floor 1:0.5:1", "floor 1:1e999"})
        refused(bad, "T from 0 to 1");
    CHECK_THROWS_WITH_AS(parseWallPoint("a:0", Scene{}), doctest::Contains("no walls"), InputError);
}
