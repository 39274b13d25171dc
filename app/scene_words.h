// What stands in a scene, in words? For those who do not see the canvas.
#pragma once

#include <string>
#include <vector>

#include "lessons/scene_description.h"

namespace halfdisk {

/// `(1.25, 0.5)`, m.
std::string placeWords(Vec2 place);

/// One number, or three: `0.8`, `0.7, 0.1, 0.1 (red, green, blue)`.
std::string colourWords(const Rgb& colour);

/// One sentence for each shape, with its ends and its material; of very many only the first.
std::vector<std::string> wallWords(const SceneDescription& scene);
std::vector<std::string> materialWords(const SceneDescription& scene);
/// Lights that are no walls, and the sky.
std::vector<std::string> lightWords(const SceneDescription& scene);
/// Empty without an eye.
std::string eyeWords(const SceneDescription& scene);

}  // namespace halfdisk
