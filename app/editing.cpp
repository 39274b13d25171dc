#include "app/editing.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

constexpr std::uint32_t kCircleWalls = 48, kLensWalls = 24;

}  // namespace

std::size_t bytesOf(const PreparedScene& scene) {
    constexpr std::size_t kEach = 128;  // a wall's name, its edge, and the like
    return scene.scene.segments.size() * (sizeof(Segment) + kEach) + scene.index.bytes() + 1024;
}

std::string usualMaterial(const SceneDescription& scene) {
    return scene.materials.empty() ? std::string() : scene.materials.front().name;
}

std::optional<Thing> addThing(SceneDescription& scene, Tool tool, Vec2 from, Vec2 to) {
    const double length = glm::length(to - from);
    const auto shape = [&](const Geometry& geometry, const Rgb& emission = Rgb(0.0)) {
        return addShape(scene, geometry, usualMaterial(scene), emission);
    };
    switch (tool) {
        case Tool::select:
            return std::nullopt;
        case Tool::wall:
            return shape(SegmentShape{from, to});
        case Tool::lamp:
            return shape(SegmentShape{from, to}, Rgb(1.0));
        case Tool::box:
            return shape(BoxShape{glm::min(from, to), glm::max(from, to), Facing::out});
        case Tool::circle:
            return shape(CircleShape{from, length, kCircleWalls, Facing::out, true});
        case Tool::lens:
            return shape(
                LensShape{from, to - from, 2.0 * length, 0.6 * length, Vec2(2.0 * length), kLensWalls, true});
        case Tool::bulb:
            scene.lights.push_back(PointLight{to, Rgb(1.0)});
            return Thing{ThingKind::light, scene.lights.size() - 1};
        case Tool::sun:
            scene.lights.push_back(DirectionalLight{to - from, Rgb(1.0)});
            return Thing{ThingKind::light, scene.lights.size() - 1};
        case Tool::eye: {
            EyeDescription eye = scene.eye.value_or(EyeDescription{});
            eye.position = from;
            eye.direction = to - from;
            scene.eye = eye;
            return Thing{ThingKind::eye, 0};
        }
    }
    return std::nullopt;
}

bool serves(EditAct act, const Selection& things) {
    const auto isAny = [&](auto... kinds) {
        return std::any_of(things.things.begin(), things.things.end(),
                           [&](Thing thing) { return (... || (thing.kind == kinds)); });
    };
    switch (act) {
        case EditAct::copy:
        case EditAct::remove:
        case EditAct::turn:
            return !things.empty();
        case EditAct::larger:
        case EditAct::smaller:
            return things.size() > 1 || isAny(ThingKind::shape);
        case EditAct::flip:
            return isAny(ThingKind::shape);
    }
    return false;
}

Selection perform(EditAct act, SceneDescription& scene, const Selection& things) {
    constexpr double kStep = 0.1, kDegrees = 15.0, kFactor = 1.1;
    switch (act) {
        case EditAct::copy:
            return copyOf(scene, things, Vec2(kStep, kStep));
        case EditAct::remove:
            remove(scene, things);
            return {};
        case EditAct::turn:
            turnBy(scene, things, kDegrees);
            break;
        case EditAct::larger:
            scaleBy(scene, things, kFactor);
            break;
        case EditAct::smaller:
            scaleBy(scene, things, 1.0 / kFactor);
            break;
        case EditAct::flip:
            flip(scene, things);
            break;
    }
    return things;
}

Vec2 snapped(const SceneDescription& scene, const Selection& except, Vec2 place, double reach, double grid) {
    std::optional<Vec2> nearest;
    double distance = reach;
    for (const Thing& thing : thingsOf(scene)) {
        if (except.has(thing)) continue;
        for (const Vec2 handle : handlesOf(scene, thing)) {
            if (glm::length(handle - place) > distance) continue;
            distance = glm::length(handle - place);
            nearest = handle;
        }
    }
    if (nearest) return *nearest;
    const Vec2 onGrid = glm::round(place / grid) * grid;
    return {std::abs(onGrid.x - place.x) <= reach ? onGrid.x : place.x,
            std::abs(onGrid.y - place.y) <= reach ? onGrid.y : place.y};
}

}  // namespace halfdisk
