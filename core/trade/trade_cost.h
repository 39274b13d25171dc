// What is paid for accuracy?
#pragma once

#include <array>
#include <cstdint>

#include "core/settings.h"

namespace halfdisk {

/// Rays are the same on every machine; seconds are not.
enum class TradeCost : std::uint8_t { rays, seconds };
inline constexpr std::array<Named<TradeCost>, 2> kTradeCosts{{
    {TradeCost::rays, "rays", "rays cast, shadow rays included; what is prepared without rays is free"},
    {TradeCost::seconds, "seconds", "wall-clock time, preparation included"},
}};

}  // namespace halfdisk
