// Does each sensor weigh radiance as it says, and does light that arrives find its pixel?
#include <doctest/doctest.h>

#include "core/field_cells.h"
#include "core/sensor.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Segment wall(Vec2 a, Vec2 b, std::uint32_t material = 0) {
    Segment segment;
    segment.a = a;
    segment.b = b;
    segment.material = material;
    return segment;
}

Scene walls() {
    Scene scene;
    scene.materials = {Diffuse{Rgb(0.5)}, Dielectric{1.5, Rgb(1.0, 0.0, 2.0)}};
    scene.materialNames = {"grey", "glass"};
    scene.segments = {wall({0, 0}, {2, 0}),    wall({2, 0}, {2, 1}),    wall({3, 0}, {3, 1}, 1),
                      wall({3, 1}, {4, 1}, 1), wall({4, 1}, {4, 0}, 1), wall({4, 0}, {3, 0}, 1)};
    for (std::size_t i = 0; i < scene.segments.size(); ++i)
        scene.segmentNames.push_back("wall" + std::to_string(i));
    return scene;
}

}  // namespace

TEST_CASE("sensor: each pixel of an eye weighs directions so that even light gives its radiance") {
    const Scene scene = walls();
    const SegmentIndex index(scene);
    const Eye eye{{0.5, 0.5}, glm::normalize(Vec2(1.0, 0.4)), 1.9};
    const Sensor sensor = EyeStrip{eye, 7};
    for (std::uint32_t pixel = 0; pixel < 7; ++pixel) {
        const Receiver receiver = Receivers(sensor, index).draw(pixel, 0.5, 0.5);
        // The midpoint rule: the weight jumps at the pixel's edges.
        constexpr int kSteps = 200'000;
        double sum = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const double angle = 2 * kPi * (i + 0.5) / kSteps;
            const Response response = responseTo(receiver, {std::cos(angle), std::sin(angle)});
            if (response.pixel == pixel) sum += response.weight * 2 * kPi / kSteps;
        }
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-3));
        for (const double u : {0.001, 0.5, 0.999})
            CHECK(responseTo(receiver, sightFrom(receiver, index, u).ray.direction).pixel == pixel);
    }
    // Pixel 0 is the leftmost.
    const Vec2 first = sightFrom(Receivers(sensor, index).draw(0, 0.5, 0.5), index, 0.5).ray.direction;
    CHECK(cross(eye.direction, first) > 0.0);
}

TEST_CASE(
    "sensor: a profile runs along its walls in their order, and what arrives falls into the bin of its "
    "place") {
    const Scene scene = walls();
    const SegmentIndex index(scene);
    const Profile profile{{1, 0}, 9};  // 1 m, then 2 m
    const Sensor sensor = profile;
    const ProfileBins bins(profile, index);
    const Receivers receivers(sensor, index);
    CHECK(bins.binLength() == doctest::Approx(1.0 / 3.0));
    CHECK_FALSE(bins.at(2, 0.5));
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const auto bin = static_cast<std::uint32_t>(random.integer(0, 8));
        const Receiver receiver = receivers.draw(bin, random.in(0.0, 1.0), 0.5);
        const Segment& on = scene.segments[receiver.at.segment];
        const double u = glm::length(receiver.at.P - on.a) / glm::length(on.b - on.a);
        REQUIRE(bins.at(receiver.at.segment, u)->bin == bin);
        REQUIRE(receiver.at.segment == (bin < 3 ? 1u : 0u));
    }
}

TEST_CASE("sensor: flights through a field are cut at its cells, and no length is lost") {
    const Field field{{-1.0, 0.5}, {2.0, 2.0}, 7, 5};
    const Vec2 cell = (field.max - field.min) / Vec2(7.0, 5.0);
    Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        Ray ray{random.pointIn(-2.0, 3.0), random.direction()};
        // Some along the axes, some from a cell's corner.
        if (i % 7 == 0) ray.direction = i % 2 ? Vec2(1.0, 0.0) : Vec2(0.0, -1.0);
        if (i % 11 == 0)
            ray.origin = field.min + cell * Vec2(double(random.integer(0, 7)), double(random.integer(0, 5)));
        const double distance = i % 5 == 0 ? kInfinity : random.in(0.0, 4.0);
        double sum = 0.0, before = -1.0;
        forCells(field, ray, distance, [&](std::uint32_t pixel, double from, double to) {
            REQUIRE(pixel < 35);
            REQUIRE(to > from);
            if (before >= 0.0) REQUIRE(from == doctest::Approx(before).epsilon(1e-9));
            before = to;
            const Vec2 middle = ray.origin + ray.direction * ((from + to) / 2);
            const Vec2 place = (middle - field.min) / cell;
            const double column = pixel % 7, row = 4.0 - pixel / 7;
            REQUIRE(place.x > column - 1e-6);
            REQUIRE(place.x < column + 1 + 1e-6);
            REQUIRE(place.y > row - 1e-6);
            REQUIRE(place.y < row + 1 + 1e-6);
            sum += to - from;
        });
        // The flight's part within the box, by clipping.
        double enter = 0.0, exit = distance;
        for (int axis = 0; axis < 2; ++axis) {
            if (ray.direction[axis] == 0.0) {
                if (ray.origin[axis] < field.min[axis] || ray.origin[axis] >= field.max[axis]) exit = -1.0;
                continue;
            }
            const double a = (field.min[axis] - ray.origin[axis]) / ray.direction[axis],
                         b = (field.max[axis] - ray.origin[axis]) / ray.direction[axis];
            enter = std::max(enter, std::min(a, b));
            exit = std::min(exit, std::max(a, b));
        }
        REQUIRE(sum == doctest::Approx(std::max(0.0, exit - enter)).epsilon(1e-9));
    }
}

TEST_CASE("sensor: which glass a point lies in, and what it lets through") {
    const Scene scene = walls();
    const SegmentIndex index(scene);
    CHECK(mediumAt(index, {3.5, 0.5}) == 1);
    CHECK(mediumAt(index, {2.5, 0.5}) == kNoMedium);
    CHECK(mediumAt(index, {4.5, 0.5}) == kNoMedium);
    CHECK(mediumAt(index, {3.5, 1.5}) == kNoMedium);
    CHECK(transmittance(index, 1, 0.5).x == doctest::Approx(std::exp(-0.5)));
    CHECK(transmittance(index, 1, 0.5).y == 1.0);
    CHECK(transmittance(index, kNoMedium, 5.0) == Rgb(1.0));
}

TEST_CASE("sensor: faults are told") {
    const Scene scene = walls();
    const SegmentIndex index(scene);
    CHECK(faultOf(Profile{{}, 4}, index) == "the profile names no wall");
    CHECK(faultOf(Profile{{0, 0}, 4}, index) == "the profile names a wall twice");
    CHECK(faultOf(Profile{{99}, 4}, index) == "the profile names a wall that does not exist");
    CHECK(faultOf(Profile{{0}, 0}, index) == "the sensor has no pixels");
    CHECK(faultOf(Field{{0, 0}, {0, 1}, 4, 4}, index) == "the field has no area");
    CHECK(faultOf(EyeStrip{{{0, 0}, {1, 0}, 4.0}, 4}, index) ==
          "the eye's field of view is not between 0 and 180 degrees");
    CHECK(faultOf(Profile{{0, 1}, 4}, index).empty());
}

TEST_CASE("sensor: a probe right where another wall stands on its own is refused, for it has two answers") {
    Scene scene;
    addWall(scene, {0.0, 0.0}, {2.0, 0.0});
    addWall(scene, {2.0, 0.0}, {2.0, 1.0});
    addWall(scene, {1.0, 1.0}, {1.0, 0.0});   // stands on the floor
    addWall(scene, {0.5, -1.0}, {0.5, 0.0});  // comes up to it from below
    addWall(scene, {1.5, -1.0}, {1.5, 1.0});  // goes through
    const SegmentIndex index(scene);
    const auto faultAt = [&](double x) { return faultOf(Probe{{{x, 0.0}, {0.0, 1.0}, 0}}, index); };
    CHECK(faultAt(1.0).find("\"wall 2\" stands where the probe is") == 0);
    CHECK(faultAt(1.5).find("\"wall 4\" stands where the probe is") == 0);
    for (const double x : {0.0, 0.5, 1.0 + 1e-6, 1.5 - 1e-6, 1.8, 2.0}) CHECK(faultAt(x).empty());
    CHECK(faultOf(Probe{{{1.0, 0.0}, {0.0, 1.0}}}, index).empty());  // on no wall
}
