// Which photons does a pass keep, and where? On every wall that scatters and on those that the sensor lies
// on; caustics apart from all the rest.
#pragma once

#include "core/estimators/light_paths.h"
#include "core/estimators/photons.h"

namespace halfdisk {

struct PhotonSettings {
    std::uint32_t paths;           ///< of light, in one pass
    double radius, causticRadius;  ///< m, in pass 0
    double shrink;                 ///< see shrinking
    std::uint32_t rays;            ///< that gather from the first scattering wall; 0: it is looked up itself
    Spread spread;
    std::uint32_t roulette;
};

/// The light of one pass.
struct PhotonMaps {
    PhotonMap global;   ///< what rays look up; without them, what the first wall does: light scattered before
    PhotonMap caustic;  ///< light that came by mirrors and glass only
    double radius, causticRadius;  ///< m
};

/// Sends out the photons of a pass. Made once per problem; keeps references to what it is made of.
class PhotonSender {
 public:
    PhotonSender(const Problem& problem, const LightTable& lights, const PhotonSettings& settings);

    PhotonMaps send(const Rng& ofPass, std::uint64_t pass, Counts& counts) const;

    /// The sensor receives where no photon can be: off the walls, or on a black back.
    bool isFree() const { return free_; }
    /// That gather: as set, but one at least where there is nothing to look up.
    std::uint32_t rays() const { return free_ ? std::max(settings_.rays, 1u) : settings_.rays; }

    SidePlace placeOf(const Arrival& here) const {
        return sideOf(chains_, here.hit.segment, here.hit.u, here.at.front);
    }
    SidePlace placeOf(const ShadedPoint& at) const;

 private:
    bool isFront(const ShadedPoint& at) const;
    bool isOnWall(const ShadedPoint& at) const;

    const Problem& problem_;
    const LightTable& lights_;
    PhotonSettings settings_;
    WallChains chains_;
    std::vector<bool> sensed_;  // by segment: the sensor lies there, be it a mirror or glass
    bool free_ = false;
};

}  // namespace halfdisk
