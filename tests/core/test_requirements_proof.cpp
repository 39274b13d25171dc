// Is a plan ever worse than everything on? Ten scenes of the lessons: mean squared error at equal rays
// against a long run, in independent groups.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <chrono>

#include "core/requirements/requirements.h"
#include "lessons/scene_file.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr std::uint64_t kGroups = 16;
constexpr std::uint64_t kGroupRays = 40'000, kReferenceRays = 6'000'000;

struct Stage {
    const char* file;
    const char* wall;  ///< of a profile; null: the scene's eye
    bool simple;       ///< few parts are required
};

constexpr Stage kStages[] = {
    {"open_court", "floor", true},     {"lamp_over_floor", "floor", true},
    {"two_lamps", "floor", true},      {"near_and_far", "floor", true},
    {"small_room", "floor", true},     {"diffuse_room", nullptr, true},
    {"lamp_room", "floor", true},      {"mirror_room", nullptr, false},
    {"glossy_floors", nullptr, false}, {"glass_disk_lamp", nullptr, false},
    {"glass_disk", "floor", false},
};

/// A film of about so many rays, its first pass by number, and how many passes.
struct Run {
    Film film;
    double seconds = 0.0;
};

Run run(const SegmentIndex& index, const Sensor& sensor, const Plan& plan, std::uint64_t seed,
        std::uint64_t rays) {
    const Problem problem{index, sensor, plan.maxDepth, plan.maxSpecular, seed};
    const auto estimator = plan.estimator->make(problem, plan.params);
    Run result;
    result.film.pixels.reset(pixelCount(sensor));
    Picture picture(pixelCount(sensor));
    const auto start = std::chrono::steady_clock::now();
    while (result.film.counts.rays < rays) {
        std::fill(picture.begin(), picture.end(), Rgb(0.0));
        estimator->addPass(result.film.passes, picture, result.film.counts);
        result.film.add(picture);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

double squaredError(const Film& film, const Film& truth) {
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const Rgb off = film.pixels[i].mean - truth.pixels[i].mean;
        sum += glm::dot(off, off) / (3.0 * static_cast<double>(truth.pixels.size()));
    }
    return sum;
}

struct Errors {
    Statistics squared;  ///< of the groups, relative to the light's mean square
    double secondsPerRay = kInfinity;
};

/// One more group.
void addGroup(const SegmentIndex& index, const Sensor& sensor, const Plan& plan, std::uint64_t seed,
              const Film& truth, double light, Errors& errors) {
    const Run group = run(index, sensor, plan, seed, kGroupRays);
    errors.squared.add(Rgb(squaredError(group.film, truth) / light));
    errors.secondsPerRay =
        std::min(errors.secondsPerRay, group.seconds / static_cast<double>(group.film.counts.rays));
}

void check(const Stage& stage) {
    const Scene scene =
        expandScene(loadScene(fmt::format("{}/{}.toml", HALFDISK_SHIPPED_SCENES, stage.file)));
    const SegmentIndex index(scene);
    Sensor sensor = Profile{{}, 16};
    if (stage.wall) {
        for (std::uint32_t i = 0; i < scene.segments.size(); ++i)
            if (scene.segmentNames[i] == stage.wall) std::get<Profile>(sensor).segments.push_back(i);
        REQUIRE(!std::get<Profile>(sensor).segments.empty());
    } else {
        REQUIRE(scene.eye.has_value());
        sensor = EyeStrip{*scene.eye, 24};
    }
    const RequirementsAnswer answer = requirementsOf({.index = index, .sensor = sensor});
    CHECK(answer.loses.empty());
    const Plan everything = everythingOn(index, sensor, std::max(3u, 2 * answer.plan.maxDepth), 32);
    const Film truth = run(index, sensor, everything, 900, kReferenceRays).film;
    double light = 0.0;
    for (const Statistics& pixel : truth.pixels)
        light += glm::dot(pixel.mean, pixel.mean) / (3.0 * static_cast<double>(truth.pixels.size()));
    // With as many bounces as the plan: what these leave out is the plan's own choice, and below the
    // tolerance.
    const Plan sameDepth = everythingOn(index, sensor, answer.plan.maxDepth, 32);
    Errors plan, all, same;
    for (std::uint64_t g = 0; g < kGroups; ++g) {  // in turns, so that a busy machine slows down all of them
        addGroup(index, sensor, answer.plan, 100 + g, truth, light, plan);
        addGroup(index, sensor, everything, 300 + g, truth, light, all);
        addGroup(index, sensor, sameDepth, 500 + g, truth, light, same);
    }
    const double se = std::hypot(plan.squared.standardError().x, all.squared.standardError().x);
    MESSAGE(fmt::format(
        "{:<16} {:<14} error {:.2f} %, everything on {:.2f} % (as deep: {:.2f} %); squares {:.3g} of its, ± "
        "{:.2g}; time per ray {:.2f} of its",
        stage.file, answer.plan.estimator->id, 100.0 * std::sqrt(plan.squared.mean.x),
        100.0 * std::sqrt(all.squared.mean.x), 100.0 * std::sqrt(same.squared.mean.x),
        plan.squared.mean.x / all.squared.mean.x, 2.0 * se / all.squared.mean.x,
        plan.secondsPerRay / all.secondsPerRay));
    // Never worse: one-sided, 3.5 standard errors of 11 comparisons.
    CHECK(plan.squared.mean.x <= all.squared.mean.x + kSingle * se);
    CHECK(plan.squared.mean.x <=
          same.squared.mean.x +
              kSingle * std::hypot(plan.squared.standardError().x, same.squared.standardError().x) + 1e-4);
}

}  // namespace

TEST_CASE("plans of lesson scenes are never worse than everything on, at equal rays") {
    for (const Stage& stage : kStages) {
        CAPTURE(std::string(stage.file));
        check(stage);
    }
}
