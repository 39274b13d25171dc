#include "index_cases.h"

#include <algorithm>

#include "rooms.h"
#include "tests/bench/workloads.h"

namespace halfdisk::test {
namespace {

Scene withWalls(const std::vector<std::pair<Vec2, Vec2>>& walls) {
    Scene scene;
    for (const auto& [a, b] : walls) addWall(scene, a, b);
    return scene;
}

/// Walls of a grid, every second one turned round; all on shared vertices, rows on one line.
Scene grid(int cells) {
    Scene scene;
    for (int i = 0; i <= cells; ++i)
        for (int k = 0; k < cells; ++k) {
            const Vec2 a(k, i), b(k + 1, i);
            addWall(scene, k % 2 ? b : a, k % 2 ? a : b);
            addWall(scene, {i, k + 1}, {i, k});
        }
    return scene;
}

/// Each wall once more, turned round, and a part of it on the same line.
Scene coincident(Random& random) {
    Scene scene;
    for (int i = 0; i < 20; ++i) {
        const Vec2 a = random.pointIn(-1.0, 1.0), b = random.pointIn(-1.0, 1.0);
        addWall(scene, a, b);
        addWall(scene, b, a);
        addWall(scene, a, b);
        addWall(scene, a, 0.5 * (a + b));
    }
    return scene;
}

/// Many walls through one vertex.
Scene star(int rays) {
    Scene scene;
    for (const Vec2 tip : regularPolygon(rays)) addWall(scene, {0.0, 0.0}, tip);
    return scene;
}

/// Less the walls that are too short to be there.
Scene placed(Scene scene, const Placing& placing) {
    for (Segment& s : scene.segments) {
        s.a = placing.scale * s.a + placing.offset;
        s.b = placing.scale * s.b + placing.offset;
    }
    std::erase_if(scene.segments, [](const Segment& s) { return s.a == s.b; });
    return scene;
}

Vec2 within(const Segment& s, Random& random) {
    return s.a + random.in(0.0, 1.0) * (s.b - s.a);
}

struct RayMaker {
    const SegmentIndex& index;
    Random& random;
    Vec2 min{kInfinity}, max{-kInfinity};

    RayMaker(const SegmentIndex& of, Random& by) : index(of), random(by) {
        for (const Segment& s : index.scene().segments) {
            min = glm::min(min, glm::min(s.a, s.b));
            max = glm::max(max, glm::max(s.a, s.b));
        }
    }
    const Segment& wall() const { return index.scene().segments[anyWall()]; }
    std::uint32_t anyWall() const {
        return static_cast<std::uint32_t>(
            random.integer(0, static_cast<std::int64_t>(index.scene().segments.size()) - 1));
    }
    double extent() const { return glm::length(max - min); }
    Vec2 inside() const {
        const double u = random.in(0.0, 1.0);
        return min + Vec2(u, random.in(0.0, 1.0)) * (max - min);
    }
    Vec2 vertex() const { return random.in(0.0, 1.0) < 0.5 ? wall().a : wall().b; }
    Vec2 axis() const {
        const double sign = random.in(0.0, 1.0) < 0.5 ? 1.0 : -1.0;
        return random.in(0.0, 1.0) < 0.5 ? Vec2(sign, 0.0 * sign) : Vec2(-0.0 * sign, sign);
    }
    Ray off(std::uint32_t segment, double u, double theta) const {
        const Vec2 N = index.normal(segment);
        const Vec2 direction = frameFromNormal(N).toWorld(std::cos(theta), std::sin(theta));
        return {index.pointOn(segment, u) + N * index.originShift(segment), direction, segment};
    }
    Ray make(std::size_t kind) const {
        const Vec2 from = inside();
        switch (kind) {
            case 0:
                return {from, random.direction()};
            case 1:
                return {from, within(wall(), random) - from};  // meets that wall at t = 1 or so
            case 2:
                return {from, vertex() - from};
            case 3:
                return {vertex(), random.direction()};
            case 4:
                return {from, axis()};
            case 5: {  // along the lines of axis-parallel walls
                const Vec2 through = vertex();
                return {random.in(0.0, 1.0) < 0.5 ? Vec2(from.x, through.y) : Vec2(through.x, from.y),
                        axis()};
            }
            case 6: {  // along a wall: from before it, or from on it
                const Segment& s = wall();
                return {s.a + random.in(-2.0, 1.0) * (s.b - s.a), s.b - s.a};
            }
            case 7:
                return off(anyWall(), random.in(-0.01, 1.01), kPi * random.in(0.0, 1.0));
            case 8:
                return off(anyWall(), random.in(0.0, 1.0), std::pow(10.0, random.in(-17.0, 0.0)));
            case 9: {  // from far away
                const Vec2 far = from + extent() * std::pow(10.0, random.in(0.0, 6.0)) * random.direction();
                return {far, inside() - far};
            }
            case 10:
                return {from, random.direction() * std::pow(10.0, random.in(-60.0, 60.0))};
            default: {  // past a vertex, by little
                const Vec2 beside = extent() * std::pow(10.0, random.in(-16.0, -6.0)) * random.direction();
                return {from, vertex() + beside - from, random.in(0.0, 1.0) < 0.3 ? anyWall() : kNoSegment};
            }
        }
    }
};

}  // namespace

std::vector<IndexCase> indexCases() {
    Random random(20);
    std::vector<IndexCase> cases;
    const auto add = [&](const std::string& name, const Scene& scene) {
        cases.push_back({name, scene});
        if (scene.segments.size() > 300) return;
        cases.push_back({name + ", radius 0.001 about (1000, 1000)", placed(scene, {1e-3, Vec2(1000.0)})});
        cases.push_back({name + ", radius 10^6 about (1000, 1000)", placed(scene, {1e6, Vec2(1000.0)})});
    };
    add("one wall", withWalls({{{-0.5, 0.3}, {0.7, -0.2}}}));
    add("one level wall", withWalls({{{1.0, 0.25}, {-1.0, 0.25}}}));
    add("two walls on one line", withWalls({{{-1.0, 0.0}, {0.0, 0.0}}, {{0.5, 0.0}, {1.0, 0.0}}}));
    add("large and small walls", withWalls({{{-1.0, -1.0}, {1.0, -0.9}},
                                            {{0.1, 0.1}, {0.1, 0.1 + 1e-12}},
                                            {{0.5, 0.5}, {0.5 + 1e-6, 0.5}}}));
    for (const unsigned count : {7u, 16u, 17u, 63u, 200u})
        add("random " + std::to_string(count), makePattern(Pattern::random, count));
    add("a polygon of 64", polygonRoom(regularPolygon(64)));
    add("a star of 40 spikes", polygonRoom(starPolygon(40, 0.6, 1.0)));
    add("40 walls through one vertex", star(40));
    add("a grid", grid(8));
    add("coincident walls", coincident(random));
    add("circles", makePattern(Pattern::circles, 256));
    add("random 2000", makePattern(Pattern::random, 2000));
    add("circles 4096", makePattern(Pattern::circles, 4096));
    add("fractal", makePattern(Pattern::fractal, 4096));
    add("a large grid", grid(30));
    return cases;
}

std::vector<Ray> testRays(const SegmentIndex& index, std::size_t count, Random& random) {
    const RayMaker maker(index, random);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) rays.push_back(maker.make(i % 12));
    return rays;
}

std::vector<std::vector<Ray>> testFans(const SegmentIndex& index, std::size_t count, Random& random) {
    const RayMaker maker(index, random);
    std::vector<std::vector<Ray>> fans;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t rays = std::array<std::size_t, 8>{256, 1, 0, 64, 7, 31, 100, 257}[i % 8];
        const Ray start = i % 3 == 0 ? maker.off(maker.anyWall(), random.in(0.0, 1.0), 1.0)
                                     : Ray{i % 3 == 1 ? maker.inside() : maker.vertex(), {1.0, 0.0}};
        const double width = std::array{kPi, 2.0 * kPi, 1e-3, 1.0, 1e-12}[i % 5];
        const double first =
            i % 3 == 0 ? std::atan2(start.direction.y, start.direction.x) - 1.0 : random.in(-kPi, kPi);
        std::vector<double> angles;
        for (std::size_t k = 0; k < rays; ++k)
            angles.push_back(i % 2 == 0 ? (static_cast<double>(k) + 0.5) / static_cast<double>(rays)
                                        : random.in(0.0, 1.0));
        std::sort(angles.begin(), angles.end());
        std::vector<Ray> fan;
        for (const double angle : angles) {
            Ray ray = start;
            ray.direction = Vec2(std::cos(first + width * angle), std::sin(first + width * angle));
            if (i % 4 == 1) ray.direction *= random.in(0.1, 10.0);
            fan.push_back(ray);
        }
        if (i % 7 == 0 && !fan.empty()) fan.push_back(fan.back());  // twice the same
        fans.push_back(std::move(fan));
    }
    return fans;
}

}  // namespace halfdisk::test
