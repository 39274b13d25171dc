// Estimator `radiosity`: diffuse walls in patches, what they exchange solved once; then one place of each
// pixel gathers from all patches that it sees (final gather).
#include "core/radiosity.h"

#include "core/estimators/all.h"
#include "core/estimators/one_place.h"
#include "core/estimators/params.h"
#include "core/wall_kind.h"

namespace halfdisk {
namespace {

enum Param { kPatches, kSolver };

constexpr std::array<std::string_view, 2> kSolverChoices{"bounce", "solve"};
constexpr std::array kParams{
    ParamInfo{.name = "patches",
              .meaning = "pieces that the walls are cut into, shared by length; one at least on each lit "
                         "side and between places where walls touch",
              .least = 1,
              .most = Patches::kMost,
              .initial = 400,
              .whole = true,
              .firstLook = 48},
    ParamInfo{.name = "solver",
              .meaning = "bounce the light up to the depth asked for, or solve the equations: all bounces, "
                         "whatever the depth",
              .choices = kSolverChoices},
};

class RadiosityEstimator : public Estimator {
 public:
    RadiosityEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          receivers_(problem.sensor, problem.index),
          radiosity_(problem.index, as<std::uint32_t>(params[kPatches]),
                     params[kSolver] > 0.0 ? std::nullopt : std::optional(problem.maxDepth), problem.stop) {}

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        addPlaces(radiosity_, problem_, receivers_, pass, picture, counts);
    }

 private:
    Problem problem_;
    Receivers receivers_;
    Radiosity radiosity_;
};

std::string refusal(const Problem& problem, const ParamValues&) {
    const Scene& scene = problem.index.scene();
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i)
        if (const std::string kind = whyNotFlatDiffuse(scene, i); !kind.empty())
            return "radiosity treats diffuse walls only: " + quotedName(scene, i) + " is " + kind;
    if (const std::size_t sides = litSides(scene); sides > Patches::kMost)
        return "radiosity needs a patch on each lit side of a wall: there are " + std::to_string(sides) +
               ", expected at most " + std::to_string(Patches::kMost);
    return {};
}

}  // namespace

const EstimatorInfo kRadiosityEstimator{
    .id = "radiosity",
    .title = "Radiosity",
    .meaning = "walls in patches of constant radiance, what they exchange solved once; diffuse walls only",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit | kFieldBit,
    .params = kParams,
    .bias =
        "scattered radiance is constant over each patch; direct light is exact. The error falls with the "
        "square "
        "of a patch's length; nearer than that to a corner or to the end of a lamp, with the length itself",
    .paths = [](const Scene& scene, unsigned) { return allPaths(scene); },
    .endless = [](const ParamValues& params) { return params[kSolver] > 0.0; },
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<RadiosityEstimator>(problem, params);
    },
};

}  // namespace halfdisk
