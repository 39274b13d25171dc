// Is a wall flat and diffuse, and if not, what is it? For estimators that can treat no other.
#pragma once

#include <string>

#include "scene.h"

namespace halfdisk {

/// "a mirror", "glass", "glossy", "a mix" or "round"; empty if the wall is flat and diffuse.
std::string whyNotFlatDiffuse(const Scene& scene, std::uint32_t segment);

/// The wall's name in quotes, or its number if it has none.
std::string quotedName(const Scene& scene, std::uint32_t segment);

}  // namespace halfdisk
