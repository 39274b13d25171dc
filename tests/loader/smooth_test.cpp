// Do the walls of smooth shapes have the normals of the true circle, on their front side?
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

void checkNormals(const std::vector<Edge>& edges, Vec2 center, bool out, bool closed) {
    for (const Edge& e : edges) {
        for (const auto& [p, normal] : {std::pair(e.a, e.normalA), std::pair(e.b, e.normalB)}) {
            CHECK(std::abs(glm::length(normal) - 1.0) < 4e-16);
            CHECK(glm::distance(normal, (out ? 1.0 : -1.0) * glm::normalize(p - center)) < 1e-14);
            CHECK(glm::dot(normal, perp(e.b - e.a)) > 0.0);
        }
    }
    const bool runsOn = sameBits(edges[0].b, edges[1].a);
    for (std::size_t k = 0; k + (closed ? 0 : 1) < edges.size(); ++k) {
        const Edge& next = edges[(k + 1) % edges.size()];
        CHECK(sameBits(runsOn ? edges[k].b : edges[k].a, runsOn ? next.a : next.b));
        CHECK(sameBits(runsOn ? edges[k].normalB : edges[k].normalA, runsOn ? next.normalA : next.normalB));
    }
}

}  // namespace

TEST_CASE("a smooth circle has radial normals, shared bit for bit") {
    for (const std::uint32_t n : {3u, 4u, 5u, 256u, 1000u})
        for (const Facing facing : {Facing::out, Facing::in})
            checkNormals(edgesOf(CircleShape{{3, -1}, 2.5, n, facing, true}), {3, -1}, facing == Facing::out,
                         true);
}

TEST_CASE("a smooth arc has radial normals, whichever way it runs and faces") {
    struct Case {
        double from, to;
        std::uint32_t segments;
        bool full;
    };
    for (const Case& c : {Case{0, 90, 3, false}, Case{90, 0, 5, false}, Case{-30, 200, 2, false},
                          Case{10, 370, 9, true}, Case{370, 10, 9, true}})
        for (const Facing facing : {Facing::out, Facing::in})
            checkNormals(edgesOf(ArcShape{{-1, 2}, 2, c.from, c.to, c.segments, facing, true}), {-1, 2},
                         facing == Facing::out, c.full);
}

TEST_CASE("smooth walls carry their normals into the scene, others none") {
    const std::string circle = "[[circle]]\ncenter = [0, 0]\nradius = 2\nsegments = 8\n";
    for (const Segment& s : expandScene(parseScene(circle, "x")).segments) CHECK_FALSE(isSmooth(s));
    for (const Segment& s : expandScene(parseScene(circle + "smooth = false", "x")).segments)
        CHECK_FALSE(isSmooth(s));
    const Scene scene = expandScene(parseScene(circle + "smooth = true", "x"));
    REQUIRE(scene.segments.size() == 8);
    for (const Segment& s : scene.segments) {
        CHECK(isSmooth(s));
        CHECK(2.0 * s.normalA == s.a);
        CHECK(2.0 * s.normalB == s.b);
    }
}

TEST_CASE("smoothness is read, checked and written") {
    const auto check = [](const std::string& text, std::initializer_list<std::string_view> said) {
        checkErrors({{text, said}}, "x.toml", [](const std::string& scene) { parseScene(scene, "x.toml"); });
    };
    check("[[circle]]\ncenter = [0, 0]\nradius = 1\nsegments = 8\nsmooth = ^1",
          {"\"smooth\" is a whole number", "true or false"});
    check("[[box]]\nmin = [0, 0]\nmax = [1, 1]\n^smooth = true", {"unknown key \"smooth\" in [[box]]"});
    const std::string arc = "[[arc]]\ncenter = [0, 0]\nradius = 1\nfrom = 0\nto = 180\n";
    check(arc + "smooth = true\nsegments = ^1", {"each edge would span 180", "at most 120 if smooth"});
    CHECK_NOTHROW(parseScene(arc + "segments = 1", "x"));
    CHECK_NOTHROW(parseScene(arc + "smooth = true\nsegments = 2", "x"));
    const SceneDescription scene = parseScene(arc + "smooth = true\nsegments = 2", "x");
    CHECK(std::get<ArcShape>(scene.shapes.at(0).geometry).smooth);
    CHECK(writeScene(scene).find("smooth = true\n") != std::string::npos);
    CHECK(parseScene(writeScene(scene), "y") == scene);
}
