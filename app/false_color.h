// In which colour is a number shown? From dark blue over green to yellow: ever lighter, so that every eye,
// and a grey print, sees the order.
#pragma once

#include <cstdint>

namespace halfdisk {

/// As ImGui's (IM_COL32), opaque.
std::uint32_t packed(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// `share` in 0 ... 1 along the scale; what is outside takes the nearer end.
std::uint32_t falseColor(double share);

/// Where a value up to 1 lies within kScaleDecades powers of ten, as a colour; 0 and less: the dark end.
std::uint32_t decadeColor(double value);

}  // namespace halfdisk
