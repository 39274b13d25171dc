// Which patches are seen within an arc, and which light comes along it straight from its source?
#pragma once

#include <algorithm>

#include "arc_measure.h"
#include "patches.h"

namespace halfdisk {

/// Radiance (W/(m rad)) that the wall that is met, or the environment, sends of its own.
inline Rgb straightRadiance(const SegmentIndex& index, const Hit& hit, Vec2 direction) {
    if (!hit) return index.environment(direction);
    return isLitSide(index, hit) ? index.scene().segments[hit.segment].emission : Rgb(0.0);
}

/// The same of an arc's wall.
inline Rgb straightRadiance(const SegmentIndex& index, const ShadedPoint& at, const VisibleArc& arc) {
    return straightRadiance(index, arc.hit, middleOf(at, arc));
}

/// Calls visit(patch, from, to) for each patch, exactly between its own two angles; for none on a dark side.
template <class Visit>
void forPatches(const SegmentIndex& index, const Patches& patches, const ShadedPoint& at,
                const VisibleArc& arc, const Visit& visit) {
    if (!arc.hit || !isLitSide(index, arc.hit)) return;
    const Segment& wall = index.scene().segments[arc.hit.segment];
    const Vec2 origin = rayFrom(index, at, at.N).origin;
    const auto patchAt = [&](double theta) {
        const Vec2 direction = directionAt(at, theta);
        const double u = cross(wall.a - origin, direction) / cross(direction, wall.b - wall.a);
        return patches.at(arc.hit.segment, arc.hit.front, std::isfinite(u) ? u : arc.hit.u);
    };
    const std::size_t first = patchAt(arc.from), last = patchAt(arc.to);
    double from = arc.from;
    for (std::size_t patch = first; patch != last; patch < last ? ++patch : --patch) {
        const double u = first < last ? patches.all()[patch].uTo : patches.all()[patch].uFrom;
        const double border = thetaOf(at, wall.a + u * (wall.b - wall.a) - origin);
        const double to = std::clamp(border, from, arc.to);
        visit(patch, from, to);
        from = to;
    }
    visit(last, from, arc.to);
}

}  // namespace halfdisk
