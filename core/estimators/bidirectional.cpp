// Estimator `bidirectional`: a path from the sensor and a path from a light, joined in every way.
//
// Lafortune & Willems 1993, "Bi-directional path tracing"; Veach 1997, chapter 10. Strategy (s, t) takes s
// vertices from the light and t from the sensor; each finds the same light in its own way, and the weights of
// path_densities.h let the best speak most.
#include "core/estimators/all.h"
#include "core/estimators/bidirectional_join.h"
#include "core/estimators/params.h"
#include "core/path_recorder.h"

namespace halfdisk {
namespace {

enum Param { kLightVertices, kSensorVertices, kWeights, kHeuristic, kRoulette };

constexpr double kMostVertices = 64;
constexpr std::array kParams{
    ParamInfo{.name = "s",
              .meaning = "only strategies of so many vertices from the light; -1: all",
              .least = -1,
              .most = kMostVertices,
              .initial = -1,
              .whole = true},
    ParamInfo{.name = "t",
              .meaning = "only strategies of so many vertices from the sensor; -1: all",
              .least = -1,
              .most = kMostVertices,
              .initial = -1,
              .whole = true},
    ParamInfo{.name = "weights",
              .meaning = "weigh the strategies; off: each counts whole, for its own picture",
              .initial = 1,
              .choices = kOffOn},
    kHeuristicParam,
    ParamInfo{.name = kRouletteParam.name, .meaning = kRouletteParam.meaning, .most = 1000, .whole = true},
};

class BidirectionalEstimator : public Estimator {
 public:
    BidirectionalEstimator(const Problem& problem, const ParamValues& params)
        : setup_(joinSetupOf(problem, params)) {}

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        joinPaths(setup_, pass, picture, counts);
    }

 private:
    JoinSetup setup_;
};

// A path from a light that can't be met must be joined somewhere: where two of L, D and E stand side by side.
std::string paths(const Scene& scene, unsigned sensor) {
    const SceneTraits traits = traitsOf(scene);
    if (!traits.delta || !traits.specular || sensor == kProfileBit) return allPaths(scene);
    const std::string joined =
        sensor == kLookBit ? "LD(S|D)*E or L(S|D)*DD(S|D)*E" : "LE, LD(S|D)*E, L(S|D)*DE or L(S|D)*DD(S|D)*E";
    return traits.area
               ? "L(S|D)*E from lamps and the environment, " + joined + " from point and directional lights"
               : joined;
}

// Every vertex of one path is joined with every vertex of the other.
std::string refusal(const Problem& problem, const ParamValues&) {
    constexpr std::uint32_t kMostDepth = 64;
    if (problem.maxDepth <= kMostDepth) return {};
    return "bidirectional joins every vertex with every other: expected a depth of at most 64, or the "
           "estimator path";
}

}  // namespace

JoinSetup joinSetupOf(const Problem& problem, const ParamValues& params) {
    JoinSetup setup{
        .problem = problem,
        .receivers = Receivers(problem.sensor, problem.index),
        .lights = LightTable(problem.index, placesOf(problem.sensor)),
        .bins = {},
        .onlyS = static_cast<int>(params[kLightVertices]),
        .onlyT = static_cast<int>(params[kSensorVertices]),
        .weighs = params[kWeights] > 0.0,
        .heuristic = as<Heuristic>(params[kHeuristic]),
        .counts = {},
        .limits = {mostScatterings(problem), problem.maxSpecular, as<std::uint32_t>(params[kRoulette])}};
    const double paths = pixelCount(problem.sensor);
    if (std::holds_alternative<EyeStrip>(problem.sensor)) setup.counts.lightConnected = paths;
    // Of one pixel alone only its own pair is followed.
    if (problem.record && problem.record->wantsOnePixel()) setup.counts.lightConnected = 1.0;
    if (std::holds_alternative<Look>(problem.sensor)) setup.counts.lightConnected = 0.0;
    if (const auto* profile = std::get_if<Profile>(&problem.sensor)) {
        setup.bins.emplace(*profile, problem.index);
        setup.counts.lightAlone = paths;
    }
    return setup;
}

const EstimatorInfo kBidirectionalEstimator{
    .id = "bidirectional",
    .title = "Bidirectional path tracing",
    .meaning = "a path from the sensor and one from a light, joined in every way and weighed",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit,
    .params = kParams,
    .bias = {},
    .recorded = true,
    .paths = paths,
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<BidirectionalEstimator>(problem, params);
    },
};

}  // namespace halfdisk
