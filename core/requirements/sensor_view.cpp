#include "core/requirements/sensor_view.h"

#include "core/arc_patches.h"
#include "core/nearest_wall.h"
#include "core/surface.h"

namespace halfdisk {
namespace {

/// Numbers that fill the cube (0, 1)^3 evenly, however many of them are taken (Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences": powers of the root of x^4 = x + 1).
double evenly(std::uint32_t k, int dimension) {
    constexpr double kRoot = 1.2207440846057596;
    double whole = 0.0;
    return std::modf(0.5 + (k + 1.0) / std::pow(kRoot, dimension + 1), &whole);
}

Rgb directFluence(const Visibility& visibility, Vec2 P) {
    Rgb sum = deltaFluence(visibility.index(), P);
    for (const Vec2 N : {Vec2(0.0, 1.0), Vec2(0.0, -1.0)}) {
        const ShadedPoint half{P, N};
        for (const VisibleArc& arc : visibility.arcs(half))
            sum += (arc.to - arc.from) * straightRadiance(visibility.index(), half, arc);
    }
    return sum;
}

class Viewer {
 public:
    Viewer(const Visibility& visibility, const Patches& patches, const std::vector<Rgb>& direct,
           std::uint32_t places, const StopQuestion& stop)
        : visibility_(visibility),
          index_(visibility.index()),
          patches_(patches),
          direct_(direct),
          places_(places),
          stop_(stop),
          view_{Rgb(0.0), std::vector<Rgb>(patches.size(), Rgb(0.0)),
                std::vector<Rgb>(patches.size(), Rgb(0.0))} {}

    const SensorView& view() const { return view_; }

    void seeStrip(const EyeStrip& strip) {
        const Eye& eye = strip.eye;
        const double half = eye.fov / 2.0;
        const auto place = [&](double theta) { return std::tan(kPi / 2.0 - theta) / std::tan(half); };
        seeArcs({eye.position, eye.direction}, kPi / 2.0 - half, kPi / 2.0 + half, false,
                [&](double from, double to) { return (place(from) - place(to)) / 2.0; });
    }

    void seeHalfDisk(const ShadedPoint& at) {
        view_.straight += directIrradiance(visibility_, at);
        seeArcs(at, 0.0, kPi, true, cosineBetween);
    }

    void seePlaces(const Sensor& sensor) {
        const std::uint64_t pixels = pixelCount(sensor);
        const Receivers receivers(sensor, index_);
        const double share = 1.0 / places_;
        for (std::uint32_t k = 0; k < places_; ++k) {
            throwIfStopped(stop_, k);
            const auto pixel = static_cast<std::uint32_t>(k * pixels / places_);
            const Receiver receiver = receivers.draw(pixel, evenly(k, 0), evenly(k, 1));
            if (receiver.covered) continue;
            if (receiver.weighing == Weighing::cosine)
                view_.straight += share * directIrradiance(visibility_, receiver.at);
            if (receiver.weighing == Weighing::even)
                view_.straight += share * directFluence(visibility_, receiver.at.P);
            if (const auto patch = patchAt(receiver.at)) {
                view_.now[*patch] += Rgb(share);
                continue;
            }
            const Sight sight = sightFrom(receiver, index_, evenly(k, 2));
            see(sight.ray, share * sight.weight, gathers(receiver));
        }
    }

 private:
    /// That it lies on; none for a free point or a wall's dark back.
    std::optional<std::size_t> patchAt(const ShadedPoint& at) const {
        if (at.segment == kNoSegment) return std::nullopt;
        const Segment& wall = index_.scene().segments[at.segment];
        const bool front = glm::dot(at.N, index_.normal(at.segment)) > 0.0;
        if (!front && !wall.twoSided) return std::nullopt;
        return patches_.at(at.segment, front, nearestOnStretch(wall.a, wall.b, at.P).t);
    }

    /// All that is seen, however narrow. `measure`: how much radiance between two angles counts.
    template <class Measure>
    void seeArcs(const ShadedPoint& at, double least, double most, bool gathered, const Measure& measure) {
        for (VisibleArc arc : visibility_.arcs(at)) {
            throwIfStopped(stop_);
            arc.from = std::max(least, arc.from);
            arc.to = std::min(most, arc.to);
            if (!(arc.from < arc.to)) continue;
            if (!gathered) view_.straight += measure(arc.from, arc.to) * straightRadiance(index_, at, arc);
            forPatches(index_, patches_, at, arc, [&](std::size_t patch, double from, double to) {
                seePatch(patch, measure(from, to), gathered);
            });
        }
    }

    /// `gathered`: what comes straight from a source is known already, and what a wall sends has been
    /// scattered once more.
    void see(const Ray& ray, double weight, bool gathered) {
        const Hit hit = index_.closestHit(ray);
        if (!gathered) view_.straight += weight * straightRadiance(index_, hit, ray.direction);
        if (hit && isLitSide(index_, hit))
            seePatch(patches_.at(hit.segment, hit.front, hit.u), weight, gathered);
    }

    void seePatch(std::size_t patch, double weight, bool gathered) {
        const Rgb scattered =
            weight / 2.0 * std::get<Diffuse>(index_.material(patches_.all()[patch].segment)).albedo;
        (gathered ? view_.later : view_.now)[patch] += scattered;
        // The patch's mean: few places would meet a narrow beam, or too many.
        if (!gathered) view_.straight += scattered * direct_[patch];
    }

    const Visibility& visibility_;
    const SegmentIndex& index_;
    const Patches& patches_;
    const std::vector<Rgb>& direct_;
    std::uint32_t places_;
    const StopQuestion& stop_;
    SensorView view_;
};

}  // namespace

SensorView viewOf(const Sensor& sensor, const Visibility& visibility, const Patches& patches,
                  const std::vector<Rgb>& direct, std::uint32_t places, const StopQuestion& stop) {
    Viewer viewer(visibility, patches, direct, places, stop);
    const auto* probe = std::get_if<Probe>(&sensor);
    if (const auto* strip = std::get_if<EyeStrip>(&sensor))
        viewer.seeStrip(*strip);
    else if (probe)
        viewer.seeHalfDisk(probe->at);
    else
        viewer.seePlaces(sensor);
    return viewer.view();
}

}  // namespace halfdisk
