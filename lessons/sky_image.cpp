// How does a picture become the light from all around?
#include "lessons/sky_image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/input_error.h"
#include "lessons/text_file.h"

namespace halfdisk {
namespace {

/// libpng's simplified interface: one control block, freed on every way out.
struct PngControl {
    png_image image{};
    PngControl() { image.version = PNG_IMAGE_VERSION; }
    ~PngControl() { png_image_free(&image); }
    PngControl(const PngControl&) = delete;
    PngControl& operator=(const PngControl&) = delete;
};

/// Decodes all pixels in the format that `image` is set to.
template <class Channel>
std::vector<Channel> pixelsOf(png_image& image, const png_color* background, const std::string& file) {
    std::vector<Channel> pixels(PNG_IMAGE_SAMPLE_CHANNELS(image.format) * std::size_t{image.width} *
                                image.height);
    if (!png_image_finish_read(&image, background, pixels.data(), 0, nullptr))
        throw InputError(file, fmt::format("the PNG is broken: {}", image.message));
    return pixels;
}

/// Means of the columns of rows of pixels of so many channels each; `lightOf` makes light of a pixel.
template <class Channel, class LightOf>
std::vector<Rgb> columnMeans(const std::vector<Channel>& pixels, std::size_t columns, std::size_t channels,
                             const LightOf& lightOf) {
    std::vector<Rgb> means(columns, Rgb(0.0));
    for (std::size_t i = 0; i < pixels.size(); i += channels)
        means[i / channels % columns] += lightOf(pixels.data() + i);
    const std::size_t rows = pixels.size() / (channels * columns);
    for (Rgb& mean : means) mean /= static_cast<double>(rows);
    return means;
}

std::uint32_t bigEndian(std::string_view four) {
    std::uint32_t number = 0;
    for (const char byte : four) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

/// A PNG without what it says about its colours.
struct BarePng {
    std::string bytes;
    bool isSrgb = true;  ///< it says so, or nothing, or a gamma that is meant so
};

BarePng bare(std::string_view png) {
    constexpr std::size_t kSignature = 8, kAround = 12;  // length, name and checksum of a chunk
    constexpr std::uint32_t kSrgbGamma = 45'455, kAbout = 2'000;
    BarePng result{std::string(png.substr(0, kSignature))};
    bool saysSrgb = false, hasOtherGamma = false;
    for (std::size_t at = kSignature; at < png.size();) {
        const std::string_view head = png.substr(at, 8);
        const std::size_t size = std::size_t{bigEndian(head.substr(0, 4))} + kAround;
        const std::string_view chunk = png.substr(at, size), name = head.size() < 8 ? head : head.substr(4);
        saysSrgb = saysSrgb || name == "sRGB" || name == "iCCP";
        if (name == "gAMA" && chunk.size() == 4 + kAround) {
            const std::uint32_t gamma = bigEndian(chunk.substr(8, 4));
            hasOtherGamma = gamma + kAbout < kSrgbGamma || gamma > kSrgbGamma + kAbout;
        }
        if (name != "sRGB" && name != "iCCP" && name != "gAMA" && name != "cHRM") result.bytes += chunk;
        at += size;
    }
    result.isSrgb = saysSrgb || !hasOtherGamma;
    return result;
}

/// Of 16 bits and sRGB. libpng would decode it by a power of 2.2, up to 0.009 beside sRGB's curve. Without
/// any word about colours it takes the levels for light and leaves them as they are.
std::vector<Rgb> decodeDeepSrgb(const std::string& png, const std::string& file) {
    PngControl control;
    png_image& image = control.image;
    if (!png_image_begin_read_from_memory(&image, png.data(), png.size()))
        throw InputError(file, fmt::format("the PNG is broken: {}", image.message));
    image.format = PNG_FORMAT_LINEAR_RGB_ALPHA;
    const auto pixels = pixelsOf<png_uint_16>(image, nullptr, file);
    return columnMeans(pixels, image.width, 4, [](const png_uint_16* pixel) {
        if (pixel[3] == 0) return Rgb(0.0);
        // Colours come multiplied by the opacity.
        const double opacity = pixel[3];
        const auto light = [&](int channel) { return linearOfSrgb(std::min(1.0, pixel[channel] / opacity)); };
        return Rgb(light(0), light(1), light(2)) * (opacity / 65535.0);
    });
}

}  // namespace

double linearOfSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::vector<Rgb> decodeSky(std::string_view png, const std::string& file) {
    PngControl control;
    png_image& image = control.image;
    if (!png_image_begin_read_from_memory(&image, png.data(), png.size()))
        throw InputError(file, fmt::format("this is no PNG picture: {}", image.message));
    if (image.width > kMostStripEntries || image.height > kMostSkyRows ||
        std::size_t{image.width} * image.height > kMostSkyPixels)
        throw InputError(
            file, fmt::format("the picture has {} x {} pixels, expected at most {} columns, {} "
                              "rows and {} pixels in all",
                              image.width, image.height, kMostStripEntries, kMostSkyRows, kMostSkyPixels));
    if (image.format & PNG_FORMAT_FLAG_LINEAR) {  // so libpng marks 16 bits
        const BarePng plain = bare(png);
        if (plain.isSrgb) return decodeDeepSrgb(plain.bytes, file);
        image.format = PNG_FORMAT_LINEAR_RGB;
        const auto pixels = pixelsOf<png_uint_16>(image, nullptr, file);
        return columnMeans(pixels, image.width, 3, [](const png_uint_16* pixel) {
            return Rgb(pixel[0], pixel[1], pixel[2]) / 65535.0;
        });
    }
    // Of 8 bits libpng would make linear light that is rounded to 1/65535: too coarse for the dark levels.
    image.format = PNG_FORMAT_RGB;
    std::array<double, 256> light;
    for (std::size_t level = 0; level < light.size(); ++level)
        light[level] = linearOfSrgb(static_cast<double>(level) / 255.0);
    const png_color black{0, 0, 0};
    const auto pixels = pixelsOf<png_byte>(image, &black, file);
    return columnMeans(pixels, image.width, 3, [&](const png_byte* pixel) {
        return Rgb(light[pixel[0]], light[pixel[1]], light[pixel[2]]);
    });
}

std::vector<Rgb> readSky(const std::filesystem::path& path) {
    return decodeSky(readFileOf(path, kMaxSkyBytes, "a PNG picture"), path.string());
}

}  // namespace halfdisk
