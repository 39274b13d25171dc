// Where do rays go wrong? Each is asked of a tracer and of the truth in long double, and what differs is
// counted.
#pragma once

#include <cstdint>
#include <vector>

#include "core/extremes/naive_room.h"
#include "core/extremes/placement.h"
#include "core/intersect.h"
#include "core/stop.h"

namespace halfdisk {

/// A ray that went wrong, where the scene was before it was put elsewhere (m).
struct LostRay {
    enum class How : std::uint8_t { leak, selfHit, nonFinite };
    How how = How::leak;
    Vec2 from{0.0},
        to{0.0};  ///< where it starts, and what it truly meets; in the open a size of the scene away
};

struct ExtremeCounts {
    std::uint64_t rays = 0;
    std::uint64_t leaks = 0;      ///< met nothing, a wall's back, or something beyond the wall that is there
    std::uint64_t selfHits = 0;   ///< met the straight wall that they leave
    std::uint64_t nonFinite = 0;  ///< NaN or infinity where there is a number
    std::uint64_t early = 0;  ///< met a wall that the true ray passes; no fault: next to an edge a rounding
                              ///< decides
    double place = 0.0;       ///< of the others, how far at most they pass beside the true hit, in sizes
                              ///< of the scene (off along a wall that they meet at a slant, they are more)
    double light = 0.0;       ///< relative error of the light seen by all rays together

    std::vector<LostRay> lost{};  ///< the first of them: see SurveyRays::kept

    std::uint64_t faults() const { return leaks + selfHits + nonFinite; }
    /// Of the rays, 0 ... 1.
    double lostShare() const {
        return rays > 0 ? static_cast<double>(faults()) / static_cast<double>(rays) : 0.0;
    }
    void merge(const ExtremeCounts& other);
};

/// By which rays a tracer is tried.
struct SurveyRays {
    std::uint64_t count = 20'000;
    std::uint64_t seed = 1;
    double theta = 0.0;                ///< rad from the wall, all of them (either way); 0: all angles
    bool ends = true;                  ///< one in eight starts next to an end of its wall
    std::uint32_t walls = 0xFFFFFFFF;  ///< they start at the first so many
    std::size_t kept = 0;              ///< so many that go wrong are kept, of each way to go wrong
};

/// The product's own: SegmentIndex and rayFrom. The scene is surveyed where `placement` puts it.
ExtremeCounts surveyOurs(const Scene& scene, const Placement& placement, const SurveyRays& rays,
                         const StopQuestion& stop = {});

/// The naive twin. A wall that its number type gives no length counts as non-finite whenever it is left.
ExtremeCounts surveyNaive(const Scene& scene, const Placement& placement, const SurveyRays& rays,
                          Precision precision, EpsilonPolicy policy, double fixedEpsilon = 1e-4,
                          const StopQuestion& stop = {});

}  // namespace halfdisk
