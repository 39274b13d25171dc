// Are chains of mirrors and glass followed as far as they bring light, where geometry has no bound?
#include <doctest/doctest.h>

#include "core/render.h"
#include "core/requirements/requirements.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// A lamp and a matt plate in a box of mirrors that lose nothing; light goes round until it meets the plate.
/// With a bead of glass it does so for long. The plate is wall 0.
Scene mirrorBox(bool bead) {
    Scene scene;
    addWall(scene, {0.2, 0.1}, {0.5, 0.1});
    scene.materials.back() = Diffuse{Rgb(0.8)};
    scene.segments[addWall(scene, {1.05, 1.9}, {0.95, 1.9})].emission = Rgb(1.0);
    const auto add = [&](const std::vector<Vec2>& corners, const Material& material) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            addWall(scene, corners[i], corners[(i + 1) % corners.size()]);
            scene.materials.back() = material;
        }
    };
    add({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}, Mirror{Rgb(1.0)});
    std::vector<Vec2> around;
    constexpr int kFacets = 16;
    for (int k = 0; k < kFacets; ++k) {
        const double angle = -2.0 * kPi * k / kFacets;
        around.push_back(Vec2(0.3, 1.7) + 0.05 * Vec2(std::cos(angle), std::sin(angle)));
    }
    if (bead) add(around, Dielectric{1.5, Rgb(0.0)});
    return scene;
}

constexpr std::uint64_t kPasses = 20'000;

Statistics lightBy(const Plan& plan, const SegmentIndex& index, const Sensor& sensor) {
    const Problem problem{index, sensor, plan.maxDepth, plan.maxSpecular, 77};
    const auto estimator = plan.estimator->make(problem, plan.params);
    RenderOptions options;
    options.passes = kPasses;
    return render(*estimator, sensor, options).pixels[0];
}

/// By how many standard errors, and as which share of the truth, the plan brings less.
struct Lack {
    double share = 0.0, sure = 0.0;
};

Lack lackOf(const Plan& plan, const Statistics& truth, const SegmentIndex& index, const Sensor& sensor) {
    const Statistics found = lightBy(plan, index, sensor);
    const double less = truth.mean.x - found.mean.x;
    return {less / truth.mean.x, less / std::hypot(truth.standardError().x, found.standardError().x)};
}

}  // namespace

TEST_CASE("requirements: chains in glass between mirrors are followed as far as they bring light") {
    const Sensor sensor = Profile{{0}, 1};
    for (const bool bead : {false, true}) {
        CAPTURE(bead);
        const Scene scene = mirrorBox(bead);
        const SegmentIndex index(scene);
        const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
        CHECK(answer.plan.maxSpecular > 100);
        const Requirement& told = answer.of(RequirementId::specular);
        CHECK(told.ground == Ground::measurement);
        CHECK(told.number == answer.plan.maxSpecular);
        REQUIRE(!answer.specular.measured.empty());
        CHECK(answer.specular.measured.front().share > 0.05);

        Plan deepest = answer.plan;
        deepest.maxSpecular = static_cast<std::uint32_t>(kMaxSpecularInfo.most);
        const Statistics truth = lightBy(deepest, index, sensor);
        CHECK(lackOf(answer.plan, truth, index, sensor).share < 2.0 * kInitialTolerance);
        // The usual number is told from the truth.
        Plan usual = answer.plan;
        usual.maxSpecular = static_cast<std::uint32_t>(kMaxSpecularInfo.initial);
        const Lack robbed = lackOf(usual, truth, index, sensor);
        CHECK(robbed.share > 0.05);
        CHECK(robbed.sure > 4.0);
    }
}

TEST_CASE("requirements: where no path tried is longer, the usual number of glass events does") {
    Scene scene = litBox();
    std::vector<Vec2> corners{{-0.2, 0.4}, {-0.2, 0.6}, {0.2, 0.6}, {0.2, 0.4}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        addWall(scene, corners[i], corners[(i + 1) % corners.size()]);
        scene.materials.back() = Dielectric{1.1, Rgb(50.0)};  // hardly anything comes back from inside
    }
    const SegmentIndex index(scene);
    const Sensor sensor = Profile{{0}, 4};
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    CHECK(answer.plan.maxSpecular == kMaxSpecularInfo.initial);
    CHECK(answer.specular.measured.size() <= 1);
}
