// Estimator `cast-ray`: the published recursion, N rays from every wall that is met.
#include "core/cast_ray.h"

#include "core/estimators/all.h"
#include "core/estimators/params.h"

namespace halfdisk {
namespace {

enum Param { kSamples, kSampler, kEmitters_ };

constexpr std::array<std::string_view, kSamplers.size()> kSamplerChoices{
    kSamplers[0].name, kSamplers[1].name, kSamplers[2].name, kSamplers[3].name};
constexpr std::array kParams{
    ParamInfo{.name = "samples",
              .meaning = "N, half-disk samples per bounce: the cost grows as N^depth",
              .least = 1,
              .most = 1e6,
              .initial = 4,
              .whole = true},
    ParamInfo{.name = "sampler",
              .meaning = "how directions are drawn over the half-disk",
              .choices = kSamplerChoices},
    ParamInfo{
        .name = kEmittersParam.name,
        .meaning =
            "how lamps are found: drawn (sample), met by chance (hit), or both, weighed; the sky is always "
            "met by chance",
        .choices = kEmitterChoices},
};

/// Asks on the way whether to go on: a pixel may take 10^9 rays.
struct StopObserver : NoObserver {
    const StopQuestion& stop;
    std::uint64_t steps = 0;

    void meet(const Ray&, const Hit&, std::uint32_t, std::uint64_t) { throwIfStopped(stop, steps++); }
    void light(std::uint32_t, std::uint32_t, const LightSample&, double, const Rgb&) {
        throwIfStopped(stop, steps++);
    }
};
using Tracer = CastRay<StopObserver>;

class CastRayEstimator : public Estimator {
 public:
    CastRayEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem), receivers_(problem.sensor, problem.index) {
        settings_.samples = as<std::uint32_t>(params[kSamples]);
        settings_.maxDepth = problem.maxDepth;
        settings_.maxSpecular = problem.maxSpecular;
        settings_.seed = problem.seed;
        settings_.sampler = as<Sampler>(params[kSampler]);
        settings_.emitters = as<Emitters>(params[kEmitters_]);
    }

    double workPerPass() const override {
        return pixelCount(problem_.sensor) * std::pow(settings_.samples, problem_.maxDepth + 1.0);
    }

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        StopObserver observer{{}, problem_.stop};
        Tracer tracer{{problem_.index, settings_, observer}};
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            const Rng rng = Rng(problem_.seed, pass).child(pixel);
            const Receiver receiver =
                receivers_.draw(pixel, rng.uniform(kOwnSample, 2), rng.uniform(kOwnSample, 3));
            ++counts.paths;
            if (!receiver.covered) addTo(picture, pixel, valueAt(tracer, receiver, rng), counts);
        }
        counts.rays += tracer.rays;
        counts.cut += tracer.cut;
    }

 private:
    Rgb valueAt(Tracer& tracer, const Receiver& receiver, const Rng& rng) const {
        switch (receiver.weighing) {
            case Weighing::cosine:
                return tracer.gatherLight(receiver.at, 0, rng, SampleRange::all(settings_.samples)).total();
            case Weighing::even:
                return fluenceAt(tracer, receiver, rng);
            case Weighing::film:
            case Weighing::one:
                break;
        }
        const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(kOwnSample, 4));
        return tracer.castRay(sight.ray, 0, rng).total() * sight.weight;
    }

    // In empty space there is no half-disk: N directions of the full circle, and lamps are met by chance.
    Rgb fluenceAt(Tracer& tracer, const Receiver& receiver, const Rng& rng) const {
        Rgb sum{0.0};
        UniformRow angles(rng, 0);
        for (std::uint32_t n = 0; n < settings_.samples; ++n) {
            Sight sight =
                sightFrom(receiver, problem_.index, drawUnit(settings_, angles, n, settings_.samples));
            sight.ray.pdfAngle = 0.0;
            sum += tracer.castRay(sight.ray, 1, rng.child(n)).total() * sight.weight;
        }
        sum /= settings_.samples;
        for (std::uint32_t i = 0; i < problem_.index.scene().lights.size(); ++i) {
            const LightSample light = sampleLight(problem_.index, i, receiver.at.P, 0.5);
            ++tracer.rays;
            if (!problem_.index.occluded(rayFrom(problem_.index, receiver.at, light.L), light.distance))
                sum += light.L_i * transmittance(problem_.index, receiver.at.medium, light.distance);
        }
        return sum;
    }

    Problem problem_;
    Receivers receivers_;
    Settings settings_;
};

// What a shadow ray can't reach it must meet by chance, and a point or directional light can't be met.
std::string paths(const Scene& scene, unsigned) {
    const SceneTraits traits = traitsOf(scene);
    if (!traits.delta || !traits.specular) return allPaths(scene);
    return traits.area
               ? "L(S|D)*E from lamps and the environment, LD(S|D)*E or LE from point and directional lights"
               : "LD(S|D)*E or LE";
}

// The recursion would not end in a lifetime.
std::string refusal(const Problem& problem, const ParamValues& params) {
    constexpr double kMostRays = 1e9;
    const double rays = std::pow(params[kSamples], problem.maxDepth + 1.0);
    if (rays <= kMostRays) return {};
    return "cast-ray would need samples^(depth + 1) = more than 10^9 rays for one pixel; lower samples or "
           "depth, or ask the estimator path";
}

}  // namespace

const EstimatorInfo kCastRayEstimator{
    .id = "cast-ray",
    .title = "castRay",
    .meaning = "the published recursion: direct light, then N samples over the half-disk of every wall met",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit | kFieldBit,
    .params = kParams,
    .bias = {},
    .paths = paths,
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<CastRayEstimator>(problem, params);
    },
};

}  // namespace halfdisk
