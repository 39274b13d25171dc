// Estimator `path`: one path per sample, backwards from the sensor, asking one light at every wall.
//
// Kajiya 1986, "The rendering equation", with next-event estimation, the surface's own lobe, multiple
// importance sampling (Veach 1997, chapter 9) and Russian roulette; each can be switched off to see what it
// is good for.
#include "core/estimators/all.h"
#include "core/estimators/params.h"
#include "core/path_recorder.h"

namespace halfdisk {
namespace {

enum Param { kEmitterWay, kHeuristic, kDirections, kRoulette };

constexpr std::array kParams{kEmittersParam, kHeuristicParam, kDirectionsParam, kRouletteParam};

// Light that a path finds: lamps and sky that it meets, and at every wall one light that it asks.
struct PathVisitor : WalkVisitor {
    const LightTable& lights;
    const LightWays& ways;
    const Rng& rng;
    std::uint32_t mostScatterings;
    Counts& counts;
    PathRecorder* see;  // may be null
    Rgb found{0.0};

    PathVisitor(const LightTable& table, const LightWays& how, const Rng& numbers, std::uint32_t most,
                Counts& spent, PathRecorder* observer)
        : lights(table), ways(how), rng(numbers), mostScatterings(most), counts(spent), see(observer) {}

    // [listing]
    // at the start, a point asks a light itself
    void gather(const Receiver& receiver) {
        const AskedLight light = askLight(ways, lights, receiver, rng, counts);
        found += light.value;
        if (see) see->asked(receiver.at.P, light, light.value);
    }

    // a lamp or the sky, met by chance
    void meet(const Ray& ray, const Hit& hit, const Rgb& throughput) {
        const Rgb light = throughput * lightMet(ways, lights, ray, hit);
        found += light;
        if (see && light != Rgb(0.0)) see->met(ray, hit, weightMet(ways, lights, ray, hit), light);
    }

    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t) { meet(ray, {}, throughput); }

    bool arrive(const Arrival& here) {
        meet(here.ray, here.hit, here.throughput);
        if (here.scatterings >= mostScatterings || isSpecular(*here.at.material)) return true;
        // next-event estimation: every wall asks one light
        const AskedLight light = askLight(ways, lights, here, rng, counts);
        found += here.throughput * light.value;
        if (see) see->asked(here.at.P, light, here.throughput * light.value);
        return true;
    }
    // [end]
};

class PathEstimator : public Estimator {
 public:
    PathEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          receivers_(problem.sensor, problem.index),
          lights_(problem.index, placesOf(problem.sensor)),
          ways_{as<Emitters>(params[kEmitterWay]), as<Heuristic>(params[kHeuristic]),
                as<Directions>(params[kDirections])},
          limits_{mostScatterings(problem), problem.maxSpecular, as<std::uint32_t>(params[kRoulette]),
                  ways_.directions} {}

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        PathRecorder* const see = problem_.record;
        // [listing]
        // one path for each pixel of a pass
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            throwIfStopped(problem_.stop, pixel);
            if (see && !see->wants(pixel)) continue;
            const Rng rng = Rng(problem_.seed, pass).child(pixel);
            const Receiver receiver =
                receivers_.draw(pixel, rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
            ++counts.paths;
            if (receiver.covered) continue;
            const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
            if (see) see->start(Carried::radiance, receiver.at.P, Rgb(sight.weight), receiver.at.segment);
            PathVisitor visitor(lights_, ways_, rng, limits_.scatterings, counts, see);
            if (gathers(receiver)) visitor.gather(receiver);
            Watched watched{visitor, see};
            walk(problem_.index, sight.ray, Rgb(sight.weight), Carried::radiance, limits_, rng, counts,
                 watched);
            addTo(picture, pixel, visitor.found, counts);
        }
        // [end]
    }

 private:
    Problem problem_;
    Receivers receivers_;
    LightTable lights_;
    LightWays ways_;
    WalkLimits limits_;
};

std::string paths(const Scene& scene, unsigned sensor) {
    return kCastRayEstimator.paths(scene, sensor);
}

}  // namespace

const EstimatorInfo kPathEstimator{
    .id = "path",
    .title = "Path tracing",
    .meaning = "one path per sample, backwards from the sensor, asking one light at every wall",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit | kFieldBit,
    .params = kParams,
    .bias = {},
    .recorded = true,
    .paths = paths,
    .refusal = nullptr,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<PathEstimator>(problem, params);
    },
};

}  // namespace halfdisk
