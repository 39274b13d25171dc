// Rows of scale and offset: the same room in a matchbox and on a map, at home and far away.
#include <algorithm>

#include "core/estimate.h"
#include "core/exact.h"
#include "core/extremes/furnace.h"
#include "core/extremes/naive_lamp.h"
#include "core/extremes/rows.h"

namespace halfdisk {
namespace {

constexpr const char* kFurnaceWhy =
    "(4 D + 16) / 2 roundings for D bounces; one lost ray of 1200 would be 1e-5 and more";

/// How well hits are placed, and what the product's own method would make of floats.
std::string placeWords(const Scene& furnace, const Placement& placement, const ExtremeCounts& ours,
                       const StopQuestion& stop) {
    if (placement.offset == 0.0) return {};
    const ExtremeCounts single =
        surveyNaive(furnace, placement, {}, Precision::single, EpsilonPolicy::ours, 1e-4, stop);
    return "rays pass the true hit by up to " + shortText(ours.place) +
           " of the room; in float, by the same method, " + shortText(single.place) + ", and " +
           std::to_string(single.leaks) + " leak: the product decides in double";
}

ExtremeCell furnaceCell(std::string id, std::string title, Placement placement) {
    return {std::move(id),
            std::move(title),
            "E, relative",
            furnaceBound(FurnaceQuestion{}.depth),
            kFurnaceWhy,
            [placement](const StopQuestion& stop) {
                const Scene furnace = furnaceOf(furnacePolygon(), FurnaceQuestion{}.albedo);
                ExtremeOutcome outcome = furnaceOutcome(furnace, placement, {}, {}, stop);
                outcome.words = placeWords(furnace, placement, outcome.ours.counts, stop);
                return outcome;
            }};
}

/// So many walls that single precision proposes those which double precision then decides on (core/index).
ExtremeCell manyWallsCell(std::string id, std::string title, Placement placement) {
    return {std::move(id),
            std::move(title),
            "E, relative",
            furnaceBound(FurnaceQuestion{}.depth),
            kFurnaceWhy,
            [placement](const StopQuestion& stop) {
                constexpr int kWalls = 1000;
                std::vector<Vec2> points;
                for (int k = 0; k < kWalls; ++k)
                    points.emplace_back(std::cos(2.0 * kPi * k / kWalls), std::sin(2.0 * kPi * k / kWalls));
                FurnaceQuestion question;
                question.walls = 4;
                SurveyRays rays;
                rays.count = 8 * kWalls;
                return furnaceOutcome(furnaceOf(points, question.albedo), placement, question, rays, stop);
            }};
}

/// A lamp of 1 m, 1 m above a floor of 4 m; P is 0.7 m beside its middle.
Scene lampOverFloor() {
    Scene scene = furnaceOf({{-2.0, 0.0}, {2.0, 0.0}}, 0.5, 0.0);
    scene.segments[1].a = {0.5, 1.0};
    scene.segments[1].b = {-0.5, 1.0};
    scene.segments[1].emission = Rgb(1.0);
    return scene;
}
constexpr double kPlace = 0.675;  // u of P on the floor

// The ends of a scene that stands `offset` sizes s away are rounded there: every coordinate by up to h offset
// s, h = 2^-53. P, both of the lamp's ends and the shift of P off its wall make 4 such errors and 13 / 8 of
// 16 h offset s. E changes by at most 1 / r for each metre of any of them (the sine of an angle, over the
// distance r = 0.3 s): (4 + 26) h offset / 0.3, and E is 0.58.
double lampBound(double offset) {
    return (4.0 + 26.0) * kRounding * std::max(1.0, offset) / 0.3 / 0.58;
}

ExtremeCell lampCell(double offset) {
    return {"lamp-offset:" + powerText(offset),
            "a lamp over a floor, " + powerText(offset) + " scene sizes away",
            "E, relative",
            lampBound(offset),
            "coordinates are rounded to 2^-53 of the distance; E changes by 1 / r a metre",
            [offset](const StopQuestion&) {
                const Scene home = lampOverFloor(), there = placed(home, {1.0, offset});
                // atan and long double apart, the lamp's ends lie at 0.2 and 1.2 m beside P and 1 m above it.
                const double exact = static_cast<double>(1.2L / std::sqrt(1.2L * 1.2L + 1.0L) -
                                                         0.2L / std::sqrt(0.2L * 0.2L + 1.0L));
                const SegmentIndex index(there);
                const Visibility visibility(index);
                const ShadedPoint at = shadedPointOn(index, 0, kPlace);
                const double E = directIrradiance(visibility, at).x;
                ExtremeOutcome outcome;
                outcome.ours.error = std::abs(E - exact) / exact;
                outcome.naiveFloat.error = naiveLampError<float>(at.P, there.segments[1], exact);
                outcome.naiveDouble.error = naiveLampError<double>(at.P, there.segments[1], exact);
                return outcome;
            }};
}

}  // namespace

void addPlacingRows(std::vector<ExtremeCell>& cells) {
    for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6})
        cells.push_back(furnaceCell("scale:" + powerText(scale),
                                    "a closed room scaled by " + powerText(scale), {scale, 0.0}));
    for (const double offset : {1.0, 1e3, 1e5})
        cells.push_back(furnaceCell("offset:" + powerText(offset),
                                    "a closed room " + powerText(offset) + " times its size away",
                                    {1.0, offset}));
    for (const double scale : {1e-6, 1e6})
        cells.push_back(manyWallsCell("scale-many:" + powerText(scale),
                                      "a room of 1000 walls scaled by " + powerText(scale), {scale, 0.0}));
    for (const double offset : {1e3, 1e5})
        cells.push_back(manyWallsCell("offset-many:" + powerText(offset),
                                      "a room of 1000 walls " + powerText(offset) + " times its size away",
                                      {1.0, offset}));
    for (const double offset : {1e3, 1e5}) cells.push_back(lampCell(offset));
}

}  // namespace halfdisk
