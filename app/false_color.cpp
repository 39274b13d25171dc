#include "app/false_color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/light_picture.h"

namespace halfdisk {
namespace {

struct Stop {
    double red, green, blue;
};

// Lightness rises evenly from stop to stop (about 10, 30, 50, 70, 90 of 100).
constexpr std::array<Stop, 5> kStops{
    {{20, 20, 70}, {30, 70, 140}, {20, 130, 125}, {110, 185, 70}, {250, 230, 70}}};

std::uint8_t byteOf(double value) {
    return static_cast<std::uint8_t>(std::lround(value));
}

}  // namespace

std::uint32_t packed(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    return 0xff000000u | static_cast<std::uint32_t>(blue) << 16 | static_cast<std::uint32_t>(green) << 8 |
           red;
}

std::uint32_t falseColor(double share) {
    const double at = (share > 0.0 ? std::min(share, 1.0) : 0.0) * (kStops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
    const double t = at - static_cast<double>(below);
    const Stop &a = kStops[below], &b = kStops[below + 1];
    return packed(byteOf(a.red + t * (b.red - a.red)), byteOf(a.green + t * (b.green - a.green)),
                  byteOf(a.blue + t * (b.blue - a.blue)));
}

std::uint32_t decadeColor(double value) {
    return falseColor(value > 0.0 ? 1.0 + std::log10(value) / kScaleDecades : 0.0);
}

}  // namespace halfdisk
