// Is the first wall that a ray meets the right one? Against exact arithmetic, and against long double.
#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

#include "core/intersect.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

__extension__ using Int128 = __int128;

struct Integers {
    std::int64_t x, y;
};
struct IntegerWall {
    Integers a, b;
};

std::int64_t crossOf(Integers u, Integers v) {
    return u.x * v.y - u.y * v.x;
}
Integers minus(Integers p, Integers q) {
    return {p.x - q.x, p.y - q.y};
}
Vec2 real(Integers p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

struct ExactHit {
    std::uint32_t segment = kNoSegment;
    Int128 tUp = 0, tDown = 1;  // t as a fraction with a positive denominator
    std::int64_t uUp = 0, uDown = 1;
    bool front = false;
};

/// Cramer's rule for o + t d = a + u (b - a) in whole numbers. Empty for rays that meet a vertex or two walls
/// at the same t: those have rules of their own.
std::optional<ExactHit> exactHit(const std::vector<IntegerWall>& walls, Integers o, Integers d) {
    ExactHit closest;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
        const Integers e = minus(walls[i].b, walls[i].a), ao = minus(walls[i].a, o);
        std::int64_t down = crossOf(d, e), tUp = crossOf(ao, e), uUp = crossOf(ao, d);
        if (down == 0) {
            if (uUp == 0) return std::nullopt;  // along the wall's line
            continue;
        }
        const bool front = down > 0;  // travels from the left of a->b to its right
        if (down < 0) down = -down, tUp = -tUp, uUp = -uUp;
        if (uUp == 0 || uUp == down) return std::nullopt;
        if (uUp < 0 || uUp > down || tUp <= 0) continue;
        const Int128 here = Int128{tUp} * closest.tDown, best = closest.tUp * down;
        if (closest.segment != kNoSegment && here == best) return std::nullopt;
        if (closest.segment == kNoSegment || here < best) closest = {i, tUp, down, uUp, down, front};
    }
    return closest;
}

Integers randomPoint(Random& random, std::int64_t size) {
    const std::int64_t x = random.integer(-size, size);
    return {x, random.integer(-size, size)};
}

/// Rays through random walls on a grid of whole numbers, where every side test is exact. Returns how many
/// were compared.
int compareOnGrid(std::int64_t size, int scenes, int rays, std::uint64_t seed) {
    Random random(seed);
    int compared = 0;
    for (int s = 0; s < scenes; ++s) {
        std::vector<IntegerWall> walls;
        Scene scene;
        while (walls.size() < 12) {
            const IntegerWall w = {randomPoint(random, size), randomPoint(random, size)};
            if (w.a.x == w.b.x && w.a.y == w.b.y) continue;
            walls.push_back(w);
            addWall(scene, real(w.a), real(w.b));
        }
        const SegmentIndex index(scene);
        for (int r = 0; r < rays; ++r) {
            const Integers o = randomPoint(random, size), d = randomPoint(random, size);
            const auto exact = exactHit(walls, o, d);
            if (!exact) continue;
            ++compared;
            const Hit hit = index.closestHit({real(o), real(d)});
            REQUIRE(hit.segment == exact->segment);
            if (!hit) continue;
            const auto t = static_cast<long double>(exact->tUp) / static_cast<long double>(exact->tDown);
            const auto u = static_cast<long double>(exact->uUp) / static_cast<long double>(exact->uDown);
            REQUIRE(std::abs(hit.t - t) <= 1.2e-16L * t);
            REQUIRE(std::abs(hit.u - u) <= 2.3e-16L);
            REQUIRE(hit.front == exact->front);
        }
    }
    return compared;
}

}  // namespace

TEST_CASE("intersect: equals exact arithmetic on 10^6 random rays") {
    // 2^20: products of differences stay below 2^44, so doubles lose nothing but the last division.
    CHECK(compareOnGrid(1 << 20, 100, 10'000, 1) > 999'000);
}

TEST_CASE("intersect: equals exact arithmetic on a coarse grid, where near misses are common") {
    CHECK(compareOnGrid(12, 100, 5'000, 2) > 200'000);
}

TEST_CASE("intersect: agrees with long double on real coordinates, at any scale and offset") {
    Random random(3);
    std::uint64_t compared = 0, unclear = 0;
    for (const auto& [scale, offset] : {std::pair{1.0, 0.0}, {1e-6, 0.0}, {1e6, 0.0}, {1.0, 1e6}}) {
        for (int s = 0; s < 30; ++s) {
            Scene scene;
            for (int i = 0; i < 12; ++i) {
                const Vec2 a = offset + scale * random.pointIn(-1.0, 1.0);
                addWall(scene, a, offset + scale * random.pointIn(-1.0, 1.0));
            }
            const SegmentIndex index(scene);
            for (int r = 0; r < 3000; ++r) {
                const Vec2 o = offset + scale * random.pointIn(-1.0, 1.0), d = random.direction();
                // Differences of doubles are exact in long double at these ratios, so only its own rounding
                // remains.
                long double nearest = INFINITY, second = INFINITY, margin = INFINITY;
                std::uint32_t met = kNoSegment;
                for (std::uint32_t i = 0; i < 12; ++i) {
                    const Segment& w = scene.segments[i];
                    using Real = long double;
                    const Real ex = Real{w.b.x} - w.a.x, ey = Real{w.b.y} - w.a.y, ax = Real{w.a.x} - o.x,
                               ay = Real{w.a.y} - o.y;
                    const Real down = d.x * ey - d.y * ex, t = (ax * ey - ay * ex) / down,
                               u = (ax * d.y - ay * d.x) / down;
                    margin = std::min({margin, std::abs(u), std::abs(u - 1.0L)});
                    if (u < 0.0L || u > 1.0L || t <= 0.0L) continue;
                    if (t < nearest) {
                        second = nearest;
                        nearest = t;
                        met = i;
                    } else {
                        second = std::min(second, t);
                    }
                }
                ++compared;
                const Hit hit = index.closestHit({o, d});
                if (margin < 1e-9L || second - nearest < 1e-9L * scale) {
                    ++unclear;
                    continue;
                }
                REQUIRE(hit.segment == met);
                if (met != kNoSegment)
                    REQUIRE(std::abs(hit.t - nearest) <= 1e-12L * scale * (1.0L + nearest / scale));
            }
        }
    }
    CHECK(unclear < compared / 1000);
}
