// Rows of lights: a lamp all but in the plane of the wall it lights, and lights that touch it.
#include <algorithm>

#include "core/estimate.h"
#include "core/exact.h"
#include "core/extremes/furnace.h"
#include "core/extremes/naive_lamp.h"
#include "core/extremes/rows.h"

namespace halfdisk {
namespace {

/// A floor from (0, 0) to (1, 0) and a lamp. P is on the floor.
Scene floorAndLamp(Vec2 a, Vec2 b) {
    Scene scene = furnaceOf({{0.0, 0.0}, {1.0, 0.0}}, 0.5, 0.0);
    scene.segments[1].a = a;
    scene.segments[1].b = b;
    scene.segments[1].emission = Rgb(1.0);
    return scene;
}

/// castRay itself, by both ways to find the lamp: finite, and right within 5 standard errors.
std::string faultOfSamples(const SegmentIndex& index, const ShadedPoint& at, double exact,
                           std::uint64_t& bad) {
    Settings settings;
    settings.samples = 16;
    settings.maxDepth = 0;
    settings.emitters = Emitters::both;
    const Estimate estimate = estimateIrradiance(index, at, settings, {.repeats = 2000});
    bad = estimate.nonFinite();
    const double off = std::abs(estimate.irradiance().x - exact);
    const double allowed = 5.0 * estimate.repeats.standardError().x + 1e-9 * exact;
    return off <= allowed ? std::string() : "castRay is off by " + shortText(off / exact);
}

ExtremeOutcome lampOutcome(const Scene& scene, double u, double exact) {
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    const ShadedPoint at = shadedPointOn(index, 0, u);
    ExtremeOutcome outcome;
    // Both of the product's closed forms: the visible arcs, and the formula for a segment.
    const double arcs = directIrradiance(visibility, at).x;
    const double formula = segmentIrradiance(at.P, at.N, scene.segments[1]).x;
    outcome.ours.error = std::max(std::abs(arcs - exact), std::abs(formula - exact)) / exact;
    outcome.fault = faultOfSamples(index, at, exact, outcome.ours.counts.nonFinite);
    outcome.naiveFloat.error = naiveLampError<float>(at.P, scene.segments[1], exact);
    outcome.naiveDouble.error = naiveLampError<double>(at.P, scene.segments[1], exact);
    return outcome;
}

// The lamp's upper end stands at (2, h), seen from P = (0.25, 0) at the angle h / 1.75; E is half the square
// of it. The angle is good to a few roundings: it is a quotient. So are sin and its product: 16 roundings in
// all. A difference of sines is that of two numbers next to 1, each off by a rounding: 2 h / E = 6e3 at 1e-7.
ExtremeCell planeCell(double height) {
    return {"lamp-plane:" + powerText(height),
            "a lamp that rises " + powerText(height) + " m out of the floor's plane",
            "E, relative",
            16.0 * kRounding,
            "the angle is a quotient, and E a product of sines: no difference of nearly equal numbers",
            [height](const StopQuestion&) {
                const long double slope = static_cast<long double>(height) / 1.75L;
                const double exact = static_cast<double>(-std::expm1(-0.5L * std::log1p(slope * slope)));
                return lampOutcome(floorAndLamp({1.5, 0.0}, {2.0, height}), 0.25, exact);
            }};
}

// The lamp stands on the floor at x = 0.5. P.x and 0.5 - P.x are exact (Sterbenz); E = 1 - d / sqrt(d^2 +
// 1/4).
ExtremeCell touchingCell(double distance) {
    return {"lamp-touch:" + powerText(distance),
            "a lamp that stands on the floor, seen from " + powerText(distance) + " m away",
            "E, relative",
            16.0 * kRounding,
            "angles are quotients, good to a few roundings",
            [distance](const StopQuestion&) {
                const double u = 0.5 - distance;
                const long double d = 0.5L - u;
                const double exact = static_cast<double>(1.0L - d / std::sqrt(d * d + 0.25L));
                return lampOutcome(floorAndLamp({0.5, 0.0}, {0.5, 0.5}), u, exact);
            }};
}

/// I / r of the naive twin; the bulb right above P.
template <class Real>
ExtremeSide naiveBulb(double distance) {
    const Real r = static_cast<Real>(distance), cosine = r / r;
    const double E = static_cast<double>(cosine / r), exact = distance > 0.0 ? 1.0 / distance : 0.0;
    ExtremeSide side;
    if (!std::isfinite(E)) side.counts.nonFinite = 1;
    side.error = distance > 0.0 ? std::abs(E - exact) / exact : E;
    return side;
}

ExtremeCell bulbCell(double distance) {
    return {
        "bulb-touch:" + (distance > 0.0 ? powerText(distance) : std::string("0")),
        distance > 0.0 ? "a point light " + powerText(distance) + " m above the wall"
                       : std::string("a point light on the wall, at P itself"),
        "E, relative",
        distance > 0.0 ? 8.0 * kRounding : 0.0,
        distance > 0.0 ? "a length, a quotient and a cosine"
                       : "the light has no direction there: it brings nothing, and surely not NaN",
        [distance](const StopQuestion&) {
            Scene scene = furnaceOf({{0.0, 0.0}, {1.0, 0.0}}, 0.5, 0.0);
            scene.segments.resize(1);
            scene.segmentNames.resize(1);
            scene.lights.emplace_back(PointLight{{0.5, distance}, Rgb(1.0)});
            const SegmentIndex index(scene);
            const ShadedPoint at = shadedPointOn(index, 0, 0.5);
            const Estimate estimate = estimateIrradiance(index, at, Settings{});
            const double exact = distance > 0.0 ? 1.0 / distance : 0.0;
            ExtremeOutcome outcome;
            const double off = std::abs(estimate.irradiance().x - exact);
            outcome.ours.error = exact > 0.0 ? off / exact : off;
            outcome.ours.counts.nonFinite = estimate.nonFinite();
            outcome.naiveFloat = naiveBulb<float>(distance);
            outcome.naiveDouble = naiveBulb<double>(distance);
            if (distance == 0.0)
                outcome.words =
                    "E has no finite value there: as the bulb comes down, half of its light falls on that "
                    "one point, and none on the rest of the wall; the product leaves it out";
            return outcome;
        }};
}

}  // namespace

void addLightRows(std::vector<ExtremeCell>& cells) {
    for (const double height : {1e-3, 1e-5, 1e-7}) cells.push_back(planeCell(height));
    for (const double distance : {1e-3, 1e-5, 1e-7}) cells.push_back(touchingCell(distance));
    for (const double distance : {1e-3, 1e-7, 0.0}) cells.push_back(bulbCell(distance));
}

}  // namespace halfdisk
