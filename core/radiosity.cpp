#include "radiosity.h"

#include "arc_patches.h"
#include "radiosity_system.h"

namespace halfdisk {

Radiosity::Radiosity(const SegmentIndex& index, std::uint32_t patches, std::optional<std::uint32_t> bounces,
                     const StopQuestion& stop)
    : visibility_(index, stop),
      patches_(visibility_, patches, stop),
      scattered_(scatteredRadiance(visibility_, patches_, bounces, stop)) {}

template <class Measure>
Rgb Radiosity::gather(const ShadedPoint& at, const Measure& measure, Counts& counts,
                      ArcMemory& memory) const {
    const std::vector<VisibleArc>& arcs = visibility_.arcs(at, memory);
    counts.rays += arcs.size();
    Rgb sum{0.0};
    for (const VisibleArc& arc : arcs) {
        sum += straightRadiance(index(), at, arc) * measure(arc.from, arc.to);
        forPatches(index(), patches_, at, arc, [&](std::size_t patch, double from, double to) {
            sum += scattered_[patch] * measure(from, to);
        });
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
