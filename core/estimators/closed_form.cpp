// Estimator `closed-form`: direct light by formula, where nothing stands in its way. Everywhere else it
// refuses.
#include <cstdio>
#include <limits>

#include "core/estimators/all.h"
#include "core/estimators/one_place.h"
#include "core/unoccluded.h"
#include "core/wall_kind.h"

namespace halfdisk {
namespace {

/// Places of a pixel that are tried beforehand: both draws of Receivers, and the one of sightFrom.
struct Place {
    double u, v, look;
};
constexpr double kEdge = 1e-9;  // a pixel's ends belong to its neighbours too
constexpr std::array kAlong{Place{0.5, 0.5, 0.5}, Place{kEdge, 0.5, kEdge},
                            Place{1.0 - kEdge, 0.5, 1.0 - kEdge}, Place{0.25, 0.5, 0.25},
                            Place{0.75, 0.5, 0.75}};
constexpr std::array kOverCell{Place{0.5, 0.5, 0.5}, Place{kEdge, kEdge, 0.5}, Place{1.0 - kEdge, kEdge, 0.5},
                               Place{kEdge, 1.0 - kEdge, 0.5}, Place{1.0 - kEdge, 1.0 - kEdge, 0.5}};

/// Where the closed forms hold. A place that is drawn later and turns out to be hidden has no value: the film
/// counts it as not finite.
class UnoccludedLight {
 public:
    UnoccludedLight(const SegmentIndex& index, const StopQuestion& stop) : visibility_(index, stop) {}

    Rgb irradiance(const ShadedPoint& at, Counts& counts, ArcMemory& memory) const {
        counts.rays += visibility_.corners().size();
        if (obstacleAt(visibility_, at, memory)) return none();
        return unoccludedIrradiance(visibility_.index(), at);
    }
    Rgb fluence(Vec2 P, Counts& counts, ArcMemory& memory) const {
        counts.rays += visibility_.corners().size();
        if (obstacleAround(visibility_, P, memory)) return none();
        return unoccludedFluence(visibility_.index(), P);
    }
    const Visibility& visibility() const { return visibility_; }

 private:
    static Rgb none() { return Rgb(std::numeric_limits<double>::quiet_NaN()); }

    Visibility visibility_;
};

class ClosedFormEstimator : public Estimator {
 public:
    explicit ClosedFormEstimator(const Problem& problem)
        : problem_(problem), receivers_(problem.sensor, problem.index), light_(problem.index, problem.stop) {}

    void addPass(std::uint64_t pass, Picture& picture, Counts& counts) const override {
        addPlaces(light_, problem_, receivers_, pass, picture, counts);
    }

 private:
    Problem problem_;
    Receivers receivers_;
    UnoccludedLight light_;
};

std::string textOf(Vec2 P) {
    char text[64];
    std::snprintf(text, sizeof text, "(%.6g, %.6g)", P.x, P.y);
    return text;
}

std::string behind(const Scene& scene, const std::optional<Obstacle>& obstacle, Vec2 P) {
    if (!obstacle) return {};
    return quotedName(scene, obstacle->wall) + " hides a part of " + obstacle->hides + " from " + textOf(P);
}

/// Empty, or why the closed forms do not hold for this receiver.
std::string faultAt(const Visibility& visibility, const Receiver& receiver, double look, ArcMemory& memory) {
    const SegmentIndex& index = visibility.index();
    const Scene& scene = index.scene();
    if (receiver.covered) return {};
    if (receiver.at.medium != kNoMedium) return textOf(receiver.at.P) + " lies in glass";
    if (receiver.weighing == Weighing::cosine)
        return behind(scene, obstacleAt(visibility, receiver.at, memory), receiver.at.P);
    if (receiver.weighing == Weighing::even)
        return behind(scene, obstacleAround(visibility, receiver.at.P, memory), receiver.at.P);
    const Hit hit = index.closestHit(sightFrom(receiver, index, look).ray);
    if (!hit) return {};
    if (const std::string kind = whyNotFlatDiffuse(scene, hit.segment); !kind.empty())
        return quotedName(scene, hit.segment) + " is " + kind;
    if (!isLitSide(index, hit)) return {};
    const ShadedPoint there = shadedPointAt(index, hit);
    return there.albedo == Rgb(0.0) ? std::string()
                                    : behind(scene, obstacleAt(visibility, there, memory), there.P);
}

std::string refusal(const Problem& problem, const ParamValues&) {
    if (problem.maxDepth > 0)
        return "closed-form is direct light alone: ask for depth 0, not " + std::to_string(problem.maxDepth);
    const Visibility visibility(problem.index, problem.stop);
    const Receivers receivers(problem.sensor, problem.index);
    ArcMemory memory;
    const bool isField = std::holds_alternative<Field>(problem.sensor);
    const bool one =
        std::holds_alternative<Probe>(problem.sensor) || std::holds_alternative<Look>(problem.sensor);
    for (std::uint32_t pixel = 0; pixel < pixelCount(problem.sensor); ++pixel)
        for (const Place& place : isField ? kOverCell : kAlong) {
            throwIfStopped(problem.stop);
            const Receiver receiver = receivers.draw(pixel, place.u, place.v);
            const std::string fault = faultAt(visibility, receiver, place.look, memory);
            if (!fault.empty())
                return "closed-form is for light with nothing in its way: " + fault +
                       (one ? "" : ", in pixel " + std::to_string(pixel));
        }
    return {};
}

/// Light straight from its source, and for an eye what one diffuse wall makes of it.
std::string paths(const Scene& scene, unsigned sensor) {
    const SceneTraits traits = traitsOf(scene);
    if (!traits.delta && !traits.area) return "none: no light";
    if (!(sensor & (kEyeBit | kLookBit))) return "LE";
    return traits.scattering ? "LD?E" : "LE";
}

}  // namespace

const EstimatorInfo kClosedFormEstimator{
    .id = "closed-form",
    .title = "Closed form",
    .meaning =
        "direct light by formula, Le |sin b - sin a| of a lamp; refuses where anything hides a part of it",
    .sensors = kProbeBit | kLookBit | kEyeBit | kProfileBit | kFieldBit,
    .params = {},
    .bias = {},
    .paths = paths,
    .refusal = refusal,
    .make = [](const Problem& problem, const ParamValues&) -> std::unique_ptr<Estimator> {
        return std::make_unique<ClosedFormEstimator>(problem);
    },
};

}  // namespace halfdisk
