// What is a scene on screen, ready for rays? Made once when a scene is loaded, then only read, also by the
// light's thread.
#pragma once

#include <memory>
#include <optional>

#include "core/reference.h"
#include "lessons/scene_file.h"

namespace halfdisk {

/// m; empty scenes have the unit square about the origin.
struct Bounds {
    Vec2 min{-1.0}, max{1.0};

    Vec2 center() const { return (min + max) / 2.0; }
    Vec2 size() const { return max - min; }
};

/// Does not move: the index points to the scene, the visibility to the index.
struct PreparedScene {
    explicit PreparedScene(SceneDescription described);
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    SceneDescription description;
    Scene scene;
    SegmentIndex index;
    std::optional<Visibility>
        visibility;  ///< empty where there are no exact answers: too many walls, or not all diffuse
    Bounds bounds;   ///< of walls, point lights and the eye
};

}  // namespace halfdisk
