// Which walls are meant by a list of names? A shape's name stands for all its walls, in their order.
#pragma once

#include <string_view>
#include <vector>

#include "core/scene.h"

namespace halfdisk {

/// `floor,box.2,disk` or `all`: indices into Scene::segments. Throws InputError, starting with `option`, for
/// a name that no wall or shape has, and for a wall that is named twice.
std::vector<std::uint32_t> wallsArgument(std::string_view option, std::string_view text, const Scene& scene);

}  // namespace halfdisk
