// How are linear light values stored as a picture? Portable float map: 32-bit floats, nothing lost but
// precision.
#include "app/pfm_image.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace halfdisk {
namespace {

constexpr std::size_t kFloatBytes = 4, kPixelBytes = 3 * kFloatBytes;

void appendFloat(std::string& bytes, double value) {
    const auto number = static_cast<float>(value);
    std::uint32_t bits;
    static_assert(sizeof bits == sizeof number);
    std::memcpy(&bits, &number, sizeof bits);
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((bits >> shift) & 0xFFu);
}

double floatAt(const char* bytes) {
    std::uint32_t bits = 0;
    for (unsigned k = 0; k < kFloatBytes; ++k)
        bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) << (8 * k);
    float number;
    std::memcpy(&number, &bits, sizeof number);
    return static_cast<double>(number);
}

std::size_t pixelAt(const LinearImage& image, std::uint32_t x, std::uint32_t row) {
    return static_cast<std::size_t>(row) * image.width + x;
}

}  // namespace

std::string encodePfm(const LinearImage& image) {
    std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    bytes.reserve(bytes.size() + kPixelBytes * image.pixels.size());
    for (std::uint32_t row = image.height; row-- > 0;)
        for (std::uint32_t x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) appendFloat(bytes, image.pixels[pixelAt(image, x, row)][c]);
    return bytes;
}

LinearImage decodePfm(std::string_view bytes) {
    LinearImage image;
    int header = 0;
    const std::string start(bytes.substr(0, 64));
    if (std::sscanf(start.c_str(), "PF\n%u %u\n-1.0%n", &image.width, &image.height, &header) != 2 ||
        header == 0)
        throw std::runtime_error("not a little-endian colour PFM");
    const std::string_view data = bytes.substr(static_cast<std::size_t>(header) + 1);
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
    if (data.size() % kPixelBytes != 0 || data.size() / kPixelBytes != count)
        throw std::runtime_error("a PFM whose size does not fit its pixels");
    image.pixels.resize(count);
    const char* at = data.data();
    for (std::uint32_t row = image.height; row-- > 0;)
        for (std::uint32_t x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c, at += kFloatBytes)
                image.pixels[pixelAt(image, x, row)][c] = floatAt(at);
    return image;
}

}  // namespace halfdisk
