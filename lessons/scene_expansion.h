// How does a description become the scene of the core, and what are its walls called?
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lessons/scene_description.h"
#include "lessons/shape_edges.h"

namespace halfdisk {

/// Most walls of a scene, all shapes together.
inline constexpr std::uint64_t kMaxSegments = 1'000'000;

/// Names of the shapes, those without one made up ("box1"), so that no two walls get the same name.
std::vector<std::string> shapeNames(const std::vector<Shape>& shapes);

/// The core's scene: one wall per edge, in file order; NAME for a segment, NAME.0, NAME.1, ... for the
/// others; directions made unit, degrees radians. Throws InputError (without a place) for a material that
/// does not exist; all else was checked by the reader.
Scene expandScene(const SceneDescription& description);

}  // namespace halfdisk
