// Do all ways to find a wall give the same hits, to the bit, and the right ones?
#include <doctest/doctest.h>

#include <cstring>

#include "core/intersect.h"
#include "index_cases.h"
#include "rooms.h"
#include "tests/bench/workloads.h"
#include "wall_by_wall.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// Against everyWall one by one; everyWall itself for its batches.
constexpr std::array kMethods{IndexMethod::bruteForce, IndexMethod::tree, IndexMethod::grid,
                              IndexMethod::automatic, IndexMethod::everyWall};

bool same(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same(const Hit& a, const Hit& b) {
    return a.segment == b.segment && same(a.t, b.t) && same(a.u, b.u) && a.front == b.front;
}

/// A light for every ray.
struct Lights {
    std::vector<double> tMax;
    std::vector<std::uint32_t> lamps;
};

/// At a random place before or behind what the ray meets, on it, or at infinity.
Lights lightsFor(const std::vector<Ray>& rays, const std::vector<Hit>& hits, std::size_t walls,
                 Random& random) {
    Lights lights;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double reach = hits[i] ? hits[i].t : 1.0 / glm::length(rays[i].direction);
        const double kind = random.in(0.0, 1.0);
        lights.tMax.push_back(kind < 0.3 ? kInfinity : kind < 0.5 ? reach : reach * random.in(0.5, 2.0));
        lights.lamps.push_back(random.in(0.0, 1.0) < 0.5 ? kNoSegment
                               : hits[i] && kind < 0.7   ? hits[i].segment
                                                         : static_cast<std::uint32_t>(random.integer(
                                                               0, static_cast<std::int64_t>(walls) - 1)));
    }
    return lights;
}

void checkRays(const Scene& scene, const SegmentIndex& simple, std::size_t count, Random& random) {
    const std::vector<Ray> rays = testRays(simple, count, random);
    std::vector<Hit> hits;
    for (const Ray& ray : rays) {
        hits.push_back(simple.closestHit(ray));
        REQUIRE(complaint(scene, ray, hits.back()) == "");
    }
    const Lights lights = lightsFor(rays, hits, scene.segments.size(), random);
    std::vector<std::uint8_t> hidden, hiddenPoint;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        hidden.push_back(simple.occluded(rays[i], lights.tMax[i], lights.lamps[i]));
        hiddenPoint.push_back(simple.occluded(rays[i], lights.tMax[i]));
        REQUIRE(complaint(scene, rays[i], lights.tMax[i], lights.lamps[i], hidden.back()) == "");
    }
    for (const IndexMethod method : kMethods) {
        CAPTURE(static_cast<int>(method));
        const SegmentIndex index(scene, method);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            CAPTURE(i);
            REQUIRE(same(index.closestHit(rays[i]), hits[i]));
            REQUIRE(index.occluded(rays[i], lights.tMax[i], lights.lamps[i]) == (hidden[i] != 0));
        }
        // In batches of every size.
        std::vector<Hit> batch(rays.size());
        std::vector<std::uint8_t> answers(rays.size(), 7);
        for (std::size_t first = 0, size = 0; first < rays.size(); first += size++) {
            const std::size_t now = std::min(size, rays.size() - first);
            index.closestHits(std::span(rays).subspan(first, now), std::span(batch).subspan(first, now));
            index.occluded(std::span(rays).subspan(first, now), std::span(lights.tMax).subspan(first, now),
                           std::span(answers).subspan(first, now));
        }
        for (std::size_t i = 0; i < rays.size(); ++i) {
            CAPTURE(i);
            REQUIRE(same(batch[i], hits[i]));
            REQUIRE(answers[i] == hiddenPoint[i]);
        }
    }
}

void checkFans(const Scene& scene, const SegmentIndex& simple, std::size_t count, Random& random) {
    const auto fans = testFans(simple, count, random);
    std::vector<std::vector<Hit>> expected;
    for (const std::vector<Ray>& fan : fans) {
        expected.emplace_back();
        for (const Ray& ray : fan) expected.back().push_back(simple.closestHit(ray));
    }
    for (const IndexMethod method : kMethods) {
        CAPTURE(static_cast<int>(method));
        const SegmentIndex index(scene, method);
        for (std::size_t f = 0; f < fans.size(); ++f) {
            std::vector<Hit> hits(fans[f].size());
            index.closestHitsFan(fans[f], hits);
            CAPTURE(f);
            for (std::size_t i = 0; i < hits.size(); ++i) {
                CAPTURE(i);
                REQUIRE(same(hits[i], expected[f][i]));
            }
        }
    }
}

}  // namespace

TEST_CASE("index: all methods give the same hits to the bit, and long double agrees") {
    Random random(1);
    for (const IndexCase& given : indexCases()) {
        CAPTURE(given.name);
        const SegmentIndex simple(given.scene, IndexMethod::everyWall);
        checkRays(given.scene, simple, given.scene.segments.size() > 300 ? 600 : 1800, random);
        checkFans(given.scene, simple, 24, random);
    }
}

TEST_CASE("index: 10^5 walls") {
    Random random(2);
    for (const Pattern pattern : {Pattern::random, Pattern::circles, Pattern::fractal}) {
        const Scene scene = makePattern(pattern, 100'000);
        CAPTURE(infoOf(pattern).name);
        const SegmentIndex simple(scene, IndexMethod::everyWall);
        checkRays(scene, simple, 120, random);
        checkFans(scene, simple, 2, random);
    }
}

TEST_CASE("index: no walls, no hits") {
    const Scene empty;
    const std::vector<Ray> rays = {{{0.0, 0.0}, {1.0, 0.0}}, {{1e6, -1.0}, {0.0, 1e-30}}};
    for (const IndexMethod method : kMethods) {
        const SegmentIndex index(empty, method);
        std::vector<Hit> hits(2), fan(2);
        std::vector<std::uint8_t> answers(2, 7);
        index.closestHits(rays, hits);
        index.closestHitsFan(rays, fan);
        index.occluded(rays, std::vector{kInfinity, 1.0}, answers);
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK_FALSE(index.closestHit(rays[i]));
            CHECK_FALSE(index.occluded(rays[i], kInfinity));
            CHECK_FALSE(hits[i]);
            CHECK_FALSE(fan[i]);
            CHECK(answers[i] == 0);
        }
    }
}

TEST_CASE("index: nothing asked, nothing answered") {
    const Scene scene = makePattern(Pattern::random, 100);
    for (const IndexMethod method : kMethods) {
        const SegmentIndex index(scene, method);
        index.closestHits({}, {});
        index.closestHitsFan({}, {});
        index.occluded({}, {}, {});
        CHECK(index.method() != IndexMethod::automatic);
    }
}

TEST_CASE("index: of equal walls the first that faces the ray is met, by every method") {
    Random random(3);
    Scene scene;
    constexpr std::uint32_t kWalls = 30;
    std::vector<std::pair<Vec2, Vec2>> ends;
    for (std::uint32_t i = 0; i < kWalls; ++i) {
        const Vec2 a = random.pointIn(-1.0, 1.0);
        ends.emplace_back(a, a + 0.05 * random.direction());
    }
    // Copies far apart in their order; every other one is turned round.
    for (int copy = 0; copy < 6; ++copy)
        for (const auto& [a, b] : ends) copy % 2 == 0 ? addWall(scene, a, b) : addWall(scene, b, a);
    for (const IndexMethod method : kMethods) {
        CAPTURE(static_cast<int>(method));
        const SegmentIndex index(scene, method);
        int compared = 0;
        for (int i = 0; i < 3000; ++i) {
            const auto pick = static_cast<std::uint32_t>(random.integer(0, kWalls - 1));
            const auto& [a, b] = ends[pick];
            const Vec2 target = a + random.in(0.01, 0.99) * (b - a);
            const Vec2 from = target + 1e-3 * random.direction();
            const Hit hit = index.closestHit({from, target - from});
            CAPTURE(i);
            REQUIRE(hit);
            if (hit.segment % kWalls != pick) continue;  // another wall stands between
            ++compared;
            REQUIRE(hit.front);
            REQUIRE(hit.segment == (cross(b - a, from - a) > 0.0 ? pick : pick + kWalls));
        }
        CHECK(compared > 2900);
    }
}

TEST_CASE("index: every instruction set that the processor has gives the same hits, to the bit") {
    Random random(4);
    int tried = 0;
    for (const Named<InstructionSet>& instructions : kInstructionSets) {
        if (!isSupported(instructions.value) || !kernelsOf(instructions.value)) continue;
        ++tried;
        CAPTURE(instructions.name);
        for (const IndexCase& given : indexCases()) {
            CAPTURE(given.name);
            const SegmentIndex simple(given.scene, IndexMethod::everyWall);
            const std::vector<Ray> rays = testRays(simple, 300, random);
            for (const IndexMethod method : kMethods) {
                const SegmentIndex index(given.scene, method, *kernelsOf(instructions.value));
                REQUIRE(index.instructions() == instructions.value);
                for (const Ray& ray : rays) {
                    const Hit hit = simple.closestHit(ray);
                    REQUIRE(same(index.closestHit(ray), hit));
                    REQUIRE(index.occluded(ray, 0.7, hit.segment) == simple.occluded(ray, 0.7, hit.segment));
                }
                for (const std::vector<Ray>& fan : testFans(simple, 4, random)) {
                    std::vector<Hit> hits(fan.size());
                    index.closestHitsFan(fan, hits);
                    for (std::size_t i = 0; i < fan.size(); ++i)
                        REQUIRE(same(hits[i], simple.closestHit(fan[i])));
                }
            }
        }
    }
    MESSAGE("instruction sets tried: " << tried);
    CHECK(tried > 0);
}
