#include "app/scene_hash.h"

#include "app/fingerprint.h"
#include "lessons/scene_file.h"

namespace halfdisk {

std::string sceneHash(const SceneDescription& description) {
    return fingerprintOf(writeScene(description));
}

}  // namespace halfdisk
