// Estimator `path`: one path per sample, backwards from the sensor, asking one light at every wall.
//
// Kajiya 1986, "The rendering equation", with next-event estimation, the surface's own lobe, multiple
// importance sampling (Veach 1997, chapter 9) and Russian roulette; each can be switched off to see what it
// is good for.
#include "core/estimators/all.h"
#include "core/estimators/params.h"
#include "core/light_ways.h"

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
    Rgb found{0.0};

    PathVisitor(const LightTable& table, const LightWays& how, const Rng& numbers, std::uint32_t most,
                Counts& spent)
        : lights(table), ways(how), rng(numbers), mostScatterings(most), counts(spent) {}

    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t) {
        found += throughput * lightMet(ways, lights, ray, {});
    }

    bool arrive(const Arrival& here) {
        found += here.throughput * lightMet(ways, lights, here.ray, here.hit);
        if (here.scatterings < mostScatterings && !isSpecular(*here.at.material))
            found += here.throughput * lightDrawn(ways, lights, here, rng, counts);
        return true;
    }
};

class PathEstimator : public Estimator {
 public:
    PathEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          lights_(problem.index, placesOf(problem.sensor)),
          ways_{as<Emitters>(params[kEmitterWay]), as<Heuristic>(params[kHeuristic]),
                as<Directions>(params[kDirections])},
          limits_{mostScatterings(problem), problem.maxSpecular, as<std::uint32_t>(params[kRoulette]),
                  ways_.directions} {}

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            throwIfStopped(problem_.stop, pixel);
            const Rng rng = Rng(problem_.seed, pass).child(pixel);
            const Receiver receiver = startOf(problem_.sensor, problem_.index, pixel,
                                              rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
            PathVisitor visitor(lights_, ways_, rng, limits_.scatterings, counts);
            if (gathers(receiver)) visitor.found = lightDrawn(ways_, lights_, receiver, rng, counts);
            const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
            walk(problem_.index, sight.ray, Rgb(sight.weight), Carried::radiance, limits_, rng, counts,
                 visitor);
            addTo(picture, pixel, visitor.found, counts);
            ++counts.paths;
        }
    }

 private:
    Problem problem_;
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
    .paths = paths,
    .refusal = nullptr,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<PathEstimator>(problem, params);
    },
};

}  // namespace halfdisk
