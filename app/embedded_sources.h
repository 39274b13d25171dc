// Where does the source of castRay on the screen come from? From the very files that were compiled: the build
// copies their text into the program, so what is read is what runs.
#pragma once

#include <string_view>

namespace halfdisk {

std::string_view castRaySource();    ///< core/cast_ray.h
std::string_view asPrintedSource();  ///< core/as_printed.h

}  // namespace halfdisk
