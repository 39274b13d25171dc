#include "app/ray_cloud.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

/// Places across a line are counted in parts of a cell: a long line does not drift by one of 256.
constexpr int kPlaceBits = 40;
constexpr auto kOne = static_cast<double>(std::int64_t{1} << kPlaceBits);

/// A line in cells of a picture, from the left upper corner.
struct Stroke {
    Vec2 a, b;
};

/// The part of a line within a rectangle; nothing if there is none, or it has no length.
std::optional<Stroke> clipped(Stroke stroke, Vec2 min, Vec2 max) {
    const Vec2 way = stroke.b - stroke.a;
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0.0) {
            if (stroke.a[axis] < min[axis] || stroke.a[axis] > max[axis]) return std::nullopt;
            continue;
        }
        const double low = (min[axis] - stroke.a[axis]) / way[axis],
                     high = (max[axis] - stroke.a[axis]) / way[axis];
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    // Also what is not finite ends here.
    if (!(enter < leave)) return std::nullopt;
    return Stroke{glm::clamp(stroke.a + enter * way, min, max), glm::clamp(stroke.a + leave * way, min, max)};
}

/// Both colours at once, as in CloudSums.
std::uint64_t inUnits(double amount, std::array<float, 2> weight) {
    const auto units = [&](float share) {
        return static_cast<std::uint64_t>(amount * static_cast<double>(share) * CloudSums::kUnit + 0.5);
    };
    return units(weight[0]) | units(weight[1]) << 32;
}

/// Walks along the axis on which the line is longer, one cell after the other, and shares what lies there
/// between the two cells next to the line.
void draw(CloudSums& sums, Stroke stroke, std::array<float, 2> weight) {
    const Vec2 way = glm::abs(stroke.b - stroke.a);
    const int along = way.x >= way.y ? 0 : 1, across = 1 - along;
    if (!(way[along] > 0.0)) return;
    if (stroke.a[along] > stroke.b[along]) std::swap(stroke.a, stroke.b);
    const double slope = (stroke.b[across] - stroke.a[across]) / way[along];
    const double perStep = glm::length(stroke.b - stroke.a) / way[along];
    const std::size_t strides[] = {1, sums.stride()};
    const std::size_t forward = strides[along], sideways = strides[across];
    const double begin = stroke.a[along], end = stroke.b[along];
    const int limit = static_cast<int>(along == 0 ? sums.width : sums.height) - 1;
    const int first = std::min(static_cast<int>(begin), limit), last = std::min(static_cast<int>(end), limit);

    // The border makes everything start at 1, the middle of the first cell of a row is at 0.5, and of 256
    // parts the nearest is taken.
    const auto placeOf = [&](double at) {
        return static_cast<std::int64_t>((stroke.a[across] + slope * (at - begin) + 0.5 + 0.5 / 256.0) *
                                         kOne);
    };
    const auto put = [&](int cell, std::int64_t place, std::uint64_t amount) {
        std::uint64_t* at = sums.cells.data() + (static_cast<std::size_t>(cell) + 1) * forward +
                            static_cast<std::size_t>(place >> kPlaceBits) * sideways;
        const auto share = static_cast<std::uint64_t>(place >> (kPlaceBits - 8)) & 255u;
        // Each half by itself: none is so large that 256 times it reaches the other.
        const std::uint64_t second = ((amount * share) >> 8) & 0x00ffffff'00ffffffu;
        at[0] += amount - second;
        at[sideways] += second;
    };
    const auto putPart = [&](int cell) {
        const double low = std::max(begin, static_cast<double>(cell)), high = std::min(end, cell + 1.0);
        if (low < high) put(cell, placeOf(0.5 * (low + high)), inUnits(perStep * (high - low), weight));
    };
    putPart(first);
    if (last == first) return;
    const std::uint64_t whole = inUnits(perStep, weight);
    const auto step = static_cast<std::int64_t>(slope * kOne);
    std::int64_t place = placeOf(first + 1.5);
    for (int cell = first + 1; cell < last; ++cell, place += step) put(cell, place, whole);
    putPart(last);
}

float firstOf(std::uint64_t cell) {
    return static_cast<float>(static_cast<std::uint32_t>(cell));
}
float secondOf(std::uint64_t cell) {
    return static_cast<float>(static_cast<std::uint32_t>(cell >> 32));
}

/// What a density of 1 counts for: chosen by what is there, so that the usual is light enough for denser
/// places to be told from it.
double opacityPerUnit(const CloudSums& sums) {
    struct Aim {
        double share, opacity;  // of all cells with lines, and at most there
    };
    // A few cells, next to a small lamp, may be nearly full.
    constexpr Aim kAims[] = {{0.5, 0.35}, {0.98, 0.9}};
    constexpr double kMost = 4.0;  // thin lines are seen, where they are few
    constexpr std::size_t kEvery = 31;
    std::vector<double> some;
    for (std::size_t i = 0; i < sums.cells.size(); i += kEvery)
        if (const double sum = firstOf(sums.cells[i]) + secondOf(sums.cells[i]); sum > 0.0)
            some.push_back(sum);
    double perUnit = kMost;
    for (const Aim& aim : kAims) {
        if (some.empty()) break;
        const auto at =
            some.begin() + static_cast<std::ptrdiff_t>(aim.share * static_cast<double>(some.size() - 1));
        std::nth_element(some.begin(), at, some.end());
        perUnit = std::min(perUnit, -std::log(1.0 - aim.opacity) * CloudSums::kUnit / *at);
    }
    return perUnit;
}

std::array<float, 2> sensible(std::array<float, 2> weight) {
    for (float& each : weight) each = std::isfinite(each) ? std::clamp(each, 0.0f, 1.0f) : 0.0f;
    return weight;
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
    sums.cells.assign(sums.stride() * (sums.height + std::size_t{2}), 0u);
    const Vec2 cells{static_cast<double>(sums.width), static_cast<double>(sums.height)};
    const Vec2 scale{size.x > 0.0 ? cells.x / size.x : 1.0, size.y > 0.0 ? cells.y / size.y : 1.0};
    const auto toCells = [&](Vec2 world) {
        return Vec2((world.x - area.min.x) * scale.x, (area.max.y - world.y) * scale.y);
    };
    // Band by band, each so small that it stays in the processor's cache.
    constexpr std::size_t kBandBytes = 1u << 20;
    const std::size_t rowBytes = sums.stride() * sizeof(std::uint64_t);
    const double rows = static_cast<double>(std::max<std::size_t>(kBandBytes / rowBytes, 16));
    constexpr std::size_t kLinesBetweenLooks = 2048;
    for (double top = 0.0; top < cells.y; top += rows) {
        const double bottom = std::min(top + rows, cells.y);
        for (std::size_t i = 0; i < std::min(lines.size(), kMostCloudLines); ++i) {
            if (stop && i % kLinesBetweenLooks == 0 && stop()) return std::nullopt;
            const Stroke stroke{toCells(lines[i].from), toCells(lines[i].to)};
            const auto [high, low] = std::minmax(stroke.a.y, stroke.b.y);
            // A level line on the edge of two bands belongs to the lower one.
            const bool level = high == low;
            if (low < top || high > bottom || (level && low == bottom && bottom < cells.y)) continue;
            if (const auto part = clipped(stroke, {0.0, top}, {cells.x, bottom}))
                draw(sums, *part, sensible(lines[i].weight));
        }
    }
    return sums;
}

Image cloudPicture(const CloudSums& sums, std::array<std::uint32_t, 2> colors) {
    Image image{static_cast<int>(sums.width), static_cast<int>(sums.height), {}};
    image.rgba.assign(std::size_t{4} * sums.width * sums.height, 0u);
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
    std::uint8_t* pixel = image.rgba.data();
    for (std::uint32_t y = 0; y < sums.height; ++y)
        for (std::uint32_t x = 0; x < sums.width; ++x, pixel += 4) {
            const std::uint64_t cell = sums.at(x, y);
            if (cell == 0) continue;
            const float first = firstOf(cell), both = first + secondOf(cell);
            const float entry = std::min(toEntry * both, static_cast<float>(kEntries) - 0.5f);
            const auto low = static_cast<std::uint32_t>(entry);
            const float opacity =
                opacities[low] + (entry - static_cast<float>(low)) * (opacities[low + 1] - opacities[low]);
            const float share = first / both;
            for (std::size_t k = 0; k < 3; ++k)
                pixel[k] = static_cast<std::uint8_t>(
                    opacity * (channels[1][k] + share * (channels[0][k] - channels[1][k])) + 0.5f);
            pixel[3] = static_cast<std::uint8_t>(opacity + 0.5f);
        }
    return image;
}

}  // namespace halfdisk
