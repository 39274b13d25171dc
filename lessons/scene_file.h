// How is a scene file read, checked, written back, and asked for a wall by name?
//
// What the values mean is told in scene_description.h; which keys there are, in scene_keys.h.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/input_error.h"
#include "lessons/scene_description.h"
#include "lessons/scene_expansion.h"
#include "lessons/wall_point.h"

namespace halfdisk {

/// How parseScene gets the strip of the environment from the picture that a file names; throws InputError.
using SkyLoader = std::function<std::vector<Rgb>(const std::string& image)>;

/// Reads TOML. Throws InputError for the first thing that is wrong, at its place in `fileName`; nothing else.
/// Opens no file: without a `skyLoader`, a picture is refused.
SceneDescription parseScene(std::string_view text, std::string_view fileName,
                            const SkyLoader& skyLoader = {});

/// Reads a scene file, and its picture of the environment relative to the file's folder. Throws InputError,
/// also for a file that is missing, no file, or larger than kMaxFileBytes.
SceneDescription loadScene(const std::filesystem::path& path);

/// TOML that parseScene reads back as an equal description. Numbers are the shortest that keep every bit;
/// keys at their default are left out; names that were made up are not written. A glossy wall has its
/// exponent, a mix its parts themselves.
std::string writeScene(const SceneDescription& description);

/// Writes a scene file in one stroke (see writeFileAtomically). The name of a picture stays as it is: whether
/// it lies beside the new file is not looked at. Throws InputError, and leaves the file as it
/// was, if the description is one that loadScene would refuse; std::runtime_error if the file cannot be
/// written.
void saveScene(const SceneDescription& description, const std::filesystem::path& path);

}  // namespace halfdisk
