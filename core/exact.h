// What is the exact answer, where one is known? Closed forms and quadrature to hold estimates against.
#pragma once

#include <vector>

#include "stop.h"
#include "tracing.h"

namespace halfdisk {

/// Irradiance (W/m) at P, normal N, from an unoccluded Lambertian segment of radiance Le: the difference of
/// sines Le |sin beta - sin alpha| of its ends' angles from N, clipped to the half-disk. 0 behind a one-sided
/// segment.
Rgb segmentIrradiance(Vec2 P, Vec2 N, const Segment& segment);

/// Radiance (W/(m rad)) everywhere in a closed room whose walls all emit Le and reflect `albedo`, with light
/// scattered at most `depth` times: Le (1 - albedo^(depth+1)) / (1 - albedo). kAnyDepth: without limit.
inline constexpr int kAnyDepth = -1;
double closedRoomRadiance(double Le, double albedo, int depth);

/// A stretch of the half-disk in which one thing is seen.
struct VisibleArc {
    double from, to;  ///< rad from the tangent, 0 <= from < to <= pi
    Hit hit;          ///< of the ray through its middle; none: the environment
};

/// What is seen from one place, and memory for the next one.
struct ArcMemory {
    std::vector<double> cuts;
    std::vector<VisibleArc> arcs;
};

/// Where visibility can change: the ends of walls and the points where walls cross. Keeps a pointer to the
/// index.
class Visibility {
 public:
    /// See cornersOf for the time that it takes. Throws Stopped if `stop` says so.
    explicit Visibility(const SegmentIndex& index, const StopQuestion& stop = {});

    /// What `at` sees over its half-disk, in order of theta; nothing where it is covered (cover.h). O(n)
    /// rays.
    std::vector<VisibleArc> arcs(const ShadedPoint& at) const;
    /// The same, in memory.arcs.
    const std::vector<VisibleArc>& arcs(const ShadedPoint& at, ArcMemory& memory) const;

    const SegmentIndex& index() const { return *index_; }
    const std::vector<Vec2>& corners() const { return corners_; }

 private:
    const SegmentIndex* index_;
    std::vector<Vec2> corners_;
    std::vector<Vec2> skyEdges_;  // directions in which the environment's radiance jumps
};

/// Irradiance (W/m) that was never scattered. Exact with occlusion: delta lights by their shadow rays,
/// emitting walls and the environment as sums of L (cos from - cos to) over the visible arcs.
Rgb directIrradiance(const Visibility& visibility, const ShadedPoint& at);

/// Of which the delta lights' part alone.
Rgb deltaIrradiance(const SegmentIndex& index, const ShadedPoint& at);

/// Radiance that arrives at `at` along theta (rad from the tangent), scattered at most `depth` times on its
/// way: 0 or 1.
Rgb arrivingRadiance(const Visibility& visibility, const ShadedPoint& at, double theta, int depth);

/// Expectation of E (W/m), and variance of the estimate of it by one sample.
struct ExactEstimate {
    Rgb mean{0.0};
    Rgb variance{0.0};
};

/// One half-disk sample (uniform or cosine, emitters = hit) of the light that was scattered at most `depth`
/// times (0 or 1) before it arrives; delta lights at P itself are added to the mean. Where depth is 1 the
/// radiance of the walls is taken as exact, so the variance is that of the first bounce alone. Adaptive
/// quadrature, relative error about 1e-9.
ExactEstimate halfDiskEstimate(const Visibility& visibility, const ShadedPoint& at, Sampler sampler,
                               int depth);

}  // namespace halfdisk
