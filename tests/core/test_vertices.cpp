// Does a ray that is aimed at a vertex leave a closed polygon exactly once? No leak between neighbours, no
// double hit.
#include <doctest/doctest.h>

#include "core/intersect.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

const std::vector<Placing> kPlacings = {{1.0, {0.0, 0.0}}, {1.0, {1e6, -1e6}}, {1e-6, {0.0, 0.0}},
                                        {1e6, {0.0, 0.0}}, {1e-6, {1.0, 1.0}}, {0.7, {0.3, 12345.678}},
                                        {1e6, {1e6, -3e5}}};

/// How many walls the ray crosses, each wall asked alone.
int crossings(const Scene& scene, const Ray& ray) {
    int count = 0;
    for (const Segment& wall : scene.segments) {
        Scene alone;
        alone.materials = scene.materials;
        alone.segments = {wall};
        if (SegmentIndex(alone).closestHit(ray)) ++count;
    }
    return count;
}

/// From an inner point of a convex polygon: one wall on the way out, met from its front, and nothing behind
/// it.
void checkOneWayOut(const SegmentIndex& index, Ray ray) {
    const Hit hit = index.closestHit(ray);
    REQUIRE(hit);
    REQUIRE(hit.front);
    ray.skip = hit.segment;
    REQUIRE_FALSE(index.closestHit(ray));
    REQUIRE_FALSE(index.occluded(ray, kInfinity));
}

}  // namespace

TEST_CASE("vertices: out of convex polygons of 3 to 10 000 sides exactly once") {
    Random random(1);
    for (const int sides : {3, 4, 5, 17, 100, 1000, 10'000}) {
        for (const Placing& placing : kPlacings) {
            const double scale = placing.scale;
            const Vec2 offset = placing.offset;
            CAPTURE(sides);
            CAPTURE(scale);
            CAPTURE(offset.x);
            const auto points = moved(regularPolygon(sides), scale, offset);
            const Scene room = polygonRoom(points);
            const SegmentIndex index(room);
            const std::size_t stride = sides > 1000 ? 37 : 1;
            for (std::size_t k = 0; k < points.size(); k += stride) {
                // The polygon's inscribed circle has a radius of at least one half.
                const Vec2 inside = offset + scale * 0.3 * random.pointIn(-1.0, 1.0);
                checkOneWayOut(index, {inside, points[k] - inside});
                checkOneWayOut(index, {inside, glm::normalize(points[k] - inside)});
                checkOneWayOut(index, {offset, points[k] - offset});  // the centre: opposite vertices line up
                checkOneWayOut(index, {inside, inside - points[k]});
            }
        }
    }
}

TEST_CASE("vertices: each wall asked alone counts one crossing out of a convex polygon") {
    Random random(2);
    for (const int sides : {3, 4, 6, 50}) {
        const auto points = regularPolygon(sides);
        const Scene room = polygonRoom(points);
        for (const Vec2 vertex : points)
            for (int i = 0; i < 20; ++i) {
                const Vec2 inside = 0.3 * random.pointIn(-1.0, 1.0);
                REQUIRE(crossings(room, {inside, vertex - inside}) == 1);
            }
    }
}

TEST_CASE("vertices: out of polygons that are not convex an odd number of times, into them an even number") {
    Random random(3);
    for (const auto& points : {starPolygon(5, 0.3, 1.0), starPolygon(40, 0.6, 1.0), furnacePolygon()}) {
        for (const auto& [scale, offset] : kPlacings) {
            const Vec2 core = points.size() == 6 ? Vec2(1.2, 0.9) : Vec2(0.0, 0.0);  // a point well inside
            const auto placed = moved(points, scale, offset);
            const Scene room = polygonRoom(placed);
            for (const Vec2 vertex : placed) {
                const Vec2 inside = offset + scale * (core + 0.1 * random.pointIn(-1.0, 1.0));
                REQUIRE(crossings(room, {inside, vertex - inside}) % 2 == 1);
                const Vec2 outside = offset + scale * 5.0 * random.direction();
                REQUIRE(crossings(room, {outside, vertex - outside}) % 2 == 0);
            }
        }
    }
}

TEST_CASE("vertices: straight through two vertices of a square, and along its walls") {
    const std::vector<Vec2> square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    const Scene room = polygonRoom(square);
    CHECK(crossings(room, {{-1.0, -1.0}, {1.0, 1.0}}) % 2 == 0);  // corner to corner, from outside
    CHECK(crossings(room, {{0.5, 0.5}, {1.0, 1.0}}) == 1);
    CHECK(crossings(room, {{0.5, 0.5}, {-1.0, 1.0}}) == 1);
    CHECK(crossings(room, {{-1.0, 0.0}, {1.0, 0.0}}) % 2 == 0);  // along the floor
    CHECK(crossings(room, {{-1.0, 1.0}, {1.0, 0.0}}) % 2 == 0);  // along the ceiling
    CHECK(crossings(room, {{-1.0, 1.0}, {1.0, -1.0}}) % 2 ==
          0);  // touches nothing but the corner at the origin
}
