// Where does the source on the screen come from? From the very files that were compiled: the build copies
// their text into the program, so what is read is what runs.
#pragma once

#include <span>
#include <string_view>

namespace halfdisk {

struct EmbeddedSource {
    std::string_view file;  ///< from the project's root: core/cast_ray.h
    std::string_view text;
};

std::span<const EmbeddedSource> embeddedSources();

/// Of a file that is embedded.
std::string_view sourceOf(std::string_view file);

}  // namespace halfdisk
