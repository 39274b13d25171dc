// Is a lens of the curvatures, the height and the thickness that were asked for, and refused if there is
// none?
#include "lessons/lens.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "error_cases.h"
#include "lessons/scene_file.h"

using namespace halfdisk;

namespace {

bool sameBits(Vec2 a, Vec2 b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

struct LensCase {
    Vec2 radius;
    double height, thickness;
    bool rim;
};

const double kSag = 1.0 - std::sqrt(1.0 - 0.25 * 0.25);  // radius 1, height 0.5

/// Biconvex, plano-convex, biconcave, both menisci, half disks, a slab; with and without a rim.
const LensCase kLenses[] = {
    {{1, 1}, 0.5, 0.2, true},    {{1, 1}, 0.5, 2 * kSag, false}, {{1, 0}, 0.5, 0.2, true},
    {{0, 1}, 0.5, kSag, false},  {{-1, -2}, 0.5, 0.01, true},    {{1, -1.5}, 0.5, 0.05, true},
    {{-3, 0.5}, 0.5, 0.3, true}, {{1, 1}, 2.0, 2.0, false},      {{0, 0.25}, 0.5, 0.25, false},
    {{0, 0}, 0.5, 0.1, true},    {{-0.25, 0.25}, 0.5, 0.3, true}};

LensShape lensOf(const LensCase& c, std::uint32_t segments, bool smooth) {
    return {{3, -2}, {0.6, 0.8}, c.height, c.thickness, c.radius, segments, smooth};
}

/// Twice the signed area of a closed chain of edges: below 0 if it runs clockwise.
double doubleArea(const std::vector<Edge>& edges) {
    double sum = 0.0;
    for (const Edge& e : edges) sum += cross(e.a - edges[0].a, e.b - edges[0].a);
    return sum;
}

/// Whether a point lies inside a closed chain of edges: crossings of a ray to the right.
bool isInside(const std::vector<Edge>& edges, Vec2 p) {
    bool inside = false;
    for (const Edge& e : edges) {
        if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
        if (p.x < e.a.x + (e.b.x - e.a.x) * (p.y - e.a.y) / (e.b.y - e.a.y)) inside = !inside;
    }
    return inside;
}

std::uint32_t edgesOfSurface(double radius, std::uint32_t segments) {
    return radius == 0.0 ? 1 : segments;
}

}  // namespace

TEST_CASE("a lens is one closed loop whose fronts all look outward") {
    for (const LensCase& c : kLenses)
        for (const std::uint32_t n : {2u, 3u, 16u, 301u}) {
            CAPTURE(c.radius.x);
            CAPTURE(c.radius.y);
            CAPTURE(n);
            const LensShape lens = lensOf(c, n, false);
            REQUIRE_FALSE(facetsCross(lens));
            const std::vector<Edge> edges = edgesOf(lens);
            REQUIRE(edges.size() ==
                    edgesOfSurface(c.radius.x, n) + edgesOfSurface(c.radius.y, n) + (c.rim ? 2u : 0u));
            REQUIRE(edges.size() == edgeCount(lens));
            for (std::size_t k = 0; k < edges.size(); ++k)
                CHECK(sameBits(edges[k].b, edges[(k + 1) % edges.size()].a));
            CHECK(doubleArea(edges) < 0.0);
            // A small step to the front leaves the lens, one to the back stays in it.
            for (const Edge& e : edges) {
                const Vec2 middle = 0.5 * (e.a + e.b);
                const Vec2 step = 1e-4 * perp(e.b - e.a);
                CHECK_FALSE(isInside(edges, middle + step));
                CHECK(isInside(edges, middle - step));
            }
        }
}

TEST_CASE("the surfaces of a lens have their radii, its height and its thickness") {
    for (const LensCase& c : kLenses)
        for (const std::uint32_t n : {2u, 7u, 64u}) {
            const LensShape lens = lensOf(c, n, true);
            const std::vector<Edge> edges = edgesOf(lens);
            const Vec2 along(0.6, 0.8), across(-0.8, 0.6);
            std::size_t first = 0;
            for (const double side : {-1.0, 1.0}) {
                const double radius = side < 0.0 ? c.radius.x : c.radius.y;
                const std::size_t count = edgesOfSurface(radius, n);
                CAPTURE(radius);
                const Vec2 apex = lens.center + side * c.thickness / 2 * along;
                const Vec2 middle = apex - side * radius * along;  // of the circle
                for (std::size_t k = first; k < first + count; ++k) {
                    for (const Vec2 p : {edges[k].a, edges[k].b}) {
                        if (radius == 0.0)
                            CHECK(std::abs(glm::dot(p - apex, along)) < 1e-14);
                        else
                            CHECK(std::abs(glm::distance(p, middle) - std::abs(radius)) < 2e-15 * 10);
                        CHECK(std::abs(glm::dot(p - lens.center, across)) < c.height / 2 + 1e-14);
                    }
                    if (radius == 0.0) continue;
                    for (const auto& [p, normal] :
                         {std::pair(edges[k].a, edges[k].normalA), std::pair(edges[k].b, edges[k].normalB)}) {
                        CHECK(std::abs(glm::length(normal) - 1.0) < 1e-15 * 4);
                        CHECK(glm::distance(normal, (p - middle) / radius) < 1e-14 / std::abs(radius) * 4);
                        CHECK(glm::dot(normal, perp(edges[k].b - edges[k].a)) > 0.0);
                    }
                    if (k > first) CHECK(sameBits(edges[k].normalA, edges[k - 1].normalB));
                }
                // The first surface runs upward, the second one downward.
                const Vec2 low = side < 0.0 ? edges[first].a : edges[first + count - 1].b;
                const Vec2 high = side < 0.0 ? edges[first + count - 1].b : edges[first].a;
                CHECK(std::abs(glm::dot(low - lens.center, across) + c.height / 2) < 1e-14);
                CHECK(std::abs(glm::dot(high - lens.center, across) - c.height / 2) < 1e-14);
                first += count + (c.rim ? 1 : 0);
            }
        }
}

TEST_CASE("rims and flat surfaces of a smooth lens are flat, and those of a plain lens everything") {
    const auto isFlat = [](const Edge& e) { return e.normalA == Vec2(0.0) && e.normalB == Vec2(0.0); };
    const auto edges = edgesOf(LensShape{{0, 0}, {1, 0}, 0.5, 0.2, {1, 0}, 4, true});
    REQUIRE(edges.size() == 7);
    for (std::size_t k = 0; k < 7; ++k) CHECK(isFlat(edges[k]) == (k >= 4));
    CHECK(edges[4].a.y == 0.25);  // the upper rim
    CHECK(edges[4].b == Vec2(0.1, 0.25));
    CHECK(edges[5].b == Vec2(0.1, -0.25));  // the flat surface
    for (const Edge& e : edgesOf(LensShape{{0, 0}, {1, 0}, 0.5, 0.2, {1, 1}, 4, false})) CHECK(isFlat(e));
}

TEST_CASE("a lens is symmetric to the last bit") {
    const auto edges = edgesOf(LensShape{{0, 0}, {1, 0}, 0.5, 0.2, {1, 1}, 9, true});
    for (std::size_t k = 0; k < 9; ++k) {
        CHECK(edges[k].a == Vec2(edges[8 - k].b.x, -edges[8 - k].b.y));
        CHECK(edges[k].a == -edges[k + 10].a);
        CHECK(edges[k].normalA == -edges[k + 10].normalA);
    }
}

TEST_CASE("the radius of a lens is one number or two, and 0 is flat") {
    const std::string lens = "[[lens]]\ncenter = [0, 0]\nheight = 1\nthickness = 0.5\nsegments = 8\n";
    const auto read = [&](const std::string& keys) {
        return std::get<LensShape>(parseScene(lens + keys, "x").shapes.at(0).geometry);
    };
    CHECK(read("radius = 2") == LensShape{{0, 0}, {1, 0}, 1.0, 0.5, {2, 2}, 8, false});
    CHECK(read("radius = [2, -3.5]\naxis = [0, 7]\nsmooth = true") ==
          LensShape{{0, 0}, {0, 7}, 1.0, 0.5, {2, -3.5}, 8, true});
    CHECK(read("radius = 0").radius == Vec2(0.0));
    for (const char* keys : {"radius = 2", "radius = [2, -3.5]\naxis = [0, 7]\nsmooth = true"}) {
        const SceneDescription scene = parseScene(lens + keys, "x");
        CHECK(parseScene(writeScene(scene), "y") == scene);
    }
    CHECK(writeScene(parseScene(lens + "radius = 2", "x")).find("radius = 2.0\n") != std::string::npos);
}

TEST_CASE("lenses that cannot be are refused") {
    const auto check = [](const std::string& keys, std::initializer_list<std::string_view> said) {
        const std::string text = "[[lens]]\ncenter = [0, 0]\n" + keys;
        checkErrors({{text, said}}, "x.toml", [](const std::string& scene) { parseScene(scene, "x.toml"); });
    };
    const std::string rest = "\nsegments = 16\n";
    check("height = 1\nthickness = 0.5\nradius = ^0.4" + rest,
          {"a surface of radius 0.4", "height of 1", "0.5 or more, -0.5 or less, or 0 for a flat"});
    check("height = 1\nthickness = 0.5\nradius = [2, ^-0.4]" + rest, {"radius -0.4"});
    check("height = 1\nthickness = 0.5\nradius = [^0.4, 0.1]" + rest, {"radius 0.4"});
    check("height = 1\nthickness = 0.5\nradius = ^'flat'" + rest, {"\"radius\" is a string"});
    check("height = 1\nthickness = 0.5\nradius = ^[1, 1, 1]" + rest, {"one radius or two [r1, r2]"});
    check("height = 1\nthickness = 0.5\nradius = ^inf" + rest, {"\"radius\" is inf", "flat at 0"});
    // radius 1 at height 1 is 0.13397... deep: twice that is the least thickness.
    check("height = 1\nthickness = ^0.26\nradius = 1" + rest, {"the surfaces cross", "0.2679491924311"});
    check("height = 1\nthickness = ^0.1\nradius = [0, 1]" + rest, {"the surfaces cross", "0.13397459621556"});
    check("height = 1\nthickness = ^0\nradius = -1" + rest, {"\"thickness\" is 0", "above 0"});
    check("height = ^-1\nthickness = 1\nradius = 1" + rest, {"\"height\" is -1"});
    check("height = 1\nthickness = 1\nradius = 1\nsegments = ^1", {"\"segments\" is 1", "from 2"});
    check("height = 1\nthickness = 1\nradius = 1\naxis = ^[0, 0]" + rest, {"\"axis\" is [0, 0]"});
    check("height = ^1e-200\nthickness = 1e-200\nradius = 1" + rest, {"too small", "zero length"});
    // A bent, thin lens: its surfaces keep apart, but three chords do not follow them.
    check("height = 1.9\nthickness = 0.005\nradius = [1, -0.951]\nsegments = ^3", {"facets cross"});
    CHECK_NOTHROW(parseScene(
        "[[lens]]\ncenter=[0,0]\nheight = 1.9\nthickness = 0.005\nradius = [1, -0.951]\nsegments = 64", "x"));
    checkErrors({{"^[[lens]]\ncenter = [0, 0]\nheight = 1\nthickness = 1\nsegments = 4", {"no \"radius\""}},
                 {"[[lens]]\n^centre = [0, 0]\n", {"unknown key \"centre\" in [[lens]]", "\"center\"?"}},
                 {"[[lens]]\ncenter = [0, 0]\n^facing = \"in\"\n", {"unknown key \"facing\""}}},
                "x.toml", [](const std::string& scene) { parseScene(scene, "x.toml"); });
}
