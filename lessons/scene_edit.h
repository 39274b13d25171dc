// How is a scene changed by hand? What can be taken hold of in it, and what moving it does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/scene_description.h"

namespace halfdisk {

enum class ThingKind : std::uint8_t { shape, light, eye };

/// One thing of a scene: which shape, or which light; of the eye there is one.
struct Thing {
    ThingKind kind = ThingKind::shape;
    std::size_t index = 0;
    bool operator==(const Thing&) const = default;
};

bool exists(const SceneDescription& scene, Thing thing);

/// All things in file order: shapes, lights, the eye.
std::vector<Thing> thingsOf(const SceneDescription& scene);

/// What all things are called, in their order: by name, or one made up for a shape without; "light 1"; "eye".
std::vector<std::string> namesOf(const SceneDescription& scene);

/// The same for one.
std::string nameOf(const SceneDescription& scene, Thing thing);

/// Points (m) by which a thing can be pulled into shape. A directional light has none: it is nowhere.
std::vector<Vec2> handlesOf(const SceneDescription& scene, Thing thing);

/// Pulls one of the handles to a place. What would turn a shape inside out is kept right side out.
void pullHandle(SceneDescription& scene, Thing thing, std::size_t handle, Vec2 to);

void moveBy(SceneDescription& scene, Thing thing, Vec2 by);

/// About its middle, counter-clockwise. A box becomes a polygon unless it is a multiple of 90 degrees.
void turnBy(SceneDescription& scene, Thing thing, double degrees);

/// About its middle; factor > 0.
void scaleBy(SceneDescription& scene, Thing thing, double factor);

/// Front and back change places.
void flip(SceneDescription& scene, Thing thing);

/// Adds a material of the kind (an alternative of Material), with a name of its own, which is returned.
std::string addMaterial(SceneDescription& scene, std::size_t kind);

void remove(SceneDescription& scene, Thing thing);

/// Adds a copy, moved. The eye is only moved: there is one. Returns what was added.
Thing copyOf(SceneDescription& scene, Thing thing, Vec2 by);

/// Adds a shape, with a name of its own. Returns it.
Thing addShape(SceneDescription& scene, const Geometry& geometry, const std::string& material,
               const Rgb& emission);

/// How far a place is from a thing (m): from its walls, its point or its handles; infinity for what is
/// nowhere.
double distanceTo(const SceneDescription& scene, Thing thing, Vec2 place);

/// The thing nearest to a place, if one is within `reach` (m). Of shapes as near, the later one: it lies on
/// top.
std::optional<Thing> thingAt(const SceneDescription& scene, Vec2 place, double reach);

/// Empty, or why a scene file could not hold this scene: one message, as loadScene would give it.
std::string faultOf(const SceneDescription& scene);

}  // namespace halfdisk
