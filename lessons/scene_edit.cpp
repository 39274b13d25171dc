#include "lessons/scene_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nearest_wall.h"
#include "lessons/scene_file.h"
#include "lessons/scene_keys.h"
#include "lessons/shape_edit.h"

namespace halfdisk {
namespace {

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

std::vector<std::string> namesOf(const SceneDescription& scene) {
    std::vector<std::string> names = shapeNames(scene.shapes);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) names.push_back(fmt::format("light {}", i + 1));
    if (scene.eye) names.push_back("eye");
    return names;
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
    if (thing.kind == ThingKind::shape) return handlesOf(scene.shapes.at(thing.index).geometry);
    if (thing.kind == ThingKind::eye)
        return {scene.eye->position, scene.eye->position + scene.eye->direction};
    const auto* point = std::get_if<PointLight>(&scene.lights.at(thing.index));
    return point ? std::vector{point->position} : std::vector<Vec2>{};
}

void pullHandle(SceneDescription& scene, Thing thing, std::size_t handle, Vec2 to) {
    switch (thing.kind) {
        case ThingKind::shape:
            return pullHandle(scene.shapes.at(thing.index).geometry, handle, to);
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
        moveBy(scene.shapes.at(thing.index).geometry, by);
    else if (thing.kind == ThingKind::eye)
        scene.eye->position += by;
    else if (auto* point = std::get_if<PointLight>(&scene.lights.at(thing.index)))
        point->position += by;
}

void turnBy(SceneDescription& scene, Thing thing, double degrees) {
    const Vec2 unit = unitAtDegrees(degrees);
    if (thing.kind == ThingKind::shape)
        turnBy(scene.shapes.at(thing.index).geometry, degrees);
    else if (thing.kind == ThingKind::eye)
        scene.eye->direction = turned(scene.eye->direction, unit);
    else if (auto* sun = std::get_if<DirectionalLight>(&scene.lights.at(thing.index)))
        sun->direction = turned(sun->direction, unit);
}

void scaleBy(SceneDescription& scene, Thing thing, double factor) {
    if (thing.kind == ThingKind::shape) scaleBy(scene.shapes.at(thing.index).geometry, factor);
}

void flip(SceneDescription& scene, Thing thing) {
    if (thing.kind == ThingKind::shape) flip(scene.shapes.at(thing.index).geometry);
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
            nearest = std::min(nearest, nearestOnStretch(edge.a, edge.b, place).distance);
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
