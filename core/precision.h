// In how many bits are numbers kept?
#pragma once

#include "core/settings.h"

namespace halfdisk {

enum class Precision : std::uint8_t { single, twice };
inline constexpr std::array<Named<Precision>, 2> kPrecisions{{
    {Precision::single, "float", "24 bits, about 7 digits"},
    {Precision::twice, "double", "53 bits, about 16 digits"},
}};

}  // namespace halfdisk
