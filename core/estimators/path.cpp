// Estimator `path`: one path per sample, backwards from the sensor, asking one light at every wall.
//
// Kajiya 1986, "The rendering equation", with next-event estimation, the surface's own lobe, multiple
// importance sampling (Veach 1997, chapter 9) and Russian roulette; each can be switched off to see what it
// is good for.
#include "core/estimators/all.h"
#include "core/estimators/params.h"
#include "core/walk.h"

namespace halfdisk {
namespace {

enum Param { kEmitterWay, kHeuristic, kDirections, kRoulette };

constexpr std::array kParams{kEmittersParam, kHeuristicParam, kDirectionsParam, kRouletteParam};

struct Ways {
    Emitters emitters;
    Heuristic heuristic;
    Directions directions;
};

// Light that a path finds: lamps and sky that it meets, and at every wall one light that it asks.
struct PathVisitor : WalkVisitor {
    const LightTable& lights;
    const Ways& ways;
    const Rng& rng;
    std::uint32_t mostScatterings;
    Counts& counts;
    Rgb found{0.0};

    PathVisitor(const LightTable& table, const Ways& how, const Rng& numbers, std::uint32_t most,
                Counts& spent)
        : lights(table), ways(how), rng(numbers), mostScatterings(most), counts(spent) {}

    double weightMet(const Ray& ray, const Hit& hit) const {
        if (ray.pdfAngle == 0.0 || ways.emitters == Emitters::hit) return 1.0;
        if (ways.emitters == Emitters::sample) return 0.0;
        return misWeight(ways.heuristic, ray.pdfAngle, lights.pdfDrawn(ray, hit));
    }

    double weightDrawn(const DrawnLight& light, double pdfMet) const {
        if (light.pdfAngle == 0.0) return 1.0;
        if (ways.emitters == Emitters::hit) return 0.0;
        return ways.emitters == Emitters::sample ? 1.0 : misWeight(ways.heuristic, light.pdfAngle, pdfMet);
    }

    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t) {
        const Rgb sky = lights.index().environment(ray.direction);
        if (sky != Rgb(0.0)) found += throughput * sky * weightMet(ray, {});
    }

    bool arrive(const Arrival& here) {
        const Segment& wall = lights.index().scene().segments[here.hit.segment];
        if (isEmitter(wall) && (here.at.front || wall.twoSided))
            found += here.throughput * wall.emission * weightMet(here.ray, here.hit);
        if (here.scatterings < mostScatterings && !isSpecular(*here.at.material)) askLight(here);
        return true;
    }

    void askLight(const Arrival& here) {
        const DrawnLight light = drawLight(lights, here.at, rng.uniform(here.vertex, draws::kPick),
                                           rng.uniform(here.vertex, draws::kLight), counts);
        if (light.L_i == Rgb(0.0)) return;
        const double weight = weightDrawn(light, pdfSurface(here.at, here.at.from, light.L, ways.directions));
        found += here.throughput * evalSurface(here.at, light.L, here.at.from) * light.L_i *
                 (glm::dot(here.at.N, light.L) * weight);
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
            const Rng rng = Rng(problem_.seed, pass).child(pixel);
            const Receiver receiver = startOf(problem_.sensor, problem_.index, pixel,
                                              rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
            PathVisitor visitor(lights_, ways_, rng, limits_.scatterings, counts);
            if (gathers(receiver)) askLightAt(receiver, rng, visitor);
            const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
            walk(problem_.index, sight.ray, Rgb(sight.weight), Carried::radiance, limits_, rng, counts,
                 visitor);
            addTo(picture, pixel, visitor.found, counts);
            ++counts.paths;
        }
    }

 private:
    void askLightAt(const Receiver& receiver, const Rng& rng, PathVisitor& visitor) const {
        const DrawnLight light = drawLight(lights_, receiver, rng.uniform(draws::kStart, draws::kPick),
                                           rng.uniform(draws::kStart, draws::kLight), visitor.counts);
        if (light.L_i == Rgb(0.0)) return;
        visitor.found += light.L_i * (responseTo(receiver, light.L).weight *
                                      visitor.weightDrawn(light, pdfSight(receiver, light.L)));
    }

    Problem problem_;
    LightTable lights_;
    Ways ways_;
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
