// What does one turn of a dial do to a ray tracer? A scene placed anywhere, in float or double, with any
// way to keep rays off their own wall: the counters for it, in the time of one frame.
#pragma once

#include "core/extremes/survey.h"

namespace halfdisk {

struct DialSetting {
    double scale = 1.0;   ///< 1e-6 ... 1e6
    double offset = 0.0;  ///< sizes of the scene, 0 ... 1e5
    double gap = 0.0;     ///< between two walls that face each other, in sizes of the scene; 0: none
    Precision precision = Precision::twice;
    EpsilonPolicy policy = EpsilonPolicy::ours;
    double fixedEpsilon = 1e-4;  ///< m, of EpsilonPolicy::fixed
    std::uint64_t rays = 4000;   ///< at most; fewer where walls are many
    std::uint64_t seed = 1;
    bool operator==(const DialSetting&) const = default;
};

/// Counts of rays from all walls, and some of those that go wrong. In double with the bounded policy it is
/// the product itself that is asked. No rays where there is no wall. At most 2e5 walls tried for the truth,
/// so that it takes some milliseconds. Throws Stopped; std::invalid_argument for a scene that no index takes.
ExtremeCounts measureDial(const DialSetting& setting, const Scene& scene, const StopQuestion& stop = {});

/// The scene with two walls that face each other in its middle, `gap` sizes of the scene apart.
Scene withSlit(const Scene& scene, double gap);

}  // namespace halfdisk
