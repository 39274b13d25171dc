// How are linear light values stored as a picture? Portable float map: 32-bit floats, nothing lost but
// precision.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/math.h"

namespace halfdisk {

/// Rows from the top, red, green, blue.
struct LinearImage {
    std::uint32_t width = 0, height = 0;  ///< pixels
    std::vector<Rgb> pixels;
};

/// The bytes of a colour PFM ("PF"): little-endian, rows from the bottom. Debevec's format of 1998.
std::string encodePfm(const LinearImage& image);

/// Throws std::runtime_error if `bytes` are no little-endian colour PFM of that form.
LinearImage decodePfm(std::string_view bytes);

}  // namespace halfdisk
