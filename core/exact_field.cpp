#include "exact_field.h"

#include <array>
#include <cmath>

#include "exact_picture.h"

namespace halfdisk {
namespace {

// Of the mean of a cell and its neighbours' light: below what is told of an error.
constexpr double kRelative = 1e-3;
constexpr int kQuarterings = 4;

/// Means over squares, one within another.
struct CellMean {
    const Radiosity& light;
    const StopQuestion& stop;
    ArcMemory memory{};
    Counts counts{};

    /// Gauss-Legendre, 2 x 2 points: exact for cubics.
    Rgb rule(Vec2 center, Vec2 half) {
        const double x = 1.0 / std::sqrt(3.0);
        Rgb sum{0.0};
        for (const Vec2 at : {Vec2(-x, -x), Vec2(x, -x), Vec2(-x, x), Vec2(x, x)})
            sum += light.fluence(center + half * at, counts, memory);
        return sum / 4.0;
    }

    Rgb over(Vec2 center, Vec2 half, Rgb whole, int left) {
        throwIfStopped(stop);
        const Vec2 quarter = half / 2.0;
        const std::array<Vec2, 4> centers{center + quarter * Vec2(-1.0, -1.0),
                                          center + quarter * Vec2(1.0, -1.0),
                                          center + quarter * Vec2(-1.0, 1.0), center + quarter};
        std::array<Rgb, 4> parts;
        Rgb mean{0.0};
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i] = rule(centers[i], quarter);
            mean += parts[i] / 4.0;
        }
        bool agreed = true;
        for (int channel = 0; channel < 3; ++channel)
            agreed = agreed && std::abs(mean[channel] - whole[channel]) <= kRelative * mean[channel];
        if (agreed || left == 0) return mean;
        mean = Rgb(0.0);
        for (std::size_t i = 0; i < parts.size(); ++i)
            mean += over(centers[i], quarter, parts[i], left - 1) / 4.0;
        return mean;
    }
};

}  // namespace

KnownCells exactCells(const Radiosity& light, const Field& field, std::size_t count,
                      const StopQuestion& stop) {
    const Vec2 cell = (field.max - field.min) / Vec2(field.width, field.height);
    const double all = static_cast<double>(field.width) * field.height;
    const auto stride = static_cast<std::uint32_t>(
        std::max(1.0, std::ceil(std::sqrt(all / static_cast<double>(std::max<std::size_t>(count, 1))))));
    KnownCells known;
    CellMean mean{light, stop};
    for (std::uint32_t row = (stride - 1) / 2; row < field.height; row += stride)
        for (std::uint32_t column = (stride - 1) / 2; column < field.width; column += stride) {
            const Vec2 center{field.min.x + (column + 0.5) * cell.x, field.max.y - (row + 0.5) * cell.y};
            known.pixels.push_back(row * field.width + column);
            known.mean.push_back(mean.over(center, cell / 2.0, mean.rule(center, cell / 2.0), kQuarterings));
        }
    return known;
}

std::optional<double> relativeError(const std::vector<Rgb>& pixels, const KnownCells& known,
                                    const Field& field) {
    if (pixels.size() != std::size_t{field.width} * field.height) return std::nullopt;
    std::vector<Rgb> found;
    for (const std::uint32_t pixel : known.pixels) found.push_back(pixels[pixel]);
    return relativeError(found, known.mean);
}

}  // namespace halfdisk
