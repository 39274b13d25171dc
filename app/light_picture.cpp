// What is a picture that grows while it is looked at? The film so far, and how it looks on the screen.
#include "app/light_picture.h"

#include <algorithm>
#include <cmath>

#include "lessons/lesson.h"

namespace halfdisk {
namespace {

constexpr double kFieldCells = 160.0;  // along the longer side
constexpr double kMargin = 0.04;       // of the longer side

constexpr std::uint32_t kProfileBins = 96;

}  // namespace

std::optional<Sensor> eyeStripOf(const Scene& scene) {
    if (!scene.eye) return std::nullopt;
    return EyeStrip{*scene.eye, kEyeStripPixels};
}

Sensor profileOf(std::uint32_t segment) {
    return Profile{{segment}, kProfileBins};
}

std::optional<double> noiseOf(const LightPicture& picture) {
    const PixelStatistics& pixels = picture.film.pixels;
    if (picture.film.passes < 2 || pixels.empty()) return std::nullopt;
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Statistics pixel = pixels[i];
        const Rgb error = pixel.standardError();
        sum += (pixel.mean.x + pixel.mean.y + pixel.mean.z) / 3.0;
        squares += glm::dot(error, error) / 3.0;
    }
    const double count = static_cast<double>(pixels.size());
    if (!(sum > 0.0)) return std::nullopt;
    return std::sqrt(squares / count) / (sum / count);
}

Sensor fieldOf(Vec2 min, Vec2 max) {
    const Vec2 size = max - min;
    const double longer = std::max({size.x, size.y, 1e-9});
    min -= kMargin * longer;
    max += kMargin * longer;
    const double cell = (1.0 + 2.0 * kMargin) * longer / kFieldCells;
    const Vec2 cells = glm::max(glm::round((max - min) / cell), Vec2(1.0));
    return Field{min, max, static_cast<std::uint32_t>(cells.x), static_cast<std::uint32_t>(cells.y)};
}

}  // namespace halfdisk
