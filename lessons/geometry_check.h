// Is this a shape whose walls all have a front, although each of its values is fine by itself?
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lessons/scene_description.h"

namespace halfdisk {

struct GeometryFault {
    std::string_view key;                ///< whose value is to blame
    std::optional<std::size_t> element;  ///< of that value, if it is an array
    std::string text;                    ///< what is wrong, what was expected
};

/// The first fault of a shape, if it has one: a wall of zero length, a box or an arc inside out, a lens whose
/// surfaces cross. Expands the shape: check edgeCount first.
std::optional<GeometryFault> findFault(const Geometry& geometry);

}  // namespace halfdisk
