// Estimator `virtual-lights`: wherever light arrives a small lamp is put, and these lamps light what is seen.
//
// Virtual point lights: Keller 1997, "Instant radiosity". A pass's lamps are the same for all of its pixels.
#include "core/blocks.h"
#include "core/estimators/all.h"
#include "core/estimators/gather.h"
#include "core/estimators/light_paths.h"
#include "core/estimators/look.h"
#include "core/estimators/params.h"

namespace halfdisk {
namespace {

enum Param { kPaths, kClamp, kSpread, kRoulette };

constexpr double kMostStored = 5e6;  // about 1 GB

constexpr std::array kParams{
    ParamInfo{.name = "paths",
              .meaning = "light paths of one pass; each leaves a lamp on every scattering wall it meets",
              .least = 1,
              .most = 1e6,
              .initial = 64,
              .whole = true,
              .firstLook = 8},
    ParamInfo{.name = "clamp",
              .meaning = "a lamp nearer than this shines as if it were so far away; 0: as it is, with bright "
                         "spots in corners, whose variance has no bound",
              .unit = "m",
              .most = 1e6},
    kSpreadParam,
    kRouletteParam,
};

// A wall's point and the power (W) that arrives there from at.from.
struct VirtualLight {
    SurfacePoint at;
    Rgb power;
};

struct StoreVisitor : WalkVisitor {
    Blocks<VirtualLight> lamps{};

    bool arrive(const Arrival& here) {
        if (!isSpecular(*here.at.material)) lamps.push_back({here.at, here.throughput});
        return true;
    }
};

class VirtualLightsEstimator : public Estimator {
 public:
    VirtualLightsEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          receivers_(problem.sensor, problem.index),
          lights_(problem.index, placesOf(problem.sensor)),
          paths_(as<std::uint32_t>(params[kPaths])),
          clamp_(params[kClamp]),
          spread_(as<Spread>(params[kSpread])),
          // A lamp scatters once more, and so does the wall that an eye sees.
          limits_{problem.maxDepth - std::min(1u, problem.maxDepth), problem.maxSpecular,
                  as<std::uint32_t>(params[kRoulette])} {}

    double workPerPass() const override { return static_cast<double>(paths_) * pixelCount(problem_.sensor); }

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        const Rng ofPass(problem_.seed, pass);
        StoreVisitor store;
        if (problem_.maxDepth > 0)
            sendLight(lights_, paths_, spread_, limits_, ofPass, counts, store, nullptr, problem_.stop);
        const std::vector<VirtualLight> lamps = std::move(store.lamps).joined(problem_.stop);
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            throwIfStopped(problem_.stop, pixel);
            const Rng rng = ofPass.child(pixel);
            const Receiver receiver =
                receivers_.draw(pixel, rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
            ++counts.paths;
            if (receiver.covered) continue;
            const Rgb value = gathers(receiver) ? received(lamps, receiver, rng, counts)
                                                : seen(lamps, receiver, rng, counts);
            addTo(picture, pixel, value, counts);
        }
    }

 private:
    // Of one lamp, at a receiver: irradiance (or fluence), W/m.
    Rgb fromLamp(const VirtualLight& lamp, const Connection& way) const {
        if (way.passed == Rgb(0.0)) return Rgb(0.0);
        const double geometry = glm::dot(lamp.at.N, way.toReceiver) / std::max(way.distance, clamp_);
        return lamp.power * evalSurface(lamp.at, lamp.at.from, way.toReceiver) * way.passed *
               (geometry * way.response.weight);
    }

    Rgb received(const std::vector<VirtualLight>& lamps, const Receiver& receiver, const Rng& rng,
                 Counts& counts) const {
        Rgb sum = directLight(lights_, receiver, rng, counts);
        std::uint64_t step = 0;
        for (const VirtualLight& lamp : lamps) {
            throwIfStopped(problem_.stop, step++);
            sum += fromLamp(lamp, connect(problem_.index, lamp.at, receiver, counts));
        }
        return sum;
    }

    // Radiance along a ray from an eye: the lamps light the wall that it sees.
    Rgb seen(const std::vector<VirtualLight>& lamps, const Receiver& receiver, const Rng& rng,
             Counts& counts) const {
        const auto outgoing = [&](const Arrival& here) {
            const Receiver wall{.at = {here.at.P, here.at.N, here.at.segment}};
            Rgb sum = directLight(lights_, here, rng, counts);
            std::uint64_t step = 0;
            for (const VirtualLight& lamp : lamps) {
                throwIfStopped(problem_.stop, step++);
                const Connection way = connect(problem_.index, lamp.at, wall, counts);
                if (way.passed != Rgb(0.0))
                    sum += fromLamp(lamp, way) * evalSurface(here.at, -way.toReceiver, here.at.from);
            }
            return sum;
        };
        const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
        const Looking eye{.lights = lights_, .mostSpecular = problem_.maxSpecular};
        return look(eye, sight.ray, Rgb(sight.weight), rng, counts, outgoing);
    }

    Problem problem_;
    Receivers receivers_;
    LightTable lights_;
    std::uint32_t paths_;
    double clamp_;
    Spread spread_;
    WalkLimits limits_;
};

// Lamps light only what they see straight: a mirror or glass may stand before the last lamp, and before the
// eye, not between.
std::string paths(const Scene& scene, unsigned sensor) {
    const SceneTraits traits = traitsOf(scene);
    if (!traits.specular) return allPaths(scene);
    const bool radiance = sensor & (kEyeBit | kLookBit);
    if (!traits.scattering) return radiance ? "LS*E" : "LE";
    return radiance ? "LS*E, LDS*E or L(S|D)*DDS*E" : "LE or L(S|D)*DE";
}

std::string refusal(const Problem& problem, const ParamValues& params) {
    if (params[kPaths] * std::max(1.0, static_cast<double>(problem.maxDepth)) <= kMostStored) return {};
    return "virtual-lights would store up to paths * depth = more than 5 * 10^6 lamps in one pass, about 1 "
           "GB; lower paths and take more passes, which give the same";
}

}  // namespace

const EstimatorInfo kVirtualLightsEstimator{
    .id = "virtual-lights",
    .title = "Virtual lights",
    .meaning = "wherever light arrives a small lamp is put, and these lamps light what is seen",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit | kFieldBit,
    .params = kParams,
    .bias =
        "none without clamp; with it, darker where walls are nearer to each other than clamp, above all in "
        "corners; vanishes as clamp goes to 0",
    .paths = paths,
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<VirtualLightsEstimator>(problem, params);
    },
};

}  // namespace halfdisk
