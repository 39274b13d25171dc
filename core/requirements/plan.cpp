#include "core/requirements/plan.h"

#include <algorithm>
#include <array>

#include "core/estimators/params.h"

namespace halfdisk {
namespace {

constexpr std::array<Way, 7> kWays{{
    {.estimator = "closed-form"},
    {.estimator = "path", .emitters = "hit", .roulette = true},
    {.estimator = "path", .emitters = "sample", .lightSampling = true, .roulette = true},
    {.estimator = "path", .emitters = "both", .lightSampling = true, .mis = true, .roulette = true},
    {.estimator = "light", .lightPass = true, .roulette = true},
    {.estimator = "bidirectional", .lightSampling = true, .mis = true, .lightPass = true, .roulette = true},
    {.estimator = "photon-map",
     .lightSampling = true,
     .mis = true,
     .lightPass = true,
     .photonPass = true,
     .roulette = true,
     .unbiased = false},
}};

/// Side of the square that the walls fill, m.
double extentOf(const Scene& scene) {
    Vec2 least(kInfinity), most(-kInfinity);
    for (const Segment& wall : scene.segments) {
        least = glm::min(least, glm::min(wall.a, wall.b));
        most = glm::max(most, glm::max(wall.a, wall.b));
    }
    const double side = std::max(most.x - least.x, most.y - least.y);
    return side > 0.0 && std::isfinite(side) ? side : 1.0;
}

/// No value if the estimator has no such parameter.
std::optional<std::size_t> placeOf(const EstimatorInfo& info, std::string_view name) {
    for (std::size_t i = 0; i < info.params.size(); ++i)
        if (info.params[i].name == name) return i;
    return std::nullopt;
}

void set(const EstimatorInfo& info, ParamValues& values, std::string_view name, double value) {
    if (const auto place = placeOf(info, name))
        values[*place] =
            std::clamp(value, info.params[*place].least,
                       info.params[*place].choices.empty() ? info.params[*place].most
                                                           : static_cast<double>(kEmitterChoices.size()));
}

}  // namespace

std::span<const Way> allWays() {
    return kWays;
}

ParamValues paramsOf(const Way& way, const SegmentIndex& index, std::uint32_t roulette) {
    const EstimatorInfo& info = *findEstimator(way.estimator);
    ParamValues values = initialValues(info);
    set(info, values, "roulette", roulette);
    for (std::size_t i = 0; i < kEmitterChoices.size(); ++i)
        if (kEmitterChoices[i] == way.emitters) set(info, values, "emitters", static_cast<double>(i));
    if (!way.photonPass) return values;
    // A hundredth of the scene at first; the radius shrinks from pass to pass, so that the blur vanishes.
    const double extent = extentOf(index.scene());
    set(info, values, "radius", extent / 60.0);
    set(info, values, "caustic-radius", extent / 150.0);
    set(info, values, "shrink", 0.7);
    return values;
}

std::uint32_t rouletteOf(const Plan& plan) {
    const auto place = placeOf(*plan.estimator, "roulette");
    return place ? as<std::uint32_t>(plan.params[*place]) : 0;
}

std::string pathsOf(const Way& way, const Scene& scene, const Sensor& sensor) {
    return findEstimator(way.estimator)->paths(scene, bitOf(sensor));
}

bool isComplete(const Way& way, const SegmentIndex& index, const Sensor& sensor, std::uint32_t maxDepth) {
    const EstimatorInfo& info = *findEstimator(way.estimator);
    const Scene& scene = index.scene();
    if (!(info.sensors & bitOf(sensor))) return false;
    if (way.estimator == "closed-form") return maxDepth == 0 && !traitsOf(scene).specular;
    if (info.paths(scene, bitOf(sensor)) == allPaths(scene)) return true;
    // Photons are met on walls, wherever the light set out.
    const auto* probe = std::get_if<Probe>(&sensor);
    return way.photonPass && probe && probe->at.segment != kNoSegment;
}

Plan everythingOn(const SegmentIndex& index, const Sensor& sensor, std::uint32_t maxDepth,
                  std::uint32_t maxSpecular) {
    const bool joins = (findEstimator("bidirectional")->sensors & bitOf(sensor)) != 0;
    const auto isIt = [&](const Way& way) {
        return joins ? way.estimator == "bidirectional" : way.estimator == "path" && way.mis;
    };
    const Way& way = *std::find_if(kWays.begin(), kWays.end(), isIt);
    return {findEstimator(way.estimator),
            paramsOf(way, index, static_cast<std::uint32_t>(kRouletteParam.initial)),
            maxDepth,
            maxSpecular,
            IndexMethod::automatic,
            way};
}

}  // namespace halfdisk
