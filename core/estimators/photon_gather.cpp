#include "core/estimators/photon_gather.h"

#include "core/estimators/gather.h"
#include "core/estimators/look.h"

namespace halfdisk {

PhotonGather::PhotonGather(const Problem& problem, const LightTable& lights, const PhotonSender& sender,
                           const PhotonMaps& maps)
    : problem_(problem),
      lights_(lights),
      sender_(sender),
      maps_(maps),
      rays_(sender.rays()),
      ways_{.perLight = static_cast<double>(rays_)},
      raysFind_(maps.global.size() > 0 || canBeMet(lights)) {}

Rgb PhotonGather::received(const Receiver& receiver, const Rng& rng, Counts& counts) const {
    Rgb sum = rays_ > 0 ? gathered(receiver, rng, counts) : directLight(lights_, receiver, rng, counts);
    if (sender_.isFree()) return sum;
    const SidePlace place = sender_.placeOf(receiver.at);
    sum += maps_.caustic.irradiance(place, maps_.causticRadius);
    if (rays_ == 0) sum += maps_.global.irradiance(place, maps_.radius);
    return sum;
}

Rgb PhotonGather::seen(const Receiver& receiver, const Rng& rng, Counts& counts) const {
    const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
    const Looking eye{.lights = lights_, .mostSpecular = problem_.maxSpecular};
    const auto outgoing = [&](const Arrival& here) {
        const Rgb caustic = lookUp(maps_.caustic, here, maps_.causticRadius);
        if (rays_ > 0) return caustic + gathered(here, rng, counts);
        return caustic + directLight(lights_, here, rng, counts) + lookUp(maps_.global, here, maps_.radius);
    };
    return look(eye, sight.ray, Rgb(sight.weight), rng, counts, outgoing);
}

// Light that comes straight to a place, or scattered at the walls around it.
template <class Place>
Rgb PhotonGather::gathered(const Place& place, const Rng& rng, Counts& counts) const {
    Rgb sum = lightDrawn(ways_, lights_, place, rng, counts);
    if (!raysFind_) return sum;
    forDirections(problem_.index, place, rays_, rng, [&](const Ray& ray, const Rgb& share, const Rng& ofRay) {
        sum += alongRay(ray, share, ofRay, counts);
    });
    return sum;
}

// A ray that gathers meets lamps and sky straight, and photons on walls. What mirrors and glass show of lamps
// and sky lies in the caustic map, unless the ray starts where no photon can be.
Rgb PhotonGather::alongRay(const Ray& ray, const Rgb& share, const Rng& rng, Counts& counts) const {
    throwIfStopped(problem_.stop);
    const Looking gathering{lights_, ways_, sender_.isFree(), problem_.maxSpecular};
    const auto outgoing = [&](const Arrival& there) { return lookUp(maps_.global, there, maps_.radius); };
    return look(gathering, ray, share, rng, counts, outgoing);
}

Rgb PhotonGather::lookUp(const PhotonMap& map, const Arrival& here, double radius) const {
    if (map.size() == 0) return Rgb(0.0);
    return map.radiance(here.at, sender_.placeOf(here), here.at.from, radius);
}

}  // namespace halfdisk
