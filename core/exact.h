// What is the exact answer, where one is known? Closed forms and quadrature to hold estimates against.
#pragma once

#include <vector>

#include "tracing.h"

namespace halfdisk {

/// Irradiance (W/m) at P, normal N, from an unoccluded one-sided Lambertian segment of radiance Le: the difference of sines
/// Le |sin beta - sin alpha| of its ends' angles from N, clipped to the half-disk. 0 behind the segment.
Rgb segmentIrradiance(Vec2 P, Vec2 N, const Segment& segment);

/// Radiance (W/(m rad)) everywhere in a closed room whose walls all emit Le and reflect albedo, with light scattered at most
/// `depth` times; depth < 0: any number of times. Le (1 - albedo^(depth+1)) / (1 - albedo).
double closedRoomRadiance(double Le, double albedo, int depth);

/// A stretch of the half-disk in which one thing is seen.
struct VisibleArc {
    double from, to;        ///< rad from the tangent, 0 <= from < to <= pi
    std::uint32_t segment;  ///< kNoSegment: the environment
    bool litSide;           ///< the side seen scatters and emits
};

/// What P sees over its half-disk, in order of theta. The arcs end where a wall's end is seen or where two walls cross, so
/// every edge of visibility is one of them. O(n^2) rays and cuts for n walls.
std::vector<VisibleArc> visibleArcs(const SegmentIndex& index, const ShadedPoint& at);

/// Irradiance (W/m) that was never scattered: delta lights by their shadow rays, emitting walls and the environment as sums of
/// L (cos from - cos to) over the visible arcs. Exact with occlusion.
Rgb directIrradiance(const SegmentIndex& index, const ShadedPoint& at);

/// Radiance that arrives along theta (from the tangent): L of the wall seen, with light scattered at most `depth` times on its
/// way there (depth 0 or 1), or the environment.
Rgb arrivingRadiance(const SegmentIndex& index, const ShadedPoint& at, double theta, int depth);

/// Expectation of E (W/m), and variance of the estimate of it from one sample.
struct ExactEstimate {
    Rgb mean{0.0};
    Rgb variance{0.0};
    double error = 0.0;  ///< bound on the quadrature's own error in either, estimated by halving its panels
};

/// One half-disk sample of what arrives over the half-disk by emitters = hit (delta lights add their exact constant), where
/// walls show light scattered at most `depth` times (0 or 1). By Gauss-Legendre quadrature between the edges of visibility
/// and of the shadows of delta lights. `sampler` uniform or cosine; a stratified sample has uniform's mean and variance when
/// its slice is drawn at random.
ExactEstimate halfDiskEstimate(const SegmentIndex& index, const ShadedPoint& at, Sampler sampler, int depth);

}  // namespace halfdisk
