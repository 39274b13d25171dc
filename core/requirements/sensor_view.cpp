#include "core/requirements/sensor_view.h"

#include "core/arc_measure.h"
#include "core/surface.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kPlaces = 1024;

/// Numbers that fill the cube (0, 1)^3 evenly, however many of them are taken (Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences": powers of the root of x^4 = x + 1).
double evenly(std::uint32_t k, int dimension) {
    constexpr double kRoot = 1.2207440846057596;
    double whole = 0.0;
    return std::modf(0.5 + (k + 1.0) / std::pow(kRoot, dimension + 1), &whole);
}

Rgb straightRadiance(const SegmentIndex& index, const Hit& hit, Vec2 direction) {
    if (!hit) return index.environment(direction);
    return isLitSide(index, hit) ? index.scene().segments[hit.segment].emission : Rgb(0.0);
}

Rgb directFluence(const Visibility& visibility, Vec2 P) {
    Rgb sum = deltaFluence(visibility.index(), P);
    for (const Vec2 N : {Vec2(0.0, 1.0), Vec2(0.0, -1.0)}) {
        const ShadedPoint half{P, N};
        for (const VisibleArc& arc : visibility.arcs(half))
            sum += (arc.to - arc.from) * straightRadiance(visibility.index(), arc.hit, middleOf(half, arc));
    }
    return sum;
}

}  // namespace

SensorView viewOf(const Sensor& sensor, const Visibility& visibility, const Patches& patches,
                  const std::vector<Rgb>& direct, const StopQuestion& stop) {
    const SegmentIndex& index = visibility.index();
    const std::uint64_t pixels = pixelCount(sensor);
    const Receivers receivers(sensor, index);
    const Rgb none(0.0);
    SensorView view{none, std::vector<Rgb>(patches.size(), none), std::vector<Rgb>(patches.size(), none)};
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
        throwIfStopped(stop, k);
        const auto pixel = static_cast<std::uint32_t>(k * pixels / kPlaces);
        const Receiver receiver = receivers.draw(pixel, evenly(k, 0), evenly(k, 1));
        if (receiver.covered) continue;
        const ShadedPoint& at = receiver.at;
        const bool front = at.segment == kNoSegment || glm::dot(at.N, index.normal(at.segment)) > 0.0;
        const bool onWall = receiver.weighing == Weighing::cosine && at.segment != kNoSegment &&
                            (front || index.scene().segments[at.segment].twoSided);
        if (gathers(receiver))
            view.straight += receiver.weighing == Weighing::even ? directFluence(visibility, at.P)
                                                                 : directIrradiance(visibility, at);
        if (onWall) {
            const Segment& wall = index.scene().segments[at.segment];
            const Vec2 along = wall.b - wall.a;
            const double u = std::clamp(glm::dot(at.P - wall.a, along) / glm::dot(along, along), 0.0, 1.0);
            view.now[patches.at(at.segment, front, u)] += Rgb(1.0);
            continue;
        }
        const Sight sight = sightFrom(receiver, index, evenly(k, 2));
        const Hit hit = index.closestHit(sight.ray);
        if (!gathers(receiver)) view.straight += straightRadiance(index, hit, sight.ray.direction);
        if (!hit || !isLitSide(index, hit)) continue;
        const std::size_t patch = patches.at(hit.segment, hit.front, hit.u);
        const Rgb scattered = sight.weight / 2.0 * std::get<Diffuse>(index.material(hit.segment)).albedo;
        if (gathers(receiver)) {
            view.later[patch] += scattered;
        } else {
            view.now[patch] += scattered;
            view.straight += scattered * direct[patch];
        }
    }
    return view;
}

}  // namespace halfdisk
