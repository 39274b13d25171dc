// How do thousands of rays look together? As a picture of their density: where many lie over each other it is
// denser, and never full.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/png_image.h"
#include "app/prepared_scene.h"

namespace halfdisk {

/// A straight line in a cloud that has two colours.
struct CloudLine {
    Vec2 from{0.0}, to{0.0};                  ///< m
    std::array<float, 2> weight{1.0f, 0.0f};  ///< 0 ... 1, how much it adds in each of the colours
};

/// More are not summed up, so that no sum overflows.
inline constexpr std::size_t kMostCloudLines = 1'000'000;

/// Cells of the longer side of a cloud's picture.
inline constexpr std::uint32_t kCloudSide = 1200;

/// How much of the lines lies in each cell. Sums of integers: the order of the lines does not matter.
struct CloudSums {
    static constexpr double kUnit = 2048.0;  ///< of a line of weight 1, one cell long

    Bounds area;
    std::uint32_t width = 0, height = 0;  ///< cells, square up to rounding

    /// In 1 / kUnit: the first colour in the lower half, the second in the upper. Rows from the top, with a
    /// border of one cell all round, where what lies beyond the edges is put and forgotten.
    std::vector<std::uint64_t> cells;
    std::uint64_t at(std::uint32_t x, std::uint32_t y) const {
        return cells[(y + std::size_t{1}) * stride() + x + 1];
    }
    std::size_t stride() const { return width + std::size_t{2}; }
};

/// Lines of about one cell's width with soft edges; what lies outside of `area`, and lines that have no
/// finite end, are left out. `side`: cells of the longer side. Nothing if `stop` says so on the way.
std::optional<CloudSums> sumUp(std::span<const CloudLine> lines, const Bounds& area, std::uint32_t side,
                               const std::function<bool()>& stop);

/// Premultiplied with its opacity, 1 - exp(-density times a factor of the whole picture): the usual place is
/// light, the densest are nearly full. Colours: ImGui's (IM_COL32).
Image cloudPicture(const CloudSums& sums, std::array<std::uint32_t, 2> colors);

/// A cloud as it is shown.
struct RayCloud {
    Bounds area;            ///< m, that the picture covers
    Image picture;          ///< premultiplied
    std::size_t lines = 0;  ///< all that are in it
};

}  // namespace halfdisk
