// What does a sensor see of a pass's photons? Direct light and what the maps hold, at the first scattering
// wall or by rays that gather from it.
#pragma once

#include "core/estimators/photon_maps.h"
#include "core/light_ways.h"

namespace halfdisk {

/// For one pass. Keeps references.
class PhotonGather {
 public:
    PhotonGather(const Problem& problem, const LightTable& lights, const PhotonSender& sender,
                 const PhotonMaps& maps);

    /// At a receiver that gathers: irradiance or fluence, W/m. `rng` is the pixel's.
    Rgb received(const Receiver& receiver, const Rng& rng, Counts& counts) const;

    /// Radiance along a ray of an eye.
    Rgb seen(const Receiver& receiver, const Rng& rng, Counts& counts) const;

 private:
    template <class Place>
    Rgb gathered(const Place& place, const Rng& rng, Counts& counts) const;
    Rgb alongRay(const Ray& ray, const Rgb& share, const Rng& rng, Counts& counts) const;
    Rgb lookUp(const PhotonMap& map, const Arrival& here, double radius) const;
    Rgb lookUp(const PhotonMap& map, const Receiver& receiver, double radius) const;

    const Problem& problem_;
    const LightTable& lights_;
    const PhotonSender& sender_;
    const PhotonMaps& maps_;
    std::uint32_t rays_;  // that gather
    LightWays ways_;      // how lamps and sky are shared by the light that is asked and by these rays
    bool raysFind_;       // there may be light that they meet
};

}  // namespace halfdisk
