// Are two scenes the same, whatever their files are called? A short text that differs where they do.
#pragma once

#include <string>

#include "lessons/scene_description.h"

namespace halfdisk {

/// 16 hexadecimal digits, of the scene in canonical form: the same for a file that only moved.
std::string sceneHash(const SceneDescription& description);

}  // namespace halfdisk
