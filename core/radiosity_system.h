// What do patches send each other, bounce by bounce or for ever? The system of linear equations of
// radiosity.h.
#pragma once

#include <optional>

#include "patches.h"

namespace halfdisk {

/// Mean irradiance (W/m) of a patch straight from point lights, directional lights and the environment.
Rgb meanDirect(const Visibility& visibility, const Patch& patch);

/// Radiance (W/(m rad)) that each patch scatters, of light that was scattered at most `bounces` times; empty:
/// any number of times. Throws std::invalid_argument where that has no end, and Stopped if `stop` says so.
std::vector<Rgb> scatteredRadiance(const Visibility& visibility, const Patches& patches,
                                   std::optional<std::uint32_t> bounces, const StopQuestion& stop);

}  // namespace halfdisk
