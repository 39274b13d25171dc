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

// [listing]
Rgb PhotonGather::received(const Receiver& receiver, const Rng& rng, Counts& counts) const {
    PathRecorder* const see = problem_.record;
    if (see) see->start(Carried::radiance, receiver.at.P, Rgb(1.0), receiver.at.segment);
    // with rays, what they meet is looked up; without, what lies around the point itself
    Rgb sum = rays_ > 0 ? gathered(receiver, rng, counts) : directLight(lights_, receiver, rng, counts, see);
    if (sender_.isFree()) return sum;
    sum += lookUp(maps_.caustic, receiver, maps_.causticRadius);
    if (rays_ == 0) sum += lookUp(maps_.global, receiver, maps_.radius);
    return sum;
}

// an eye sees lamps and sky straight or by mirrors and glass, and looks up what other walls send
Rgb PhotonGather::seen(const Receiver& receiver, const Rng& rng, Counts& counts) const {
    const Sight sight = sightFrom(receiver, problem_.index, rng.uniform(draws::kStart, 2));
    PathRecorder* const see = problem_.record;
    if (see) see->start(Carried::radiance, receiver.at.P, Rgb(sight.weight), kNoSegment);
    const Looking eye{.lights = lights_, .mostSpecular = problem_.maxSpecular};
    const auto outgoing = [&](const Arrival& here) {
        const Rgb caustic = lookUp(maps_.caustic, here, maps_.causticRadius);
        if (rays_ == 0)
            return caustic + directLight(lights_, here, rng, counts, see, here.throughput) +
                   lookUp(maps_.global, here, maps_.radius);
        if (see) see->branch(here.throughput);
        const Rgb around = gathered(here, rng, counts);
        if (see) see->rejoin();
        return caustic + around;
    };
    return look(eye, sight.ray, Rgb(sight.weight), rng, counts, outgoing, see);
}

// light that comes straight to a place, or scattered at the walls around it
template <class Place>
Rgb PhotonGather::gathered(const Place& place, const Rng& rng, Counts& counts) const {
    PathRecorder* const see = problem_.record;
    const AskedLight light = askLight(ways_, lights_, place, rng, counts);
    Rgb sum = light.value;
    if (see) see->asked(place.at.P, light, light.value);
    if (!raysFind_) return sum;
    forDirections(problem_.index, place, rays_, rng, [&](const Ray& ray, const Rgb& share, const Rng& ofRay) {
        sum += alongRay(ray, share, ofRay, counts);
    });
    return sum;
}

// a ray that gathers meets lamps and sky straight, and photons on walls
Rgb PhotonGather::alongRay(const Ray& ray, const Rgb& share, const Rng& rng, Counts& counts) const {
    throwIfStopped(problem_.stop);
    PathRecorder* const see = problem_.record;
    if (see) see->start(Carried::radiance, ray.origin, share, ray.skip);
    // what mirrors and glass show of lamps and sky lies in the caustic map, unless the ray starts where no
    // photon can be
    const Looking gathering{lights_, ways_, sender_.isFree(), problem_.maxSpecular};
    const auto outgoing = [&](const Arrival& there) { return lookUp(maps_.global, there, maps_.radius); };
    return look(gathering, ray, share, rng, counts, outgoing, see);
}

// the radiance that photons near a wall's point send back
Rgb PhotonGather::lookUp(const PhotonMap& map, const Arrival& here, double radius) const {
    if (map.size() == 0) return Rgb(0.0);
    const SidePlace place = sender_.placeOf(here);
    const Rgb found = map.radiance(here.at, place, here.at.from, radius);
    PathRecorder* const see = problem_.record;
    if (see)
        see->lookedUp(here.at.P, here.at.segment, radius, map.count(place, radius), here.throughput * found);
    return found;
}

// the power of the photons near a point, by the kernel's length
Rgb PhotonGather::lookUp(const PhotonMap& map, const Receiver& receiver, double radius) const {
    const SidePlace place = sender_.placeOf(receiver.at);
    const Rgb found = map.irradiance(place, radius);
    PathRecorder* const see = problem_.record;
    if (see) see->lookedUp(receiver.at.P, receiver.at.segment, radius, map.count(place, radius), found);
    return found;
}
// [end]

}  // namespace halfdisk
