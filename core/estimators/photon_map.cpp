// Estimator `photon-map`: light is sent out first and its photons are kept where they arrive; what is seen is
// then looked up in them.
//
// Jensen 1996, "Global illumination using photon maps", with a caustic map of its own, final gathering, and
// the iterated variant that shrinks the radius from pass to pass (Knaus & Zwicker 2011, "Progressive photon
// mapping: a probabilistic approach"), all with a kernel of length instead of area.
#include "core/estimators/all.h"
#include "core/estimators/light_paths.h"
#include "core/estimators/look.h"
#include "core/estimators/params.h"
#include "core/estimators/photons.h"

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

struct Maps {
    PhotonMap global;   // what rays look up, or what the first wall does
    PhotonMap caustic;  // light that came by mirrors and glass only
    double radius, causticRadius;
};

// Which photons are kept. Rays that gather ask for all light on the wall that they meet; the first wall
// itself asks only for what is not found straight: light that was scattered, and caustics.
struct StoreVisitor : WalkVisitor {
    const WallChains& chains;
    const std::vector<bool>& received;  // by segment: kept there even if it is a mirror or glass
    bool gathered, looked;              // rays will gather; the first wall will be looked up
    std::vector<Photon> global{}, caustic{};

    StoreVisitor(const WallChains& walls, const std::vector<bool>& sensed, bool byRays, bool byFirstWall)
        : chains(walls), received(sensed), gathered(byRays), looked(byFirstWall) {}

    bool arrive(const Arrival& here) {
        if (isSpecular(*here.at.material) && !received[here.hit.segment]) return true;
        const SidePlace place = sideOf(chains, here.hit.segment, here.hit.u, here.at.front);
        const Photon photon{place.side, here.hit.segment, place.along, here.throughput, here.at.from};
        if (here.scatterings == 0 && here.vertex > 0) caustic.push_back(photon);
        if (gathered || (looked && here.scatterings > 0)) global.push_back(photon);
        return true;
    }
};

class PhotonMapEstimator : public Estimator {
 public:
    PhotonMapEstimator(const Problem& problem, const ParamValues& params)
        : problem_(problem),
          lights_(problem.index, placesOf(problem.sensor)),
          chains_(problem.index),
          photons_(as<std::uint32_t>(params[kPhotons])),
          radius_(params[kRadius]),
          causticRadius_(params[params[kCaustics] > 0.0 ? kCausticRadius : kRadius]),
          shrink_(params[kShrink]),
          spread_(as<Spread>(params[kSpread])),
          rays_(as<std::uint32_t>(params[kGather])),
          received_(problem.index.scene().segments.size(), false) {
        if (const auto* profile = std::get_if<Profile>(&problem.sensor))
            for (const std::uint32_t segment : profile->segments) received_[segment] = true;
        if (std::holds_alternative<Field>(problem.sensor)) free_ = true;
        if (const auto* probe = std::get_if<Probe>(&problem.sensor)) {
            free_ = !isOnWall(probe->at);
            if (!free_) received_[probe->at.segment] = true;
        }
        // Where no photon arrives there is only what rays see.
        if (free_) rays_ = std::max(rays_, 1u);
        // The walls that rays meet scatter once more than those that are looked up at once.
        depth_ = rays_ > 0 ? problem.maxDepth - std::min(1u, problem.maxDepth) : problem.maxDepth;
        limits_ = {depth_, problem.maxSpecular, as<std::uint32_t>(params[kRoulette])};
    }

    double workPerPass() const override { return photons_; }

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        const Rng ofPass(problem_.seed, pass);
        const Maps maps = trace(ofPass, shrinking(shrink_, pass), counts);
        for (std::uint32_t pixel = 0; pixel < picture.size(); ++pixel) {
            const Rng rng = ofPass.child(pixel);
            const Receiver receiver = startOf(problem_.sensor, problem_.index, pixel,
                                              rng.uniform(draws::kStart, 0), rng.uniform(draws::kStart, 1));
            const Rgb value =
                gathers(receiver) ? received(maps, receiver, rng, counts) : seen(maps, receiver, rng, counts);
            addTo(picture, pixel, value, counts);
            ++counts.paths;
        }
    }

 private:
    bool isFront(const ShadedPoint& at) const {
        return glm::dot(problem_.index.normal(at.segment), at.N) > 0.0;
    }

    bool isOnWall(const ShadedPoint& at) const {
        return at.segment != kNoSegment &&
               (isFront(at) || problem_.index.scene().segments[at.segment].twoSided ||
                actsOnBothSides(problem_.index.material(at.segment)));
    }

    Maps trace(const Rng& ofPass, double shrunk, Counts& counts) const {
        const bool deep = problem_.maxDepth > 0;
        StoreVisitor store(chains_, received_, deep && rays_ > 0, deep && rays_ == 0);
        sendLight(lights_, photons_, spread_, limits_, ofPass, counts, store);
        return {PhotonMap(problem_.index, chains_, std::move(store.global)),
                PhotonMap(problem_.index, chains_, std::move(store.caustic)), radius_ * shrunk,
                causticRadius_ * shrunk};
    }

    // Irradiance, or fluence.
    Rgb received(const Maps& maps, const Receiver& receiver, const Rng& rng, Counts& counts) const {
        Rgb sum = directAt(lights_, receiver, rng, counts);
        if (!free_) {
            const SidePlace place = placeOf(receiver.at);
            sum += maps.caustic.irradiance(place, maps.causticRadius);
            if (rays_ == 0) sum += maps.global.irradiance(place, maps.radius);
            if (maps.global.size() == 0) return sum;
        }
        for (std::uint32_t n = 0; n < rays_; ++n) {
            const Rng ofRay = rng.child(draws::kStart).child(n);
            const Sight sight =
                sightFrom(receiver, problem_.index, (n + ofRay.uniform(draws::kStart, 0)) / rays_);
            sum += gather(maps, sight.ray, Rgb(sight.weight / rays_), ofRay, counts);
        }
        return sum;
    }

    SidePlace placeOf(const ShadedPoint& at) const {
        const Segment& wall = problem_.index.scene().segments[at.segment];
        const double length = problem_.index.length(at.segment);
        const double u = glm::dot(at.P - wall.a, wall.b - wall.a) / (length * length);
        return sideOf(chains_, at.segment, std::clamp(u, 0.0, 1.0), isFront(at));
    }

    // Light on the walls that a ray sees. Lamps were asked where it starts, and caustics looked up, unless it
    // starts where no photon can be.
    Rgb gather(const Maps& maps, const Ray& ray, const Rgb& share, const Rng& rng, Counts& counts) const {
        const auto outgoing = [&](const Arrival& there) { return lookUp(maps.global, there, maps.radius); };
        return look(problem_.index, ray, share, problem_.maxSpecular, free_ ? Met::bySpeculars : Met::none,
                    rng, counts, outgoing);
    }

    Rgb lookUp(const PhotonMap& map, const Arrival& here, double radius) const {
        if (map.size() == 0) return Rgb(0.0);
        const SidePlace place = sideOf(chains_, here.hit.segment, here.hit.u, here.at.front);
        return map.radiance(here.at, place, here.at.from, radius);
    }

    // Radiance along a ray from an eye.
    Rgb seen(const Maps& maps, const Receiver& receiver, const Rng& rng, Counts& counts) const {
        const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
        const auto outgoing = [&](const Arrival& here) {
            const Rgb direct = directFrom(lights_, here, rng, counts);
            const Rgb caustic = lookUp(maps.caustic, here, maps.causticRadius);
            return direct + caustic +
                   (rays_ == 0 ? lookUp(maps.global, here, maps.radius)
                               : gatherFrom(maps, here, rng, counts));
        };
        return look(problem_.index, sight.ray, Rgb(sight.weight), problem_.maxSpecular, Met::all, rng, counts,
                    outgoing);
    }

    Rgb gatherFrom(const Maps& maps, const Arrival& here, const Rng& rng, Counts& counts) const {
        Rgb sum{0.0};
        if (maps.global.size() == 0) return sum;
        for (std::uint32_t n = 0; n < rays_; ++n) {
            const Rng ofRay = rng.child(here.vertex).child(n);
            const ScatterDraws numbers{ofRay.uniform(draws::kStart, 0),
                                       (n + ofRay.uniform(draws::kStart, 1)) / rays_,
                                       ofRay.uniform(draws::kStart, 2)};
            const auto way = sampleSurface(here.at, Carried::radiance, numbers);
            // What a mirror's part sends on is followed by the ray that looks.
            if (!way || way->isDelta()) continue;
            sum += gather(maps, leave(problem_.index, here.at, *way, 0),
                          way->weight / static_cast<double>(rays_), ofRay, counts);
        }
        return sum;
    }

    Problem problem_;
    LightTable lights_;
    WallChains chains_;
    std::uint32_t photons_;
    double radius_, causticRadius_, shrink_;
    Spread spread_;
    std::uint32_t rays_;
    std::vector<bool> received_;
    bool free_ = false;  // the receiver lies on no wall that photons are kept on
    std::uint32_t depth_ = 0;
    WalkLimits limits_;
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
    .paths = paths,
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues& params) -> std::unique_ptr<Estimator> {
        return std::make_unique<PhotonMapEstimator>(problem, params);
    },
};

}  // namespace halfdisk
