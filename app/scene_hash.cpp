#include "app/scene_hash.h"

#include <fmt/format.h>

#include "lessons/scene_file.h"

namespace halfdisk {

// FNV-1a.
std::string sceneHash(const SceneDescription& description) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : writeScene(description))
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

}  // namespace halfdisk
