#include "radiosity.h"

#include <algorithm>

#include "arc_measure.h"
#include "radiosity_system.h"

namespace halfdisk {

Radiosity::Radiosity(const SegmentIndex& index, std::uint32_t patches, std::optional<std::uint32_t> bounces,
                     const StopQuestion& stop)
    : visibility_(index, stop),
      patches_(visibility_, patches, stop),
      scattered_(scatteredRadiance(visibility_, patches_, bounces, stop)) {}

// The patches that are seen within an arc, each between its own two angles.
template <class Visit>
void Radiosity::forPatches(const ShadedPoint& at, const VisibleArc& arc, const Visit& visit) const {
    const Segment& wall = index().scene().segments[arc.hit.segment];
    const Vec2 origin = rayFrom(index(), at, at.N).origin;
    const auto patchAt = [&](double theta) {
        const Vec2 direction = directionAt(at, theta);
        const double u = cross(wall.a - origin, direction) / cross(direction, wall.b - wall.a);
        return patches_.at(arc.hit.segment, arc.hit.front, std::isfinite(u) ? u : arc.hit.u);
    };
    const std::size_t first = patchAt(arc.from), last = patchAt(arc.to);
    double from = arc.from;
    for (std::size_t patch = first; patch != last; patch < last ? ++patch : --patch) {
        const double u = first < last ? patches_.all()[patch].uTo : patches_.all()[patch].uFrom;
        const double border = thetaOf(at, wall.a + u * (wall.b - wall.a) - origin);
        const double to = std::clamp(border, from, arc.to);
        visit(patch, from, to);
        from = to;
    }
    visit(last, from, arc.to);
}

template <class Measure>
Rgb Radiosity::gather(const ShadedPoint& at, const Measure& measure, Counts& counts,
                      ArcMemory& memory) const {
    const std::vector<VisibleArc>& arcs = visibility_.arcs(at, memory);
    counts.rays += arcs.size();
    Rgb sum{0.0};
    for (const VisibleArc& arc : arcs) {
        if (!arc.hit) {
            sum += index().environment(middleOf(at, arc)) * measure(arc.from, arc.to);
        } else if (isLitSide(index(), arc.hit)) {
            sum += index().scene().segments[arc.hit.segment].emission * measure(arc.from, arc.to);
            forPatches(at, arc, [&](std::size_t patch, double from, double to) {
                sum += scattered_[patch] * measure(from, to);
            });
        }
    }
    return sum;
}

Rgb Radiosity::irradiance(const ShadedPoint& at, Counts& counts) const {
    ArcMemory memory;
    return irradiance(at, counts, memory);
}

Rgb Radiosity::fluence(Vec2 P, Counts& counts) const {
    ArcMemory memory;
    return fluence(P, counts, memory);
}

Rgb Radiosity::irradiance(const ShadedPoint& at, Counts& counts, ArcMemory& memory) const {
    counts.rays += index().scene().lights.size();
    return deltaIrradiance(index(), at) + gather(at, cosineBetween, counts, memory);
}

Rgb Radiosity::fluence(Vec2 P, Counts& counts, ArcMemory& memory) const {
    counts.rays += index().scene().lights.size();
    Rgb sum = deltaFluence(index(), P);
    for (const Vec2 N : {Vec2(0.0, 1.0), Vec2(0.0, -1.0)})
        sum += gather(
            {P, N}, [](double from, double to) { return to - from; }, counts, memory);
    return sum;
}

}  // namespace halfdisk
