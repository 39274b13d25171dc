// Estimator `photon-map`: light is sent out first and its photons are kept where they arrive; what is seen is
// then looked up in them.
//
// Jensen 1996, "Global illumination using photon maps", with a caustic map of its own, final gathering, and
// the iterated variant that shrinks the radius from pass to pass (Knaus & Zwicker 2011, "Progressive photon
// mapping: a probabilistic approach"), all with a kernel of length instead of area.
#include "core/estimators/all.h"
#include "core/estimators/params.h"
#include "core/estimators/photon_gather.h"
#include "core/path_recorder.h"

namespace halfdisk {
namespace {

enum Param { kPhotons, kRadius, kGather, kCaustics, kCausticRadius, kShrink, kSpread, kRoulette };

constexpr double kMostRadius = 1e6, kLeastRadius = 1e-6;
constexpr double kMostStored = 2e7;  // photons of a pass: about 2 GB

constexpr std::array kParams{
    ParamInfo{.name = "photons",
              .meaning = "light paths of one pass",
              .least = 1,
              .most = 1e7,
              .initial = 20000,
              .whole = true},
    ParamInfo{.name = "radius",
              .meaning = "half of the kernel's length, along the wall",
              .unit = "m",
              .least = kLeastRadius,
              .most = kMostRadius,
              .initial = 0.05},
    ParamInfo{.name = "gather",
              .meaning =
                  "rays from the first scattering wall that is seen, to look the photons up where they "
                  "arrive; 0: look up at that wall itself",
              .most = 10000,
              .initial = 8,
              .whole = true},
    ParamInfo{.name = "caustics",
              .meaning = "whether light that only mirrors and glass sent has a radius of its own",
              .initial = 1,
              .choices = kOffOn},
    ParamInfo{.name = "caustic-radius",
              .meaning = "its radius",
              .unit = "m",
              .least = kLeastRadius,
              .most = kMostRadius,
              .initial = 0.02},
    ParamInfo{.name = "shrink",
              .meaning =
                  "share of photons that each pass adds to those kept: below 1 the radius shrinks from "
                  "pass to pass, so that the bias vanishes; 1: it stays",
              .least = 0.01,
              .initial = 1.0},
    kSpreadParam,
    kRouletteParam,
};

PhotonSettings settingsOf(const ParamValues& params) {
    return {.paths = as<std::uint32_t>(params[kPhotons]),
            .radius = params[kRadius],
            .causticRadius = params[params[kCaustics] > 0.0 ? kCausticRadius : kRadius],
            .shrink = params[kShrink],
            .rays = as<std::uint32_t>(params[kGather]),
            .spread = as<Spread>(params[kSpread]),
            .roulette = as<std::uint32_t>(params[kRoulette])};
}

class PhotonMapEstimator : public Estimator {
 public:
    PhotonMapEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          receivers_(problem.sensor, problem.index),
          paths_(params[kPhotons]),
          lights_(problem.index, placesOf(problem.sensor)),
          sender_(problem_, lights_, settingsOf(params)) {}

    double workPerPass() const override { return paths_; }

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        const Rng ofPass(problem_.seed, pass);
        const PhotonMaps maps = sender_.send(ofPass, pass, counts);
        const PhotonGather light(problem_, lights_, sender_, maps);
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            throwIfStopped(problem_.stop, pixel);
            if (problem_.record && !problem_.record->wants(pixel)) continue;
            const Rng rng = ofPass.child(pixel);
            const Receiver receiver =
                receivers_.draw(pixel, rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
            ++counts.paths;
            if (receiver.covered) continue;
            addTo(
                picture, pixel,
                gathers(receiver) ? light.received(receiver, rng, counts) : light.seen(receiver, rng, counts),
                counts);
        }
    }

 private:
    Problem problem_;
    Receivers receivers_;
    double paths_;  // of light, in one pass
    LightTable lights_;
    PhotonSender sender_;
};

// Off the walls no photon can be met, and a ray meets neither a point light nor a directional one.
std::string paths(const Scene& scene, unsigned sensor) {
    const SceneTraits traits = traitsOf(scene);
    const bool all = !traits.delta || !traits.specular || !(sensor & (kProbeBit | kFieldBit));
    if (all) return allPaths(scene);
    const std::string fromDelta = traits.scattering ? "L(S|D)*DE or LE" : "LE";
    const std::string off = traits.area ? "L(S|D)*E from lamps and the environment, " + fromDelta +
                                              " from point and directional "
                                              "lights"
                                        : fromDelta;
    return sensor == kFieldBit ? off : allPaths(scene) + " on a wall; elsewhere " + off;
}

std::string refusal(const Problem& problem, const ParamValues& params) {
    if (params[kPhotons] * (problem.maxDepth + 1.0) <= kMostStored) return {};
    return "photon-map would store up to photons * (depth + 1) = more than 2 * 10^7 photons in one pass, "
           "about 2 GB; lower photons and take more passes, which give the same";
}

}  // namespace

const EstimatorInfo kPhotonMapEstimator{
    .id = "photon-map",
    .title = "Photon mapping",
    .meaning = "light is sent out first; what is seen is looked up in the photons that arrived near by",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit | kFieldBit,
    .params = kParams,
    .bias =
        "blurs light along walls by the radius: off by radius^2 E''/6 where light changes smoothly, more "
        "at its edges and at corners; vanishes as the radius shrinks, while variance grows as "
        "1/(photons radius)",
    .recorded = true,
    .paths = paths,
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<PhotonMapEstimator>(problem, params);
    },
};

}  // namespace halfdisk
