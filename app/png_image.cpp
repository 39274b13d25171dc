// How is a picture stored as PNG, and when are two pictures the same?
#include "app/png_image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "lessons/atomic_file.h"

namespace halfdisk {

namespace {

constexpr std::size_t kMostPixels = std::size_t{1} << 26;

std::size_t byteCount(int width, int height) {
    return std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// libpng's simplified interface: one control block, freed on every way out.
struct PngControl {
    png_image image{};
    PngControl() { image.version = PNG_IMAGE_VERSION; }
    ~PngControl() { png_image_free(&image); }
    PngControl(const PngControl&) = delete;
    PngControl& operator=(const PngControl&) = delete;
};

}  // namespace

std::string encodePng(const Image& image) {
    if (image.width <= 0 || image.height <= 0 || image.rgba.size() != byteCount(image.width, image.height))
        throw std::invalid_argument(fmt::format("an image of {}x{} cannot have {} bytes", image.width,
                                                image.height, image.rgba.size()));
    PngControl png;
    png.image.width = static_cast<png_uint_32>(image.width);
    png.image.height = static_cast<png_uint_32>(image.height);
    png.image.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png.image, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr))
        throw std::runtime_error(fmt::format("cannot encode a PNG: {}", png.image.message));
    bytes.resize(size);
    return bytes;
}

Image decodePng(std::string_view bytes) {
    PngControl png;
    if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()))
        throw std::runtime_error(fmt::format("not a PNG: {}", png.image.message));
    if (png.image.width > kMostPixels / std::max(1u, png.image.height))
        throw std::runtime_error(
            fmt::format("a PNG of {}x{} is too large", png.image.width, png.image.height));
    png.image.format = PNG_FORMAT_RGBA;
    Image image{static_cast<int>(png.image.width), static_cast<int>(png.image.height), {}};
    image.rgba.resize(byteCount(image.width, image.height));
    if (!png_image_finish_read(&png.image, nullptr, image.rgba.data(), 0, nullptr))
        throw std::runtime_error(fmt::format("a broken PNG: {}", png.image.message));
    return image;
}

void writePng(const std::filesystem::path& path, const Image& image) {
    writeFileAtomically(path, encodePng(image));
}

Image readPng(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(fmt::format("cannot open {}", path.string()));
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    try {
        return decodePng(bytes);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("{}: {}", path.string(), error.what()));
    }
}

ImageComparison compareImages(const Image& a, const Image& b, int toleranceLevels) {
    if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size())
        throw std::invalid_argument(fmt::format("images of {}x{} and {}x{} cannot be compared", a.width,
                                                a.height, b.width, b.height));
    ImageComparison result{0, 0, a};
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        int difference = 0;
        for (std::size_t channel = pixel; channel < pixel + 4; ++channel)
            difference = std::max(difference, std::abs(a.rgba[channel] - b.rgba[channel]));
        result.largestDifference = std::max(result.largestDifference, difference);
        if (difference > toleranceLevels) ++result.outliers;
        const int grey = 190 + (a.rgba[pixel] + a.rgba[pixel + 1] + a.rgba[pixel + 2]) / 16;
        const bool outlier = difference > toleranceLevels;
        result.picture.rgba[pixel] = static_cast<std::uint8_t>(outlier ? 128 + difference / 2 : grey);
        result.picture.rgba[pixel + 1] = static_cast<std::uint8_t>(outlier ? 0 : grey);
        result.picture.rgba[pixel + 2] = static_cast<std::uint8_t>(outlier ? 0 : grey);
        result.picture.rgba[pixel + 3] = 255;
    }
    return result;
}

}  // namespace halfdisk
