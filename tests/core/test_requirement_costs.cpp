// What does it cost to skip a part: is it measured, and is it told where it was not?
#include <doctest/doctest.h>

#include "core/requirements/costs.h"
#include "rooms.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

const RequirementCost& rowOf(const Costs& costs, RequirementId id, std::uint32_t to) {
    for (const RequirementCost& row : costs.rows)
        if (row.id == id && row.to == to) return row;
    throw std::logic_error("no such row");
}

}  // namespace

TEST_CASE("requirements: skipping bounces costs the light that they bring") {
    const Scene scene = litBox();
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, 8};
    const RequirementsQuestion question{.index = index, .sensor = sensor};
    const RequirementsAnswer answer = requirementsOf(question);
    const Costs costs = costsOf(question, answer, {.rays = 60'000, .repeats = 1});
    bool fewer = false;
    for (const RequirementCost& row : costs.rows) {
        CHECK(!row.words.empty());
        if (row.id != RequirementId::bounces || row.to + 1 != row.from) continue;
        fewer = true;
        REQUIRE(row.cost.change);
        CHECK(row.cost.change->share < 0.0);
        CHECK(-row.cost.change->share < 1.2 * mayMiss(answer.bounces.patches->beyond[row.to]));
    }
    CHECK(fewer);
    CHECK(costs.everything.plan.estimator->id == "bidirectional");
    REQUIRE(costs.everything.change);
    CHECK(std::abs(costs.everything.change->share) < 5.0 * costs.everything.change->standardError + 0.005);
}

TEST_CASE("requirements: where not one path meets the light that a change drops, nothing is said of it") {
    Scene scene = litBox();
    for (Material& material : scene.materials) material = Diffuse{Rgb(0.01)};
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, 8};
    // Of a hundred paths that meet a wall one goes on, eight times: to the tenth scattering comes none.
    const RequirementsQuestion question{
        .index = index,
        .sensor = sensor,
        .forced = {{RequirementId::bounces, 10}, {RequirementId::roulette, 1}}};
    const RequirementsAnswer answer = requirementsOf(question);
    const Costs costs = costsOf(question, answer, {.rays = 20'000, .repeats = 1});
    const RequirementCost& fewer = rowOf(costs, RequirementId::bounces, 9);
    CHECK_FALSE(fewer.cost.change);
    CHECK(fewer.cost.raysFactor == 1.0);
    CHECK(fewer.words.find("no path met light that this changes") == 0);
    // There is no mirror: here the same light is a proof.
    const RequirementCost& chains =
        rowOf(costs, RequirementId::specular, static_cast<std::uint32_t>(kMaxSpecularInfo.initial));
    REQUIRE(chains.cost.change);
    CHECK(chains.cost.change->share == 0.0);
    CHECK(chains.words.find("light stays the same") == 0);
}

TEST_CASE("requirements: where no run meets any light, no cost is told, and patches may know better") {
    // A corridor between screens that leave gaps above and below in turns; the lamp is at its other end.
    Scene scene = polygonRoom({{0.0, 0.0}, {10.0, 0.0}, {10.0, 0.5}, {0.0, 0.5}}, Rgb(0.5));
    for (int k = 1; k <= 8; ++k) {
        const double low = k % 2 == 1 ? 0.1 : 0.0;
        const std::uint32_t screen = addWall(scene, {1.0 * k, low}, {1.0 * k, low + 0.4}, Rgb(0.5));
        scene.segments[screen].twoSided = true;
    }
    const std::uint32_t lamp = addWall(scene, {0.3, 0.45}, {0.2, 0.45}, Rgb(0.5));
    scene.segments[lamp].emission = Rgb(5.0);
    const SegmentIndex index(scene);
    const Sensor sensor = Probe{{{9.5, 0.0}, {0.0, 1.0}, 0}};
    const RequirementsQuestion question{.index = index, .sensor = sensor};
    const RequirementsAnswer answer = requirementsOf(question);
    REQUIRE(answer.dark);
    CHECK(answer.bounces.patches);
    const Costs costs = costsOf(question, answer, {.rays = 20'000, .repeats = 1});
    for (const RequirementCost& row : costs.rows) {
        CHECK_FALSE(row.cost.change);
        CHECK_FALSE(row.cost.raysFactor);
        CHECK_FALSE(row.cost.timeFactor());
        CHECK((!row.impossible.empty() || row.words.find("no short run met any light") == 0));
    }
    CHECK_FALSE(costs.everything.change);
    // Joining paths from both ends has its longest.
    RequirementsQuestion deep = question;
    deep.forced = {{RequirementId::bounces, 100}};
    const Costs deeper = costsOf(deep, requirementsOf(deep), {.rays = 20'000, .repeats = 1});
    CHECK(deeper.everythingImpossible.find("expected a depth of at most 64") != std::string::npos);
}
