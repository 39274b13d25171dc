#include "lessons/scene_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/overload.h"
#include "lessons/scene_file.h"
#include "lessons/scene_keys.h"

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

std::vector<Vec2> handles(const Geometry& geometry) {
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

Vec2 middleOf(const Geometry& geometry) {
    if (const auto* circle = std::get_if<CircleShape>(&geometry)) return circle->center;
    if (const auto* arc = std::get_if<ArcShape>(&geometry)) return arc->center;
    if (const auto* lens = std::get_if<LensShape>(&geometry)) return lens->center;
    const std::vector<Vec2> points = handles(geometry);
    Vec2 sum(0.0);
    for (const Vec2 p : points) sum += p;
    return sum / static_cast<double>(points.size());  // which turning does not move
}

Vec2 turned(Vec2 v, Vec2 unit) {
    return {v.x * unit.x - v.y * unit.y, v.x * unit.y + v.y * unit.x};
}

/// In the order of its edges (bottom, right, top, left), which a polygon's turning keeps or reverses.
PolygonShape polygonOf(const BoxShape& box) {
    std::vector<Vec2> points = handles(box);
    // Counter-clockwise points face inward.
    if (box.facing == Facing::out) std::reverse(points.begin(), points.end());
    return {points};
}

void turnShape(Geometry& geometry, double degrees) {
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

void scaleShape(Geometry& geometry, double factor) {
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

double distanceToSegment(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 edge = b - a;
    const double length2 = glm::dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
    return glm::length(a + t * edge - p);
}

/// A name that no shape has, after `base`: base, base 2, base 3, ...
std::string freeName(const SceneDescription& scene, const std::string& base) {
    const std::vector<std::string> taken = shapeNames(scene.shapes);
    const auto isTaken = [&](const std::string& name) {
        return std::find(taken.begin(), taken.end(), name) != taken.end();
    };
    std::string name = base;
    for (int number = 2; isTaken(name); ++number) name = fmt::format("{} {}", base, number);
    return name;
}

}  // namespace

bool exists(const SceneDescription& scene, Thing thing) {
    switch (thing.kind) {
        case ThingKind::shape:
            return thing.index < scene.shapes.size();
        case ThingKind::light:
            return thing.index < scene.lights.size();
        case ThingKind::eye:
            return thing.index == 0 && scene.eye.has_value();
    }
    return false;
}

std::vector<Thing> thingsOf(const SceneDescription& scene) {
    std::vector<Thing> things;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) things.push_back({ThingKind::shape, i});
    for (std::size_t i = 0; i < scene.lights.size(); ++i) things.push_back({ThingKind::light, i});
    if (scene.eye) things.push_back({ThingKind::eye, 0});
    return things;
}

std::string nameOf(const SceneDescription& scene, Thing thing) {
    switch (thing.kind) {
        case ThingKind::shape:
            return shapeNames(scene.shapes).at(thing.index);
        case ThingKind::light:
            return fmt::format("light {}", thing.index + 1);
        case ThingKind::eye:
            return "eye";
    }
    return {};
}

std::vector<Vec2> handlesOf(const SceneDescription& scene, Thing thing) {
    if (thing.kind == ThingKind::shape) return handles(scene.shapes.at(thing.index).geometry);
    if (thing.kind == ThingKind::eye)
        return {scene.eye->position, scene.eye->position + scene.eye->direction};
    const auto* point = std::get_if<PointLight>(&scene.lights.at(thing.index));
    return point ? std::vector{point->position} : std::vector<Vec2>{};
}

void pullHandle(SceneDescription& scene, Thing thing, std::size_t handle, Vec2 to) {
    switch (thing.kind) {
        case ThingKind::shape:
            return std::visit([&](auto& shape) { pull(shape, handle, to); },
                              scene.shapes.at(thing.index).geometry);
        case ThingKind::light:
            if (auto* point = std::get_if<PointLight>(&scene.lights.at(thing.index))) point->position = to;
            return;
        case ThingKind::eye:
            if (handle == 0)
                scene.eye->position = to;
            else
                scene.eye->direction = to - scene.eye->position;
            return;
    }
}

void moveBy(SceneDescription& scene, Thing thing, Vec2 by) {
    if (thing.kind == ThingKind::shape)
        forPoints(scene.shapes.at(thing.index).geometry, [&](Vec2& p) { p += by; });
    else if (thing.kind == ThingKind::eye)
        scene.eye->position += by;
    else if (auto* point = std::get_if<PointLight>(&scene.lights.at(thing.index)))
        point->position += by;
}

void turnBy(SceneDescription& scene, Thing thing, double degrees) {
    const Vec2 unit = unitAtDegrees(degrees);
    if (thing.kind == ThingKind::shape)
        turnShape(scene.shapes.at(thing.index).geometry, degrees);
    else if (thing.kind == ThingKind::eye)
        scene.eye->direction = turned(scene.eye->direction, unit);
    else if (auto* sun = std::get_if<DirectionalLight>(&scene.lights.at(thing.index)))
        sun->direction = turned(sun->direction, unit);
}

void scaleBy(SceneDescription& scene, Thing thing, double factor) {
    if (thing.kind == ThingKind::shape) scaleShape(scene.shapes.at(thing.index).geometry, factor);
}

void flip(SceneDescription& scene, Thing thing) {
    if (thing.kind != ThingKind::shape) return;
    const auto other = [](Facing facing) { return facing == Facing::out ? Facing::in : Facing::out; };
    std::visit(Overload{[](SegmentShape& s) { std::swap(s.a, s.b); },
                        [](PolylineShape& s) { std::reverse(s.points.begin(), s.points.end()); },
                        [](PolygonShape& s) { std::reverse(s.points.begin(), s.points.end()); },
                        [](LensShape&) {}, [&](auto& s) { s.facing = other(s.facing); }},
               scene.shapes.at(thing.index).geometry);
}

std::string addMaterial(SceneDescription& scene, std::size_t kind) {
    constexpr std::array<Material, std::variant_size_v<Material>> kNew{Diffuse{}, Mirror{}, Glossy{},
                                                                       Dielectric{}, Mix{}};
    const std::string base = kind == 3 ? "glass" : std::string(kMaterialTypes.at(kind).name);
    const auto isTaken = [&](const std::string& name) {
        return std::any_of(scene.materials.begin(), scene.materials.end(),
                           [&](const NamedMaterial& m) { return m.name == name; });
    };
    std::string name = base;
    for (int number = 2; isTaken(name); ++number) name = fmt::format("{} {}", base, number);
    scene.materials.push_back({name, kNew.at(kind)});
    return name;
}

void remove(SceneDescription& scene, Thing thing) {
    const auto at = static_cast<std::ptrdiff_t>(thing.index);
    if (thing.kind == ThingKind::shape) scene.shapes.erase(scene.shapes.begin() + at);
    if (thing.kind == ThingKind::light) scene.lights.erase(scene.lights.begin() + at);
    if (thing.kind == ThingKind::eye) scene.eye.reset();
}

Thing copyOf(SceneDescription& scene, Thing thing, Vec2 by) {
    Thing copy = thing;
    if (thing.kind == ThingKind::shape) {
        Shape shape = scene.shapes.at(thing.index);
        if (!shape.name.empty()) shape.name = freeName(scene, shape.name);
        scene.shapes.push_back(std::move(shape));
        copy.index = scene.shapes.size() - 1;
    }
    if (thing.kind == ThingKind::light) {
        scene.lights.push_back(DeltaLight(scene.lights.at(thing.index)));
        copy.index = scene.lights.size() - 1;
    }
    moveBy(scene, copy, by);
    return copy;
}

Thing addShape(SceneDescription& scene, const Geometry& geometry, const std::string& material,
               const Rgb& emission) {
    const std::string base = emission == Rgb(0.0) ? std::string(kShapeKinds[geometry.index()]) : "lamp";
    scene.shapes.push_back({freeName(scene, base), geometry, material, emission, false});
    return {ThingKind::shape, scene.shapes.size() - 1};
}

double distanceTo(const SceneDescription& scene, Thing thing, Vec2 place) {
    double nearest = std::numeric_limits<double>::infinity();
    if (thing.kind == ThingKind::shape)
        for (const Edge& edge : edgesOf(scene.shapes.at(thing.index).geometry))
            nearest = std::min(nearest, distanceToSegment(edge.a, edge.b, place));
    else
        for (const Vec2 handle : handlesOf(scene, thing))
            nearest = std::min(nearest, glm::length(handle - place));
    return nearest;
}

std::optional<Thing> thingAt(const SceneDescription& scene, Vec2 place, double reach) {
    std::optional<Thing> found;
    double nearest = reach;
    for (const Thing& thing : thingsOf(scene)) {
        const double distance = distanceTo(scene, thing, place);
        if (distance > nearest) continue;
        nearest = distance;
        found = thing;
    }
    return found;
}

std::string faultOf(const SceneDescription& scene) {
    try {
        parseScene(writeScene(scene), "scene",
                   [&](const std::string&) { return scene.environment.light.strip; });
        return {};
    } catch (const InputError& error) {
        return error.text;
    }
}

}  // namespace halfdisk
