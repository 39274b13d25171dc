// How is the light from where no wall is changed by hand?
#pragma once

#include <array>
#include <cstdint>

#include "lessons/scene_description.h"

namespace halfdisk {

enum class SkyKind : std::uint8_t { none, even, strip, image };

inline constexpr std::array<Named<SkyKind>, 4> kSkyKinds{{
    {SkyKind::none, "dark", "no light from where no wall is"},
    {SkyKind::even, "even", "the same radiance from all around"},
    {SkyKind::strip, "strip", "equal angles, counter-clockwise from +x, each with a colour of its own"},
    {SkyKind::image, "picture", "a PNG beside the scene's file: one column for each angle"},
}};

SkyKind kindOf(const Sky& sky);

/// Keeps what it can: a picture's colours become a strip, an even sky four equal angles. A picture needs
/// a file: that kind changes nothing.
void setKind(Sky& sky, SkyKind kind);

}  // namespace halfdisk
