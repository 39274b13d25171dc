#include "core/estimators/photon_maps.h"

#include "core/blocks.h"

namespace halfdisk {
namespace {

// Rays that gather ask for all light on the wall that they meet; the first wall itself asks only for what is
// not found straight: light that was scattered, and caustics.
struct StoreVisitor : WalkVisitor {
    const WallChains& chains;
    const std::vector<bool>& sensed;  // by segment: kept there even if it is a mirror or glass
    bool gathered, looked;            // rays will gather; the first wall will be looked up
    PathRecorder* see;                // may be null
    Blocks<Photon> global{}, caustic{};

    StoreVisitor(const WallChains& walls, const std::vector<bool>& ofSensor, bool byRays, bool byFirstWall,
                 PathRecorder* observer)
        : chains(walls), sensed(ofSensor), gathered(byRays), looked(byFirstWall), see(observer) {}

    // [listing]
    bool arrive(const Arrival& here) {
        if (isSpecular(*here.at.material) && !sensed[here.hit.segment]) return true;
        const SidePlace place = sideOf(chains, here.hit.segment, here.hit.u, here.at.front);
        const Photon photon{place.side, here.hit.segment, place.along, here.throughput, here.at.from};
        // mirrors and glass sent it, and nothing else: a caustic
        const bool inCaustic = here.scatterings == 0 && here.vertex > 0;
        const bool inGlobal = gathered || (looked && here.scatterings > 0);
        if (inCaustic) caustic.push_back(photon);
        if (inGlobal) global.push_back(photon);
        if (see && (inCaustic || inGlobal)) see->kept(here.at.P, photon.segment, photon.power);
        return true;
    }
    // [end]
};

}  // namespace

PhotonSender::PhotonSender(const Problem& problem, const LightTable& lights, const PhotonSettings& settings)
    : problem_(problem),
      lights_(lights),
      settings_(settings),
      chains_(problem.index),
      sensed_(problem.index.scene().segments.size(), false) {
    if (const auto* profile = std::get_if<Profile>(&problem.sensor))
        for (const std::uint32_t segment : profile->segments) sensed_[segment] = true;
    if (std::holds_alternative<Field>(problem.sensor)) free_ = true;
    if (const auto* probe = std::get_if<Probe>(&problem.sensor)) {
        free_ = !isOnWall(probe->at);
        if (!free_) sensed_[probe->at.segment] = true;
    }
}

bool PhotonSender::isFront(const ShadedPoint& at) const {
    return glm::dot(problem_.index.normal(at.segment), at.N) > 0.0;
}

bool PhotonSender::isOnWall(const ShadedPoint& at) const {
    return at.segment != kNoSegment && (isFront(at) || problem_.index.scene().segments[at.segment].twoSided ||
                                        actsOnBothSides(problem_.index.material(at.segment)));
}

PhotonMaps PhotonSender::send(const Rng& ofPass, std::uint64_t pass, Counts& counts) const {
    const bool deep = problem_.maxDepth > 0, gathers = rays() > 0;
    // The walls that rays meet scatter once more than those that are looked up at once.
    const std::uint32_t depth =
        gathers ? problem_.maxDepth - std::min(1u, problem_.maxDepth) : problem_.maxDepth;
    const WalkLimits limits{depth, problem_.maxSpecular, settings_.roulette};
    StoreVisitor store(chains_, sensed_, deep && gathers, deep && !gathers, problem_.record);
    sendLight(lights_, settings_.paths, settings_.spread, limits, ofPass, counts, store, problem_.record,
              problem_.stop);
    const double shrunk = shrinking(settings_.shrink, pass);
    return {PhotonMap(problem_.index, chains_, std::move(store.global).joined(problem_.stop), problem_.stop),
            PhotonMap(problem_.index, chains_, std::move(store.caustic).joined(problem_.stop), problem_.stop),
            settings_.radius * shrunk, settings_.causticRadius * shrunk};
}

SidePlace PhotonSender::placeOf(const ShadedPoint& at) const {
    const Segment& wall = problem_.index.scene().segments[at.segment];
    const double length = problem_.index.length(at.segment);
    const double u = glm::dot(at.P - wall.a, wall.b - wall.a) / (length * length);
    return sideOf(chains_, at.segment, std::clamp(u, 0.0, 1.0), isFront(at));
}

}  // namespace halfdisk
