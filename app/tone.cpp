// How does linear light become the bytes of a picture on a screen? A scale, and the sRGB curve.
#include "app/tone.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {

double automaticScale(const std::vector<Rgb>& pixels) {
    std::vector<double> brightest;
    brightest.reserve(pixels.size());
    for (const Rgb& pixel : pixels) brightest.push_back(std::max({pixel.x, pixel.y, pixel.z}));
    if (brightest.empty()) return 1.0;
    const auto place = static_cast<std::ptrdiff_t>((99 * brightest.size() + 99) / 100 - 1);
    std::nth_element(brightest.begin(), brightest.begin() + place, brightest.end());
    double white = brightest[static_cast<std::size_t>(place)];
    if (!(white > 0.0)) white = *std::max_element(brightest.begin(), brightest.end());
    const double scale = 1.0 / white;
    return white > 0.0 && std::isfinite(scale) ? scale : 1.0;
}

std::uint8_t srgbByte(double linear) {
    if (!(linear > 0.0)) return 0;
    const double clipped = std::min(linear, 1.0);
    const double curved =
        clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * std::pow(clipped, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * curved));
}

Image toned(const LinearImage& image, double scale) {
    Image bytes{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    bytes.rgba.reserve(4 * image.pixels.size());
    for (const Rgb& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c) bytes.rgba.push_back(srgbByte(scale * pixel[c]));
        bytes.rgba.push_back(255);
    }
    return bytes;
}

}  // namespace halfdisk
