// What is a picture that grows while it is looked at? The film so far, and how it looks on the screen.
#include "app/light_picture.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

constexpr std::uint32_t kStripPixels = 256;
constexpr double kFieldCells = 160.0;  // along the longer side
constexpr double kMargin = 0.04;       // of the longer side

}  // namespace

std::optional<Sensor> eyeStripOf(const Scene& scene) {
    if (!scene.eye) return std::nullopt;
    return EyeStrip{*scene.eye, kStripPixels};
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
