#include "app/ray_cloud.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

/// Parts of a cell by which a line's place across it is told.
constexpr double kParts = 256.0;

/// A line in cells of a picture, from the left upper corner.
struct Stroke {
    Vec2 a, b;
};

/// The part of a line within 0 ... size; nothing if there is none, or it has no length.
std::optional<Stroke> clipped(Stroke stroke, Vec2 size) {
    const Vec2 way = stroke.b - stroke.a;
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0.0) {
            if (stroke.a[axis] < 0.0 || stroke.a[axis] > size[axis]) return std::nullopt;
            continue;
        }
        const double low = -stroke.a[axis] / way[axis], high = (size[axis] - stroke.a[axis]) / way[axis];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    // Also what is not finite ends here.
    if (!(enter < leave)) return std::nullopt;
    return Stroke{stroke.a + enter * way, stroke.a + leave * way};
}

std::uint32_t inUnits(double amount) {
    return static_cast<std::uint32_t>(amount + 0.5);
}

/// Walks along the axis on which the line is longer, one cell after the other, and shares what lies there
/// between the two cells next to the line.
void draw(CloudSums& sums, Stroke stroke, std::array<float, 2> weight) {
    const Vec2 way = glm::abs(stroke.b - stroke.a);
    const int along = way.x >= way.y ? 0 : 1, across = 1 - along;
    if (!(way[along] > 0.0)) return;
    if (stroke.a[along] > stroke.b[along]) std::swap(stroke.a, stroke.b);
    const double slope = (stroke.b[across] - stroke.a[across]) / way[along];
    const double perStep = glm::length(stroke.b - stroke.a) / way[along] * CloudSums::kUnit;
    const std::size_t strides[] = {2, std::size_t{2} * sums.width};
    const int counts[] = {static_cast<int>(sums.width), static_cast<int>(sums.height)};
    const double begin = stroke.a[along], end = stroke.b[along];
    const int first = static_cast<int>(begin), last = std::min(static_cast<int>(end), counts[along] - 1);
    const std::size_t next = strides[across];
    std::uint32_t* column = sums.cells.data() + static_cast<std::size_t>(first) * strides[along];
    const std::array whole{inUnits(perStep * static_cast<double>(weight[0])),
                           inUnits(perStep * static_cast<double>(weight[1]))};
    for (int cell = first; cell <= last; ++cell, column += strides[along]) {
        const double low = std::max(begin, static_cast<double>(cell)), high = std::min(end, cell + 1.0);
        if (high <= low) continue;
        const bool part = high - low < 1.0;
        // One cell further, so that it is not negative.
        const double place = stroke.a[across] + slope * (0.5 * (low + high) - begin) + 0.5;
        const int upper = static_cast<int>(place);
        const auto share = static_cast<std::uint32_t>((place - upper) * kParts + 0.5);
        std::uint32_t* at = column + static_cast<std::size_t>(upper) * next;
        const bool hasLower = upper > 0, hasUpper = upper < counts[across];
        for (std::size_t color = 0; color < 2; ++color) {
            if (whole[color] == 0) continue;
            const std::uint32_t all =
                part ? inUnits(perStep * (high - low) * static_cast<double>(weight[color])) : whole[color];
            const std::uint32_t second = (all * share + 128u) / 256u;
            if (hasLower) *(at + color - next) += all - second;
            if (hasUpper) at[color] += second;
        }
    }
}

/// What opacity is made of: at most one per unit; less if the densest places would be nearly full.
double opacityPerUnit(const CloudSums& sums) {
    // A few cells, next to a small lamp, may be full.
    constexpr double kShare = 0.98, kOpacityThere = 0.8;
    constexpr std::size_t kEvery = 7;
    std::vector<std::uint32_t> some;
    for (std::size_t i = 0; i + 1 < sums.cells.size(); i += 2 * kEvery)
        if (const std::uint32_t sum = sums.cells[i] + sums.cells[i + 1]; sum > 0) some.push_back(sum);
    if (some.empty()) return 1.0;
    const auto dense =
        some.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(some.size() - 1));
    std::nth_element(some.begin(), dense, some.end());
    return std::min(1.0, -std::log(1.0 - kOpacityThere) * CloudSums::kUnit / *dense);
}

}  // namespace

std::optional<CloudSums> sumUp(std::span<const CloudLine> lines, const Bounds& area, std::uint32_t side,
                               const std::function<bool()>& stop) {
    const Vec2 size = area.size();
    const double cell = std::max(size.x, size.y) / std::max(side, 1u);
    CloudSums sums;
    sums.area = area;
    if (!(cell > 0.0) || !std::isfinite(cell)) return sums;
    sums.width = std::max(1u, static_cast<std::uint32_t>(std::lround(size.x / cell)));
    sums.height = std::max(1u, static_cast<std::uint32_t>(std::lround(size.y / cell)));
    sums.cells.assign(std::size_t{2} * sums.width * sums.height, 0u);
    const Vec2 cells{static_cast<double>(sums.width), static_cast<double>(sums.height)};
    const Vec2 scale{size.x > 0.0 ? cells.x / size.x : 1.0, size.y > 0.0 ? cells.y / size.y : 1.0};
    const auto toCells = [&](Vec2 world) {
        return Vec2((world.x - area.min.x) * scale.x, (area.max.y - world.y) * scale.y);
    };
    constexpr std::size_t kLinesBetweenLooks = 512;
    for (std::size_t i = 0; i < std::min(lines.size(), kMostCloudLines); ++i) {
        if (stop && i % kLinesBetweenLooks == 0 && stop()) return std::nullopt;
        const CloudLine& line = lines[i];
        std::array<float, 2> weight = line.weight;
        for (float& each : weight) each = std::isfinite(each) ? std::clamp(each, 0.0f, 1.0f) : 0.0f;
        if (const auto part = clipped({toCells(line.from), toCells(line.to)}, cells))
            draw(sums, *part, weight);
    }
    return sums;
}

Image cloudPicture(const CloudSums& sums, std::array<std::uint32_t, 2> colors) {
    Image image{static_cast<int>(sums.width), static_cast<int>(sums.height), {}};
    image.rgba.assign(2 * sums.cells.size(), 0u);
    // Opacity by density: one exp for each entry, not for each cell.
    constexpr std::size_t kEntries = 2048;
    constexpr double kLargest = 8.0;  // nothing shows through
    std::array<float, kEntries + 1> opacities;
    for (std::size_t i = 0; i <= kEntries; ++i)
        opacities[i] = 255.0f * (1.0f - std::exp(static_cast<float>(-kLargest * static_cast<double>(i) /
                                                                    static_cast<double>(kEntries))));
    const auto toEntry = static_cast<float>(opacityPerUnit(sums) / CloudSums::kUnit *
                                            static_cast<double>(kEntries) / kLargest);
    std::array<std::array<float, 3>, 2> channels;
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t k = 0; k < 3; ++k)
            channels[c][k] = static_cast<float>((colors[c] >> (8 * k)) & 255u) / 255.0f;
    for (std::size_t i = 0; i < sums.cells.size(); i += 2) {
        if ((sums.cells[i] | sums.cells[i + 1]) == 0) continue;
        const auto first = static_cast<float>(sums.cells[i]), second = static_cast<float>(sums.cells[i + 1]);
        const float entry = std::min(toEntry * (first + second), static_cast<float>(kEntries) - 0.5f);
        const auto low = static_cast<std::size_t>(entry);
        const float opacity =
            opacities[low] + (entry - static_cast<float>(low)) * (opacities[low + 1] - opacities[low]);
        const float share = second / (first + second);
        std::uint8_t* pixel = image.rgba.data() + 2 * i;
        for (std::size_t k = 0; k < 3; ++k)
            pixel[k] = static_cast<std::uint8_t>(
                opacity * (channels[0][k] + share * (channels[1][k] - channels[0][k])) + 0.5f);
        pixel[3] = static_cast<std::uint8_t>(opacity + 0.5f);
    }
    return image;
}

}  // namespace halfdisk
