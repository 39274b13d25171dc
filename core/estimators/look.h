// What is seen along a ray, straight or through mirrors and glass? The step by which estimators that know the
// light on scattering walls from elsewhere look at it.
#pragma once

#include "core/path_recorder.h"

namespace halfdisk {

/// How a look counts the lamps and the sky that it meets.
struct Looking {
    const LightTable& lights;
    LightWays ways{};                ///< how it shares what it meets straight
    bool bySpeculars = true;         ///< whether those count that mirrors and glass show
    std::uint32_t mostSpecular = 0;  ///< mirror and glass events in a row
};

/// Walks up to the first wall that scatters what it reflects; mirrors' parts of mixed walls are followed.
/// `Outgoing` gives the radiance that such a wall sends back (its emission apart): Rgb(const Arrival&).
template <class Outgoing>
struct LookVisitor : WalkVisitor {
    const Looking& how;
    const Outgoing& outgoing;
    PathRecorder* see;  // may be null
    Rgb found{0.0};

    LookVisitor(const Looking& counting, const Outgoing& ofWall, PathRecorder* observer)
        : how(counting), outgoing(ofWall), see(observer) {}

    // [listing]
    void meet(const Ray& ray, const Hit& hit, const Rgb& throughput) {
        if (!how.bySpeculars && ray.speculars > 0) return;
        const Rgb light = throughput * lightMet(how.ways, how.lights, ray, hit);
        found += light;
        if (see && light != Rgb(0.0)) see->met(ray, hit, weightMet(how.ways, how.lights, ray, hit), light);
    }

    void escape(const Ray& ray, const Rgb& throughput, std::uint32_t) { meet(ray, {}, throughput); }

    bool arrive(const Arrival& here) {
        meet(here.ray, here.hit, here.throughput);
        if (!isSpecular(*here.at.material)) found += here.throughput * outgoing(here);
        return true;
    }
    // [end]
};

/// `throughput` times the radiance that arrives along `ray`. `see` may be null.
template <class Outgoing>
Rgb look(const Looking& how, const Ray& ray, const Rgb& throughput, const Rng& rng, Counts& counts,
         const Outgoing& outgoing, PathRecorder* see = nullptr) {
    LookVisitor<Outgoing> visitor(how, outgoing, see);
    Watched watched{visitor, see};
    const WalkLimits limits{.scatterings = 0, .speculars = how.mostSpecular};
    walk(how.lights.index(), ray, throughput, Carried::radiance, limits, rng, counts, watched);
    return visitor.found;
}

}  // namespace halfdisk
