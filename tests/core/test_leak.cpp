// Can light leak out of a closed room? From every wall, from its very ends, in sharp corners, at grazing
// angles.
#include <doctest/doctest.h>

#include "core/estimate.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

const std::vector<double> kEnds = {0.0, 1e-17, 1e-12, 0.5, 1.0 - 1e-12, 1.0 - 0x1p-53, 1.0};
const std::vector<double> kGrazing = {1e-300, 1e-17, 1e-15, 1e-12, 1e-9, 1e-6};

/// Follows the ray that leaves wall `from` at u under theta. True if it meets the front of another wall.
bool staysInside(const SegmentIndex& index, std::uint32_t from, double u, double theta, Hit& hit) {
    const ShadedPoint at = shadedPointOn(index, from, u);
    const Vec2 direction = frameFromNormal(at.N).toWorld(std::cos(theta), std::sin(theta));
    hit = index.closestHit(rayFrom(index, at, direction));
    return hit && hit.front && hit.segment != from;
}

/// Angles over the whole half-disk, its grazing ends included.
std::vector<double> halfDisk(int inner) {
    std::vector<double> angles;
    for (const double theta : kGrazing) {
        angles.push_back(theta);
        angles.push_back(kPi - theta);
    }
    for (int i = 0; i < inner; ++i) angles.push_back(kPi * (i + 0.5) / inner);
    return angles;
}

/// Rays from every wall; then on from wherever each of them landed, twice.
int leaks(const std::vector<Vec2>& points, const std::vector<double>& us, const std::vector<double>& thetas) {
    const Scene room = polygonRoom(points);
    const SegmentIndex index(room);
    int count = 0;
    for (std::uint32_t wall = 0; wall < room.segments.size(); ++wall)
        for (const double u : us)
            for (const double theta : thetas) {
                Hit hit;
                if (!staysInside(index, wall, u, theta, hit)) {
                    ++count;
                    continue;
                }
                for (int bounce = 0; bounce < 2; ++bounce) {
                    const Hit here = hit;
                    if (staysInside(index, here.segment, here.u, theta, hit)) continue;
                    ++count;
                    break;
                }
            }
    return count;
}

}  // namespace

TEST_CASE("leak: none from polygons of many shapes, sizes and places") {
    const std::vector<std::vector<Vec2>> shapes = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}},
                                                   wedge(60.0),
                                                   wedge(10.0),
                                                   wedge(2.0),
                                                   wedge(60.0, 0.4),
                                                   wedge(10.0, 1.1),
                                                   wedge(2.0, 2.7),
                                                   regularPolygon(100),
                                                   starPolygon(5, 0.3, 1.0),
                                                   furnacePolygon()};
    const auto thetas = halfDisk(100);
    for (std::size_t shape = 0; shape < shapes.size(); ++shape)
        for (const Placing& placing : {Placing{1.0, Vec2(0.0)},
                                       {1.0, Vec2(1e6, -1e6)},
                                       {1e-6, Vec2(0.0)},
                                       {1e6, Vec2(0.0)},
                                       {1e-6, Vec2(0.01)},
                                       {1.0, Vec2(-0.4, 0.7)}}) {
            CAPTURE(shape);
            CAPTURE(placing.scale);
            CAPTURE(placing.offset.x);
            CHECK(leaks(moved(shapes[shape], placing.scale, placing.offset), kEnds, thetas) == 0);
        }
}

TEST_CASE("leak: none from 20 000 random triangles") {
    Random random(1);
    const auto thetas = halfDisk(4);
    int found = 0, tried = 0;
    while (tried < 20'000) {
        std::vector<Vec2> points = {random.pointIn(-1.0, 1.0), random.pointIn(-1.0, 1.0),
                                    random.pointIn(-1.0, 1.0)};
        if (cross(points[1] - points[0], points[2] - points[0]) < 0.0) std::swap(points[1], points[2]);
        // Points keep 2048 shifts from a wall's ends, and a moved origin lies up to 13/8 of a shift off its
        // wall: that is made for corners above 0.8e-3 rad.
        bool sharp = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 p = glm::normalize(points[(i + 1) % 3] - points[i]),
                       q = glm::normalize(points[(i + 2) % 3] - points[i]);
            sharp = sharp || glm::dot(p, q) > std::cos(1e-3);
        }
        if (sharp) continue;
        ++tried;
        const double scale = std::pow(10.0, random.in(-3.0, 3.0));
        const Vec2 offset = random.direction() * 10.0;
        found += leaks(moved(points, scale, offset), {0.0, 0.3, 1.0}, thetas);
    }
    CHECK(found == 0);
}

TEST_CASE("leak: none from a corner of 1.06 degrees") {
    // A corner that a margin of 64 shifts at a wall's end was too small for.
    const std::vector<Vec2> points = {{-72.466142968422901, 58.055494933183624},
                                      {58.49169662977414, -80.049653606476312},
                                      {-32.442853858399296, 19.467632571398234}};
    CHECK(leaks(points, {0.0, 0.3, 1.0}, halfDisk(4)) == 0);
}

TEST_CASE("leak: none from a corner of a thousandth of a radian") {
    for (const double turn : {0.0, 0.4, 1.1, 2.7, 4.0})
        CHECK(leaks(wedge(1e-3 * 180.0 / kPi, turn), kEnds, halfDisk(100)) == 0);
}

TEST_CASE("leak: none where a box stands on the ground (T-junctions)") {
    Scene scene;
    const std::uint32_t ground = addWall(scene, {-3.0, 0.0}, {3.0, 0.0});
    const std::uint32_t left = addWall(scene, {0.2, 0.0}, {0.2, 0.8});
    addWall(scene, {0.2, 0.8}, {0.9, 0.8});
    const std::uint32_t right = addWall(scene, {0.9, 0.8}, {0.9, 0.0});
    addWall(scene, {0.9, 0.0}, {0.2, 0.0});
    const SegmentIndex index(scene);
    Hit hit;
    for (int i = 1; i < 1000; ++i) {
        const double down = kPi / 2.0 * i / 1000.0;
        CHECK(staysInside(index, left, 0.0, down, hit) ==
              false);  // up and away: right is upwards on this wall
        // Downwards from the foot of the box, the ground.
        REQUIRE(staysInside(index, left, 0.0, kPi - down, hit));
        REQUIRE(hit.segment == ground);
        REQUIRE(staysInside(index, right, 1.0, down, hit));
        REQUIRE(hit.segment == ground);
    }
    // From the ground towards the box, its side.
    for (const double u : {0.5 + 0.2 / 6.0 - 1e-9, 0.53, 0.2}) {
        REQUIRE(staysInside(index, ground, u, 1e-9, hit));
        REQUIRE(hit.segment == left);
    }
}

TEST_CASE("leak: a ray that starts exactly on the wall would leak (why the origin is moved)") {
    Random random(2);
    int leaked = 0;
    for (int i = 0; i < 1000; ++i) {
        const Scene room = polygonRoom(wedge(30.0, random.in(0.0, 6.0)));
        const SegmentIndex index(room);
        const ShadedPoint at = shadedPointOn(index, 0, random.in(0.0, 1.0));
        const double theta = random.in(0.0, kPi);
        const Hit hit =
            index.closestHit({at.P, frameFromNormal(at.N).toWorld(std::cos(theta), std::sin(theta))});
        if (!hit || !hit.front) ++leaked;
    }
    CHECK(leaked > 10);
}
