#include "lessons/shape_edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/overload.h"
#include "lessons/shape_edges.h"

namespace halfdisk {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Applies to each point of a shape that says where it is; lengths are left alone.
template <class Change>
void forPoints(Geometry& geometry, const Change& change) {
    std::visit(Overload{[&](SegmentShape& s) {
                            change(s.a);
                            change(s.b);
                        },
                        [&](PolylineShape& s) {
                            for (Vec2& p : s.points) change(p);
                        },
                        [&](PolygonShape& s) {
                            for (Vec2& p : s.points) change(p);
                        },
                        [&](BoxShape& s) {
                            change(s.min);
                            change(s.max);
                        },
                        [&](auto& round) { change(round.center); }},
               geometry);
}

void pull(SegmentShape& s, std::size_t handle, Vec2 to) {
    (handle == 0 ? s.a : s.b) = to;
}
void pull(PolylineShape& s, std::size_t handle, Vec2 to) {
    s.points.at(handle) = to;
}
void pull(PolygonShape& s, std::size_t handle, Vec2 to) {
    s.points.at(handle) = to;
}
/// The opposite corner stays.
void pull(BoxShape& s, std::size_t handle, Vec2 to) {
    const bool right = handle == 1 || handle == 2, upper = handle >= 2;
    const Vec2 other{right ? s.min.x : s.max.x, upper ? s.min.y : s.max.y};
    s.min = glm::min(to, other);
    s.max = glm::max(to, other);
}
void pull(CircleShape& s, std::size_t handle, Vec2 to) {
    if (handle == 0)
        s.center = to;
    else
        s.radius = glm::length(to - s.center);
}
void pull(ArcShape& s, std::size_t handle, Vec2 to) {
    if (handle == 0) {
        s.center = to;
        return;
    }
    const Vec2 way = to - s.center;
    s.radius = glm::length(way);
    double& angle = handle == 1 ? s.from : s.to;
    // Of the angles that mean this direction, the one nearest to the present one.
    const double wanted = std::atan2(way.y, way.x) * kDegrees;
    angle = wanted + 360.0 * std::round((angle - wanted) / 360.0);
}
void pull(LensShape& s, std::size_t handle, Vec2 to) {
    if (handle == 0)
        s.center = to;
    else if (handle == 1)
        s.axis = to - s.center;
    else
        s.height = 2.0 * glm::length(to - s.center);
}

/// In the order of its edges (bottom, right, top, left), which a polygon's turning keeps or reverses.
PolygonShape polygonOf(const BoxShape& box) {
    std::vector<Vec2> points = handlesOf(Geometry(box));
    // Counter-clockwise points face inward.
    if (box.facing == Facing::out) std::reverse(points.begin(), points.end());
    return {points};
}

}  // namespace

Vec2 middleOf(const Geometry& geometry) {
    if (const auto* circle = std::get_if<CircleShape>(&geometry)) return circle->center;
    if (const auto* arc = std::get_if<ArcShape>(&geometry)) return arc->center;
    if (const auto* lens = std::get_if<LensShape>(&geometry)) return lens->center;
    const std::vector<Vec2> points = handlesOf(geometry);
    Vec2 sum(0.0);
    for (const Vec2 p : points) sum += p;
    return sum / static_cast<double>(points.size());  // which turning does not move
}

std::vector<Vec2> handlesOf(const Geometry& geometry) {
    return std::visit(
        Overload{[](const SegmentShape& s) {
                     return std::vector{s.a, s.b};
                 },
                 [](const PolylineShape& s) { return s.points; },
                 [](const PolygonShape& s) { return s.points; },
                 [](const BoxShape& s) {
                     return std::vector{s.min, Vec2(s.max.x, s.min.y), s.max, Vec2(s.min.x, s.max.y)};
                 },
                 [](const CircleShape& s) {
                     return std::vector{s.center, s.center + Vec2(s.radius, 0.0)};
                 },
                 [](const ArcShape& s) {
                     return std::vector{s.center, s.center + s.radius * unitAtDegrees(s.from),
                                        s.center + s.radius * unitAtDegrees(s.to)};
                 },
                 [](const LensShape& s) {
                     const Vec2 axis = unitAlong(s.axis);
                     return std::vector{s.center, s.center + std::max(s.thickness, 0.5 * s.height) * axis,
                                        s.center + 0.5 * s.height * perp(axis)};
                 }},
        geometry);
}

void pullHandle(Geometry& geometry, std::size_t handle, Vec2 to) {
    std::visit([&](auto& shape) { pull(shape, handle, to); }, geometry);
}

void moveBy(Geometry& geometry, Vec2 by) {
    forPoints(geometry, [&](Vec2& p) { p += by; });
}

void turnBy(Geometry& geometry, double degrees) {
    const Vec2 middle = middleOf(geometry), unit = unitAtDegrees(degrees);
    if (const auto* box = std::get_if<BoxShape>(&geometry))
        if (std::fmod(degrees, 90.0) != 0.0) geometry = polygonOf(*box);
    forPoints(geometry, [&](Vec2& p) { p = middle + turned(p - middle, unit); });
    if (auto* box = std::get_if<BoxShape>(&geometry)) {
        const Vec2 a = box->min, b = box->max;
        box->min = glm::min(a, b);
        box->max = glm::max(a, b);
    }
    if (auto* arc = std::get_if<ArcShape>(&geometry)) {
        arc->from += degrees;
        arc->to += degrees;
        // Many turns add up; files take angles up to ten turns.
        const double whole = 360.0 * std::trunc(arc->from / 360.0);
        arc->from -= whole;
        arc->to -= whole;
    }
    if (auto* lens = std::get_if<LensShape>(&geometry)) lens->axis = turned(lens->axis, unit);
}

void scaleBy(Geometry& geometry, double factor) {
    const Vec2 middle = middleOf(geometry);
    forPoints(geometry, [&](Vec2& p) { p = middle + factor * (p - middle); });
    std::visit(Overload{[&](CircleShape& s) { s.radius *= factor; }, [&](ArcShape& s) { s.radius *= factor; },
                        [&](LensShape& s) {
                            s.height *= factor;
                            s.thickness *= factor;
                            s.radius *= factor;
                        },
                        [](auto&) {}},
               geometry);
}

void flip(Geometry& geometry) {
    const auto other = [](Facing facing) { return facing == Facing::out ? Facing::in : Facing::out; };
    std::visit(Overload{[](SegmentShape& s) { std::swap(s.a, s.b); },
                        [](PolylineShape& s) { std::reverse(s.points.begin(), s.points.end()); },
                        [](PolygonShape& s) { std::reverse(s.points.begin(), s.points.end()); },
                        [](LensShape&) {}, [&](auto& s) { s.facing = other(s.facing); }},
               geometry);
}

}  // namespace halfdisk
