// Rows of walls: tiny ones, rays along them, two that nearly touch, and a corner like a needle's.
#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"

namespace halfdisk {
namespace {

constexpr const char* kWhy =
    "(4 D + 16) / 2 roundings for D bounces, whatever the walls; one lost ray would be 1e-5";

/// Turned by 0.3 rad: walls along an axis hide what rounding does.
std::vector<Vec2> turned(std::vector<Vec2> points) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    for (Vec2& p : points) p = Vec2(c * p.x - s * p.y, s * p.x + c * p.y) + Vec2(0.37, 0.21);
    return points;
}

ExtremeCell cell(std::string id, std::string title, const std::vector<Vec2>& points, SurveyRays rays = {}) {
    return {std::move(id),
            std::move(title),
            "E, relative",
            furnaceBound(FurnaceQuestion{}.depth),
            kWhy,
            [points, rays](const StopQuestion& stop) {
                return furnaceOutcome(furnaceOf(points, FurnaceQuestion{}.albedo), {}, {}, rays, stop);
            }};
}

/// A square of 1 m whose corner at 1, 1 is cut off by three walls of about `length`, in a curve.
std::vector<Vec2> squareWithTinyWalls(double length) {
    const double l = length;
    return turned({{0.0, 0.0},
                   {1.0, 0.0},
                   {1.0, 1.0 - 2.0 * l},
                   {1.0 - 0.5 * l, 1.0 - l},
                   {1.0 - l, 1.0 - 0.5 * l},
                   {1.0 - 2.0 * l, 1.0},
                   {0.0, 1.0}});
}

}  // namespace

void addWallRows(std::vector<ExtremeCell>& cells) {
    for (const double length : {1e-3, 1e-5, 1e-7})
        cells.push_back(cell("length:" + powerText(length), "walls of " + powerText(length) + " of the room",
                             squareWithTinyWalls(length)));
    const auto square = turned({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
    for (const double angle : {1e-2, 1e-4, 1e-6}) {
        SurveyRays rays;
        rays.theta = angle;
        cells.push_back(cell("angle:" + powerText(angle), "rays " + powerText(angle) + " rad from their wall",
                             square, rays));
    }
    for (const double gap : {1e-3, 1e-5, 1e-7})
        cells.push_back(cell("gap:" + powerText(gap), "two facing walls, " + powerText(gap) + " apart",
                             turned({{0.0, 0.0}, {1.0, 0.0}, {1.0, gap}, {0.0, gap}})));
    for (const double angle : {1e-1, 1e-2, 1e-3})
        cells.push_back(cell("corner:" + powerText(angle), "a corner of " + powerText(angle) + " rad",
                             turned({{0.0, 0.0}, {1.0, 0.0}, {std::cos(angle), std::sin(angle)}})));
}

}  // namespace halfdisk
