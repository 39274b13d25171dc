// Do patches know which share of the light comes late, whatever the sensor sees of it?
#include <doctest/doctest.h>

#include "core/exact_picture.h"
#include "core/radiosity.h"
#include "core/requirements/series.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// A way that finds all light.
Plan longPlan(const RequirementsQuestion& question) {
    std::uint64_t rays = 0;
    return seriesOf(question, traitsOf(question.index.scene()), rays)->plan;
}

}  // namespace

TEST_CASE(
    "requirements: in a closed room of one albedo the spectral radius is that albedo, and so are bounces") {
    // Where all walls shine alike, each bounce brings the albedo's part of the one before: D scatterings
    // leave albedo^(D + 1) of the light.
    const Scene room = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, Rgb(0.6), Rgb(1.0));
    const SegmentIndex index(room);
    const Sensor sensor = Profile{{0}, 4};
    const auto bounces = patchBounces(index, sensor, 0.01);
    REQUIRE(bounces.has_value());
    CHECK(bounces->spectralRadius == doctest::Approx(0.6).epsilon(1e-4));
    REQUIRE(bounces->beyond.size() >= 9);
    for (std::size_t D = 0; D < 9; ++D)
        CHECK(bounces->beyond[D].share ==
              doctest::Approx(std::pow(0.6, static_cast<double>(D) + 1.0)).epsilon(1e-6));
    CHECK(bounces->beyond.size() == 10);  // 0.6^10 = 0.0060 is the first one below 0.01
}

TEST_CASE("requirements: a lamp that lies on the ceiling leaves the spectral radius what it is") {
    // It hides its part of the ceiling, and takes its place: the room stays closed, of one albedo.
    Scene room = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, Rgb(0.9), Rgb(0.0));
    room.segments.insert(room.segments.begin(), {{0.6, 1.0}, {0.4, 1.0}, 0, Rgb(1.0), false});
    room.segmentNames.insert(room.segmentNames.begin(), "lamp");
    const SegmentIndex index(room);
    CHECK(patchBounces(index, Profile{{1}, 4}, 0.01)->spectralRadius == doctest::Approx(0.9).epsilon(1e-4));
}

TEST_CASE("requirements: what no depth can carry is told, not hidden") {
    const auto beyond = [](double albedo) {
        const Scene room =
            polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {0.0, 1.0}}, Rgb(albedo), Rgb(1.0));
        const SegmentIndex index(room);
        return patchBounces(index, Profile{{0}, 4}, 0.01)->beyond;
    };
    REQUIRE(beyond(0.999).size() == 1001);
    CHECK(beyond(0.999).back().share == doctest::Approx(std::pow(0.999, 1001.0)).epsilon(0.01));
    CHECK(beyond(0.997).size() == 1001);
    CHECK(beyond(0.997).back().share == doctest::Approx(std::pow(0.997, 1001.0)).epsilon(0.01));
    CHECK(beyond(1.0).back().share > 0.99);  // light that never ends
}

TEST_CASE("requirements: a bounce that brings nothing is not the last one") {
    // Of what the floor scatters, nothing meets the floor; of what the ceiling makes of it, much does.
    Scene scene;
    addWall(scene, {0.0, 0.0}, {3.0, 0.0}, Rgb(0.6));
    addWall(scene, {3.0, 1.5}, {0.0, 1.5}, Rgb(0.6));
    addWall(scene, {1.6, 1.3}, {1.4, 1.3}, Rgb(0.6), Rgb(2.0));
    const SegmentIndex index(scene);
    const auto bounces = patchBounces(index, Profile{{0}, 4}, 0.01);
    REQUIRE(bounces.has_value());
    REQUIRE(bounces->beyond.size() > 2);
    CHECK(bounces->beyond[0].share > 0.05);
    CHECK(bounces->beyond[1].share > 0.05);
}

// Lamps that are seen, sun, a bulb, colours: whatever a sensor makes of light, patches and paths must agree
// about which share of it comes late.
TEST_CASE("requirements: bounces by patches agree with paths, for every sensor") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Vec2 inside(0.3, 0.6), ahead = glm::normalize(Vec2(0.4, 1.0));
    const std::array sensors{Sensor(Profile{{0}, 8}),
                             Sensor(Probe{{index.pointOn(0, 0.3), index.normal(0), 0}}),
                             Sensor(Probe{{inside, ahead}}),
                             Sensor(Field{inside - Vec2(0.2), inside + Vec2(0.2), 3, 3}),
                             Sensor(EyeStrip{{inside, ahead, 1.5}, 8}),
                             Sensor(Look{inside, {0.0, -1.0}})};
    constexpr std::uint32_t kDeepest = 12;
    for (const Sensor& sensor : sensors) {
        CAPTURE(kSensorNames[sensor.index()]);
        const auto told = patchBounces(index, sensor, 1e-4);
        REQUIRE(told);
        REQUIRE(told->beyond.size() > 4);
        Plan plan = longPlan({.index = index, .sensor = sensor});
        const auto upTo = [&](std::uint32_t depth) {
            plan.maxDepth = depth;
            return pilot({.index = index, .sensor = sensor, .seed = 3}, plan,
                         {.rays = 0, .leastPasses = 4000});
        };
        const Pilot all = upTo(kDeepest);
        CHECK(std::abs(told->light - all.mean) < 4.0 * std::hypot(all.meanError, told->lightError));
        bool rejected = false;
        for (const std::uint32_t depth : {0u, 1u, 2u, 3u}) {
            CAPTURE(depth);
            const BeyondDepth found = shareBeyond(depth, all, upTo(depth));
            const double error = std::hypot(found.standardError, told->beyond[depth].standardError);
            CHECK(std::abs(told->beyond[depth].share - found.share) < 4.0 * error);
            // One bounce more or less is told from it.
            rejected = rejected || std::abs(told->beyond[depth + 1].share - found.share) > 6.0 * error;
        }
        CHECK(rejected);
    }
}

namespace {

/// Two matt rooms, joined by a slit; a bulb or a bright lamp in the one behind it, a dim lamp in the other.
Scene roomsWithSlit(double slit, bool bulb) {
    Scene scene = polygonRoom({{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.5}, {0.0, 1.5}}, Rgb(0.8));
    addWall(scene, {2.0, 0.0}, {2.0, 0.7}, Rgb(0.8), Rgb(0.0), true);
    addWall(scene, {2.0, 0.7 + slit}, {2.0, 1.5}, Rgb(0.8), Rgb(0.0), true);
    if (bulb) {
        scene.lights.emplace_back(PointLight{{3.0, 0.3}, Rgb(1.0)});
    } else {
        addWall(scene, {3.9, 1.4}, {3.9, 1.3}, Rgb(0.8), Rgb(3000.0), true);
        addWall(scene, {1.1, 1.49}, {0.9, 1.49}, Rgb(0.8), Rgb(0.5));
    }
    return scene;
}

const EyeStrip kFrontEye{{{0.3, 0.4}, glm::normalize(Vec2(1.0, 0.3)), kPi / 2.0}, 16};

}  // namespace

TEST_CASE("requirements: patches see what an eye sees through a slit") {
    const Scene scene = roomsWithSlit(2e-3, true);
    const SegmentIndex index(scene);
    const auto told = patchBounces(index, kFrontEye, 0.01);
    REQUIRE(told);
    const Reference exact(index, 1);
    const std::vector<Rgb> seen = exactPicture(exact, kFrontEye, 0);
    double light = 0.0;
    for (const Rgb& pixel : seen) light += pixel.x / static_cast<double>(seen.size());
    const BeyondDepth& beyond = told->beyond.front();
    CHECK(light > 1e-4);
    CHECK(std::abs((1.0 - beyond.share) * told->light - light) < 3.0 * beyond.standardError * told->light);
}

TEST_CASE("requirements: a way that has not met what patches know of is not chosen for its little noise") {
    const Scene scene = roomsWithSlit(2e-4, false);
    const SegmentIndex index(scene);
    const Sensor sensor = kFrontEye;
    for (const std::uint64_t seed : {1u, 2u}) {
        const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor, .seed = seed});
        const auto rare = rareLight(answer);
        REQUIRE(rare);
        CHECK(rare->share > 0.1);
        const double known = answer.bounces.patches->light;
        std::size_t lacking = 0;
        for (const Candidate& candidate : answer.candidates)
            if (candidate.pilot.mean + 4.0 * candidate.pilot.meanError < 0.9 * known) {
                ++lacking;
                CHECK(candidate.lacks);
            }
        CHECK(lacking > 0);
    }
}

namespace {

/// Shares by patches against radiosity with thousands of them, cut evenly, at a place on a wall; `allowed`:
/// share that the latter may be off.
void checkAgainstRadiosity(const Scene& scene, std::uint32_t wall, double u, double mostError,
                           double allowed) {
    const SegmentIndex index(scene);
    const ShadedPoint place{index.pointOn(wall, u), index.normal(wall), wall};
    const auto told = patchBounces(index, Probe{place}, 0.01);
    REQUIRE(told);
    const auto upTo = [&](std::optional<std::uint32_t> depth) {
        Counts counts;
        return Radiosity(index, 2000, depth).irradiance(place, counts).x;
    };
    const double all = upTo(std::nullopt);
    CHECK(std::abs(told->light - all) < 3.0 * told->lightError + allowed * all);
    for (const std::uint32_t depth : {1u, 2u, 3u}) {
        CAPTURE(depth);
        const BeyondDepth& beyond = told->beyond[depth];
        CHECK(beyond.standardError < mostError);
        CHECK(std::abs(beyond.share - (1.0 - upTo(depth) / all)) < 3.0 * beyond.standardError + allowed);
    }
}

}  // namespace

TEST_CASE("requirements: a beam inside a patch is not smeared over it") {
    // The beam of the bulb on the front room's walls is 1 cm wide, patches are 10 cm long.
    checkAgainstRadiosity(roomsWithSlit(5e-3, true), 0, 0.15, 0.01, 0.002);
}

TEST_CASE("requirements: patches own up to what two divisions agree about by chance") {
    // A bulb in the middle of a small box: halves of its walls are as bright as the whole, but through the
    // slit the front room sees their dark corner.
    Scene scene = polygonRoom({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.5}, {0.0, 1.5}}, Rgb(0.8));
    for (const auto& [a, b] : {std::pair(Vec2(0.5, 0.5), Vec2(0.6, 0.5)),
                               {{0.6, 0.5}, {0.6, 0.6}},
                               {{0.6, 0.6}, {0.5, 0.6}},
                               {{0.5, 0.6}, {0.5, 0.51}}})
        addWall(scene, a, b, Rgb(0.5), Rgb(0.0), true);
    scene.lights.emplace_back(PointLight{{0.55, 0.55}, Rgb(3.0)});
    checkAgainstRadiosity(scene, 3, 0.3, 0.03, 0.002);
}
