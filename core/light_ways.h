// Light straight from a lamp or the sky can be found in two ways: a light is drawn and asked, or a direction
// is drawn and meets it. How do both share it? Multiple importance sampling (Veach 1997, section 9.2).
//
// The sum over both ways counts all light once: what one alone can find (a light with one direction; what is
// seen by a mirror or glass) it counts whole.
#pragma once

#include "direct_light.h"

namespace halfdisk {

struct LightWays {
    Emitters emitters = Emitters::both;
    Heuristic heuristic = Heuristic::balance;
    Directions directions = Directions::lobe;
    double perLight = 1.0;  ///< directions that are drawn for each light that is asked
};

/// Share that a ray may count of the lamp that it met, or of the sky (no hit). An aimed ray, and one that
/// comes from a mirror or glass, is the only way.
inline double weightMet(const LightWays& ways, const LightTable& lights, const Ray& ray, const Hit& hit) {
    if (ray.pdfAngle == 0.0 || ways.emitters == Emitters::hit) return 1.0;
    if (ways.emitters == Emitters::sample) return 0.0;
    return misWeight(ways.heuristic, ways.perLight * ray.pdfAngle, lights.pdfDrawn(ray, hit));
}

/// The other share; pdfMet: 1/rad, with which the place draws this direction.
inline double weightDrawn(const LightWays& ways, const DrawnLight& light, double pdfMet) {
    if (light.pdfAngle == 0.0 || ways.emitters == Emitters::sample) return 1.0;
    if (ways.emitters == Emitters::hit) return 0.0;
    return misWeight(ways.heuristic, light.pdfAngle, ways.perLight * pdfMet);
}

/// Whether there is any light that a ray can meet: a lamp or the sky.
inline bool canBeMet(const LightTable& lights) {
    return !lights.index().emitters().empty() || lights.probability(lights.environmentLight()) > 0.0;
}

/// Radiance of the lamp that a ray met, or of the sky (no hit): the share that the ray may count.
inline Rgb lightMet(const LightWays& ways, const LightTable& lights, const Ray& ray, const Hit& hit) {
    const SegmentIndex& index = lights.index();
    const Segment* wall = hit ? &index.scene().segments[hit.segment] : nullptr;
    if (wall && !(hit.front || wall->twoSided)) return Rgb(0.0);
    const Rgb radiance = wall ? wall->emission : index.environment(ray.direction);
    return radiance == Rgb(0.0) ? radiance : radiance * weightMet(ways, lights, ray, hit);
}

/// Whether asking a light can bring anything: not where rays find all light by themselves, so that no shadow
/// ray is cast for nothing.
inline bool asksLights(const LightWays& ways, const LightTable& lights) {
    return ways.emitters != Emitters::hit || !lights.index().scene().lights.empty();
}

/// A light that was asked, and what it brings: its share.
struct AskedLight {
    DrawnLight light;
    double share = 1.0;
    Rgb value{0.0};
};

/// Radiance that the scattering wall sends back of one drawn light.
inline AskedLight askLight(const LightWays& ways, const LightTable& lights, const Arrival& here,
                           const Rng& rng, Counts& counts) {
    if (!asksLights(ways, lights)) return {};
    const DrawnLight light = drawLight(lights, here.at, rng.uniform(here.vertex, draws::kPick),
                                       rng.uniform(here.vertex, draws::kLight), counts);
    if (light.L_i == Rgb(0.0)) return {light};
    const double share =
        weightDrawn(ways, light, pdfSurface(here.at, here.at.from, light.L, ways.directions));
    return {light, share,
            evalSurface(here.at, light.L, here.at.from) * light.L_i * (glm::dot(here.at.N, light.L) * share)};
}

/// What a receiver that gathers gets of one drawn light.
inline AskedLight askLight(const LightWays& ways, const LightTable& lights, const Receiver& receiver,
                           const Rng& rng, Counts& counts) {
    if (!asksLights(ways, lights)) return {};
    const DrawnLight light = drawLight(lights, receiver, rng.uniform(draws::kStart, draws::kPick),
                                       rng.uniform(draws::kStart, draws::kLight), counts);
    if (light.L_i == Rgb(0.0)) return {light};
    const double share = weightDrawn(ways, light, pdfSight(receiver, light.L));
    return {light, share, light.L_i * (responseTo(receiver, light.L).weight * share)};
}

}  // namespace halfdisk
