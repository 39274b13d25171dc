// How is a picture stored as PNG, and when are two pictures the same?
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfdisk {

/// Rows from the top, 4 bytes (red, green, blue, opacity) per pixel.
struct Image {
    int width = 0, height = 0;  ///< pixels
    std::vector<std::uint8_t> rgba;
    bool operator==(const Image&) const = default;

    /// The 4 bytes of column x, row y.
    const std::uint8_t* at(int x, int y) const {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
    std::uint8_t* at(int x, int y) { return const_cast<std::uint8_t*>(std::as_const(*this).at(x, y)); }
};

/// The bytes of a PNG file. Throws std::invalid_argument if `rgba` does not fit the size.
std::string encodePng(const Image& image);

/// Throws std::runtime_error if `bytes` are no PNG or hold more than 2^26 pixels.
Image decodePng(std::string_view bytes);

/// Written whole or not at all. Throws std::runtime_error naming the file.
void writePng(const std::filesystem::path& path, const Image& image);
Image readPng(const std::filesystem::path& path);

struct ImageComparison {
    std::size_t outliers = 0;   ///< pixels with a channel that differs by more than the tolerance
    int largestDifference = 0;  ///< over all channels, in levels 0 ... 255
    Image picture;              ///< grey where equal, the brighter red the more different
};

/// Throws std::invalid_argument, naming both sizes, if they differ.
ImageComparison compareImages(const Image& a, const Image& b, int toleranceLevels);

}  // namespace halfdisk
