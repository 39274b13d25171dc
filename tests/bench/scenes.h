// Which scenes belong to the lessons?
#pragma once

#include <map>
#include <string>

#include "core/scene.h"

namespace halfdisk {

/// All in lessons/scenes, by name.
std::map<std::string, Scene> lessonScenes();

}  // namespace halfdisk
