// Estimator `light`: paths forward from the lights, counted where they arrive.
//
// Forward tracing, also called light or particle tracing (Dutre, Lafortune & Willems 1993): on a profile's
// walls the power that arrives is counted, in a field the length that light flies through each cell; an eye
// or a point is never met by chance, so every wall that the light meets is connected to it.
#include "core/estimators/all.h"
#include "core/estimators/light_paths.h"
#include "core/estimators/params.h"
#include "core/field_cells.h"
#include "core/splat/field_splat.h"
#include "core/walk.h"

namespace halfdisk {
namespace {

enum Param { kPaths, kSpread, kRoulette };

constexpr std::array kParams{
    ParamInfo{.name = "paths",
              .meaning = "light paths of one pass; 0: as many as there are pixels",
              .most = 1e7,
              .whole = true},
    kSpreadParam,
    kRouletteParam,
};

struct LightVisitor : WalkVisitor {
    const Problem& problem;
    const std::optional<Receiver>& receiver;
    const std::optional<ProfileBins>& bins;
    std::optional<FieldSplat> splat{};
    Picture& picture;
    Counts& counts;
    PathRecorder* see;  // may be null

    LightVisitor(const Problem& asked, const std::optional<Receiver>& point,
                 const std::optional<ProfileBins>& walls, Picture& sums, Counts& spent)
        : problem(asked), receiver(point), bins(walls), picture(sums), counts(spent), see(asked.record) {
        if (const auto* field = std::get_if<Field>(&asked.sensor)) splat.emplace(*field, sums, asked.stop);
    }

    void fly(const Ray& ray, double distance, const Rgb& power, std::uint32_t) {
        if (!splat) return;
        const Rgb absorption =
            ray.medium == kNoMedium
                ? Rgb(0.0)
                : std::get<Dielectric>(problem.index.scene().materials[ray.medium]).absorption;
        if (absorption == Rgb(0.0)) return splat->add(ray, distance, power, counts);
        const auto& field = std::get<Field>(problem.sensor);
        const Vec2 cell = (field.max - field.min) / Vec2(field.width, field.height);
        const double area = cell.x * cell.y;
        forCells(field, ray, distance, [&](std::uint32_t pixel, double from, double to) {
            addTo(picture, pixel, power * flown(absorption, from, to) / area, counts);
        });
    }

    // Metres flown between two places of a flight, less what a medium takes on the way there and between.
    static Rgb flown(const Rgb& absorption, double from, double to) {
        Rgb metres;
        for (int c = 0; c < 3; ++c)
            metres[c] = absorption[c] > 0.0 ? -std::exp(-absorption[c] * from) *
                                                  std::expm1(-absorption[c] * (to - from)) / absorption[c]
                                            : to - from;
        return metres;
    }

    // [listing]
    bool arrive(const Arrival& here) {
        // on a wall that is measured, light is counted where it arrives
        if (bins && here.at.front)
            if (const auto place = bins->at(here.hit.segment, here.hit.u))
                addTo(picture, place->bin, here.throughput / place->length, counts);
        // a point is never met by chance: every wall is connected to it
        if (receiver && !isSpecular(*here.at.material)) connectTo(here);
        return true;
    }

    void connectTo(const Arrival& here) {
        const Connection way = connect(problem.index, here.at, *receiver, counts);
        const bool visible = way.passed != Rgb(0.0);
        const double geometry = visible ? glm::dot(here.at.N, way.toReceiver) / way.distance : 0.0;
        const Rgb brdf = visible ? evalSurface(here.at, here.at.from, way.toReceiver) : Rgb(0.0);
        const Rgb value = here.throughput * brdf * way.passed * (geometry * way.response.weight);
        if (visible) addTo(picture, way.response.pixel, value, counts);
        if (see && see->wants(way.response.pixel))
            see->joined(here.at.P, receiver->at.P, here.vertex + 2, 1, visible, 1.0, value);
    }
    // [end]
};

class LightEstimator : public Estimator {
 public:
    LightEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          lights_(problem.index, placesOf(problem.sensor)),
          receiver_(fixedReceiver(problem.sensor, problem.index)),
          paths_(params[kPaths] > 0.0 ? as<std::uint32_t>(params[kPaths]) : pixelCount(problem.sensor)),
          spread_(as<Spread>(params[kSpread])),
          limits_{problem.maxDepth, problem.maxSpecular, as<std::uint32_t>(params[kRoulette])} {
        if (const auto* profile = std::get_if<Profile>(&problem.sensor))
            bins_.emplace(*profile, problem.index);
        // A wall that is connected to a point scatters once more.
        if (std::holds_alternative<Probe>(problem.sensor)) endsBelow_ = problem.maxDepth == 0;
        if (std::holds_alternative<Probe>(problem.sensor) && problem.maxDepth > 0) --limits_.scatterings;
    }

    double workPerPass() const override { return paths_; }

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        const Rng ofPass(problem_.seed, pass);
        // What comes straight is told as one path before all others.
        if (problem_.record && receiver_)
            problem_.record->start(Carried::power, receiver_->at.P, Rgb(0.0), kNoSegment);
        for (std::uint32_t path = 0; receiver_ && path < paths_; ++path) {
            throwIfStopped(problem_.stop, path);
            askDirectly(ofPass.child(path), picture, counts);
        }
        if (endsBelow_) return;
        LightVisitor visitor(problem_, receiver_, bins_, picture, counts);
        sendLight(lights_, paths_, spread_, limits_, ofPass, counts, visitor, problem_.record, problem_.stop);
        if (visitor.splat) visitor.splat->finish();
    }

 private:
    // [listing]
    // the path of no wall: from a light straight to the point (an eye does not see a light that has no size)
    void askDirectly(const Rng& rng, Picture& picture, Counts& counts) const {
        const DrawnLight light = drawLight(lights_, *receiver_, rng.uniform(draws::kStart, draws::kPick),
                                           rng.uniform(draws::kStart, draws::kLight), counts);
        PathRecorder* const see = problem_.record;
        if (light.pdfAngle == 0.0 && !gathers(*receiver_)) return;
        const Response response = responseTo(*receiver_, light.L);
        const Rgb value = light.L_i * (response.weight / paths_);
        if (light.L_i != Rgb(0.0)) addTo(picture, response.pixel, value, counts);
        if (see && see->wants(response.pixel)) see->asked(receiver_->at.P, {light, 1.0, value}, value);
    }
    // [end]

    Problem problem_;
    LightTable lights_;
    std::optional<Receiver> receiver_;
    std::optional<ProfileBins> bins_;
    std::uint32_t paths_;
    Spread spread_;
    bool endsBelow_ = false;  // no wall may scatter: only light straight from its source counts
    WalkLimits limits_;
};

// A point or a pinhole is connected from walls, never met: mirrors and glass can't be the last thing before
// it.
std::string paths(const Scene& scene, unsigned sensor) {
    const SceneTraits traits = traitsOf(scene);
    if ((sensor & (kProfileBit | kFieldBit)) || !traits.specular) return allPaths(scene);
    return traits.scattering ? "L(S|D)*DE or LE" : "LE";
}

}  // namespace

const EstimatorInfo kLightEstimator{
    .id = "light",
    .title = "Light tracing",
    .meaning =
        "paths forward from the lights: counted on walls and in the field, connected to an eye or a point",
    .sensors = kProbeBit | kEyeBit | kProfileBit | kFieldBit,
    .params = kParams,
    .bias = {},
    .recorded = true,
    .paths = paths,
    .refusal = nullptr,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<LightEstimator>(problem, params);
    },
};

}  // namespace halfdisk
