#include "scenes.h"

#include "lessons/scene_file.h"

namespace halfdisk {

std::map<std::string, Scene> lessonScenes() {
    std::map<std::string, Scene> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(HALFDISK_ROOT "/lessons/scenes"))
        if (entry.path().extension() == ".toml")
            scenes[entry.path().stem().string()] = expandScene(loadScene(entry.path()));
    return scenes;
}

}  // namespace halfdisk
