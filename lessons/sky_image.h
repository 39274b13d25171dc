// How does a picture become the light from all around?
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/math.h"

namespace halfdisk {

/// Most entries of an environment's strip, and so most columns of its picture.
inline constexpr std::size_t kMostStripEntries = 65'536;
inline constexpr std::size_t kMostSkyRows = 4096;
/// Most pixels altogether: decoded they fill 130 MB.
inline constexpr std::size_t kMostSkyPixels = std::size_t{1} << 24;
inline constexpr std::uintmax_t kMaxSkyBytes = 100'000'000;

/// One entry for each column of a PNG: the mean of its pixels, in linear light from 0 to 1 (sRGB decoded,
/// also of 16 bits; another gamma only where the file names it). What is transparent counts as black. Throws
/// InputError with the name `file` if `png` is none, broken, or larger than the limits above, which is found
/// out before anything is decoded.
std::vector<Rgb> decodeSky(std::string_view png, const std::string& file);

/// The same of a file.
std::vector<Rgb> readSky(const std::filesystem::path& path);

/// Linear light, 0 ... 1, of an sRGB value, 0 ... 1 (IEC 61966-2-1).
double linearOfSrgb(double encoded);

}  // namespace halfdisk
