// What is a room in which every path has the same value? The white furnace: all walls emit 1 and reflect the
// same, so whatever way a path takes, after D bounces it has gathered 1 + a + ... + a^D. There is no noise:
// all that is missing was lost to a leak, a self-hit or rounding.
#pragma once

#include "core/extremes/cell.h"

namespace halfdisk {

/// Closed polygon (counter-clockwise) of one matt material, all emitting.
Scene furnaceOf(const std::vector<Vec2>& points, double albedo, double emission = 1.0);

/// Not convex, walls askew: the room of most rows. About 3.5 m by 2.9 m.
std::vector<Vec2> furnacePolygon();

struct FurnaceQuestion {
    double albedo = 0.7, emission = 1.0;
    std::uint32_t depth = 5;
    std::uint64_t paths = 1200;  ///< from all walls in turn, or from the first `walls`
    std::uint32_t walls = 0xFFFFFFFF;
};

/// Greatest relative error of the irradiance that the estimator `path` finds on any wall.
double furnaceError(const Scene& furnace, const FurnaceQuestion& question, const StopQuestion& stop = {});

/// The same of the naive twin, which adds up in its own number type.
double naiveFurnaceError(const Scene& furnace, const FurnaceQuestion& question, Precision precision,
                         EpsilonPolicy policy = EpsilonPolicy::fixed, const StopQuestion& stop = {});

/// All three: errors in the placed furnace, and counts of rays from its walls.
ExtremeOutcome furnaceOutcome(const Scene& furnace, const Placement& placement,
                              const FurnaceQuestion& question, const SurveyRays& rays,
                              const StopQuestion& stop);

/// What rounding may add up to: see the definition.
double furnaceBound(std::uint32_t depth);

}  // namespace halfdisk
