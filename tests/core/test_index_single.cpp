// Does single precision alone find what a careful tracer in float would: right within float's rounding, and
// wrong where that is too coarse?
#include <doctest/doctest.h>

#include <cstring>

#include "core/estimate.h"
#include "index_cases.h"
#include "rooms.h"
#include "wall_by_wall.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

bool same(const Hit& a, const Hit& b) {
    return a.segment == b.segment && std::memcmp(&a.t, &b.t, sizeof a.t) == 0 &&
           std::memcmp(&a.u, &b.u, sizeof a.u) == 0 && a.front == b.front;
}

/// Rays that float can hold: neither far longer nor far shorter than a metre.
std::vector<Ray> raysOfFloat(const SegmentIndex& index, std::size_t count, Random& random) {
    std::vector<Ray> rays = testRays(index, count, random);
    std::erase_if(rays, [](const Ray& ray) {
        const double length = glm::length(ray.direction);
        return length < 1e-6 || length > 1e8;
    });
    return rays;
}

/// Bounces about in a closed room: how many of the rays meet no wall, or one from behind.
std::uint64_t leaksOf(const Scene& room, IndexMethod method, std::uint64_t bounces) {
    Random random(3);
    const SegmentIndex index(room, method);
    std::uint64_t leaks = 0;
    ShadedPoint at = shadedPointOn(index, 0, 0.5);
    for (std::uint64_t bounce = 0; bounce < bounces; ++bounce) {
        const double theta = random.in(0.0, kPi);
        const Vec2 direction = frameFromNormal(at.N).toWorld(std::cos(theta), std::sin(theta));
        const Hit hit = index.closestHit(rayFrom(index, at, direction));
        REQUIRE((!hit || hit.segment != at.segment));
        const bool leaked = !hit || !hit.front;
        leaks += leaked ? 1 : 0;
        at = leaked ? shadedPointOn(index, 0, 0.5) : shadedPointOn(index, hit.segment, hit.u);
    }
    return leaks;
}

}  // namespace

TEST_CASE("single precision: hits and shadows are right within float's rounding") {
    Random random(1);
    for (const IndexCase& given : indexCases()) {
        CAPTURE(given.name);
        const SegmentIndex index(given.scene, IndexMethod::single);
        REQUIRE(index.method() == IndexMethod::single);
        const auto walls = static_cast<std::int64_t>(given.scene.segments.size());
        const std::vector<Ray> rays = raysOfFloat(index, walls > 300 ? 600 : 1800, random);
        std::vector<Hit> batch(rays.size()), fan(rays.size());
        index.closestHits(rays, batch);
        index.closestHitsFan(rays, fan);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Hit hit = index.closestHit(rays[i]);
            CAPTURE(i);
            REQUIRE(complaint(given.scene, rays[i], hit, kFloatEpsilon) == "");
            REQUIRE(same(batch[i], hit));
            REQUIRE(same(fan[i], hit));
            const double reach = hit ? hit.t : 1.0 / glm::length(rays[i].direction);
            for (const double tMax : {kInfinity, reach, reach * random.in(0.5, 2.0)})
                for (const std::uint32_t lamp :
                     {kNoSegment, hit.segment, static_cast<std::uint32_t>(random.integer(0, walls - 1))})
                    REQUIRE(complaint(given.scene, rays[i], tMax, lamp, index.occluded(rays[i], tMax, lamp),
                                      kFloatEpsilon) == "");
        }
    }
}

TEST_CASE("single precision: every instruction set that the processor has gives the same hits, to the bit") {
    Random random(2);
    for (const IndexCase& given : indexCases()) {
        CAPTURE(given.name);
        const SegmentIndex plain(given.scene, IndexMethod::single, *kernelsOf(InstructionSet::baseline));
        const std::vector<Ray> rays = testRays(plain, 300, random);
        for (const Named<InstructionSet>& instructions : kInstructionSets) {
            if (!isSupported(instructions.value) || !kernelsOf(instructions.value)) continue;
            CAPTURE(instructions.name);
            const SegmentIndex index(given.scene, IndexMethod::single, *kernelsOf(instructions.value));
            REQUIRE(index.instructions() == instructions.value);
            for (const Ray& ray : rays) {
                const Hit hit = plain.closestHit(ray);
                REQUIRE(same(index.closestHit(ray), hit));
                REQUIRE(index.occluded(ray, 0.7, hit.segment) == plain.occluded(ray, 0.7, hit.segment));
            }
        }
    }
}

TEST_CASE("single precision: near the origin it sees what double sees, to seven digits and no more") {
    Random random(4);
    const Scene room = polygonRoom(furnacePolygon());
    const SegmentIndex twice(room), single(room, IndexMethod::single);
    int others = 0, rounded = 0;
    for (int i = 0; i < 100'000; ++i) {
        ShadedPoint at = shadedPointOn(
            twice, static_cast<std::uint32_t>(i) % static_cast<std::uint32_t>(room.segments.size()),
            random.in(0.0, 1.0));
        const double theta = random.in(0.0, kPi);
        const Ray ray = rayFrom(twice, at, frameFromNormal(at.N).toWorld(std::cos(theta), std::sin(theta)));
        const Hit a = twice.closestHit(ray), b = single.closestHit(ray);
        REQUIRE(a);
        others += a.segment != b.segment ? 1 : 0;
        if (a.segment != b.segment) continue;
        REQUIRE(a.front == b.front);
        // Off by a few roundings over the sine of the angle between ray and wall.
        const Segment& s = room.segments[a.segment];
        const double sine = std::abs(cross(ray.direction, s.b - s.a)) / glm::length(s.b - s.a);
        CHECK(std::abs(a.t - b.t) * sine <= 16.0 * kFloatEpsilon);
        rounded += a.t != b.t ? 1 : 0;
    }
    CHECK(others < 10);
    CHECK(rounded > 90'000);
}

TEST_CASE("single precision: far from the origin closed rooms leak, in double they don't") {
    for (const auto& shape : {regularPolygon(64), furnacePolygon()}) {
        const Scene near = polygonRoom(shape), far = polygonRoom(moved(shape, 1.0, Vec2(1e5, -1e5)));
        CHECK(leaksOf(far, IndexMethod::automatic, 100'000) == 0);
        const std::uint64_t leaks = leaksOf(far, IndexMethod::single, 100'000);
        CHECK(leaks > 100);
        CHECK(leaksOf(near, IndexMethod::single, 100'000) < leaks / 20);
    }
}

TEST_CASE("single precision: a lamp that lies on a slanted wall is seen, and its wall does not hide it") {
    Random random(5);
    const Vec2 a(0.1, 0.2), along(1.3, 0.7), back(-0.7, 1.3);
    Scene scene;
    const auto at = [&](double u) { return a + u * along; };
    const std::uint32_t lamp = addWall(scene, at(0.31), at(0.67), Rgb(0.5), Rgb(1.0));
    const std::uint32_t wall = addWall(scene, at(0.0), at(1.0));
    const std::uint32_t reversed = addWall(scene, at(1.0), at(0.0));
    const SegmentIndex index(scene, IndexMethod::single);
    for (int i = 0; i < 10'000; ++i) {
        const Vec2 from = at(random.in(0.0, 1.0)) + random.in(0.1, 2.0) * back;
        const double u = random.in(0.0, 1.0);
        const bool lit = u > 0.311 && u < 0.669;
        if (!lit && u > 0.309 && u < 0.671) continue;
        const Vec2 to = at(u) - from;
        const Ray ray{from, glm::normalize(to)}, beyond{from - 4.0 * back, glm::normalize(to + 4.0 * back)};
        CAPTURE(i);
        REQUIRE(index.closestHit(ray).segment == (lit ? lamp : wall));
        REQUIRE(index.closestHit(beyond).segment == reversed);
        if (!lit) continue;
        REQUIRE_FALSE(index.occluded(ray, glm::length(to), lamp));
        REQUIRE(index.occluded(ray, 1.01 * glm::length(to), lamp));
        REQUIRE(index.occluded(beyond, glm::length(to + 4.0 * back), kNoSegment));
    }
}

TEST_CASE("single precision: what float can't hold is not met, and breaks nothing") {
    Scene scene;
    addWall(scene, {1e5, 1e5}, {1e5 + 1e-4, 1e5 + 1e-4});  // both ends round to one place
    addWall(scene, {-1e100, 0.0}, {1e100, 1e39});          // beyond float
    addWall(scene, {1e-50, 0.0}, {0.0, 1e-50});
    addWall(scene, {-2.0, -1.0}, {2.0, -1.0});
    const SegmentIndex index(scene, IndexMethod::single), twice(scene);
    const Ray toFar{{1e5, 1e5 + 1e-4}, {0.70710678, -0.70710678}};
    REQUIRE(twice.closestHit(toFar).segment == 0);
    CHECK(index.closestHit(toFar).segment != 0);
    Random random(6);
    for (int i = 0; i < 20'000; ++i) {
        const double scale = std::pow(10.0, random.in(-60.0, 60.0)),
                     speed = i % 2 == 0 ? 1.0 : std::pow(10.0, random.in(-60.0, 60.0));
        const Ray ray{scale * random.direction(), speed * random.direction()};
        const Hit hit = index.closestHit(ray);
        index.occluded(ray, scale, i % 3 == 0 ? 1 : kNoSegment);
        if (!hit) continue;
        REQUIRE(hit.segment < scene.segments.size());
        REQUIRE((hit.u >= 0.0 && hit.u <= 1.0));
        REQUIRE((hit.t > 0.0 && hit.t < kInfinity));
    }
    const Hit down = index.closestHit({{0.25, 0.0}, {0.0, -1.0}});
    CHECK(down.segment == 3);
    CHECK(down.t == 1.0);
}

TEST_CASE("single precision: it is never taken by itself, and no walls are no trouble") {
    for (const IndexCase& given : indexCases())
        CHECK(SegmentIndex(given.scene).method() != IndexMethod::single);
    const Scene empty;
    const SegmentIndex index(empty, IndexMethod::single);
    CHECK_FALSE(index.closestHit({{0.0, 0.0}, {1.0, 0.0}}));
    CHECK_FALSE(index.occluded({{0.0, 0.0}, {1.0, 0.0}}, kInfinity));
}
