// Cells with blocks of the walls that touch them.
#include <algorithm>
#include <cmath>

#include "core/index/build_parts.h"

namespace halfdisk {
namespace {

// So many walls a cell, about: two blocks, mostly full.
constexpr double kWallsPerCell = 24.0;
constexpr double kMostCells = 1 << 24;

struct Flat {
    float x, y;
};

// Standard deviation of the cells' walls over their mean.
double unevenness(const std::vector<std::uint32_t>& ends) {
    const double cells = static_cast<double>(ends.size() - 1), mean = ends.back() / cells;
    double squares = 0.0;
    for (std::size_t cell = 0; cell + 1 < ends.size(); ++cell)
        squares += std::pow(ends[cell + 1] - ends[cell] - mean, 2);
    return std::sqrt(squares / cells) / mean;
}

struct GridBuilder {
    const std::vector<Segment>& segments;
    IndexStore& store;
    float pad;

    Flat inFrame(Vec2 p) const {
        const Vec2 q = (p - store.frame.middle) * store.frame.scale;
        return {static_cast<float>(q.x), static_cast<float>(q.y)};
    }

    void shape() {
        Flat least{1.0f, 1.0f}, most{-1.0f, -1.0f};
        for (const Segment& s : segments)
            for (const Vec2 end : {s.a, s.b}) {
                const Flat p = inFrame(end);
                least = {std::min(least.x, p.x), std::min(least.y, p.y)};
                most = {std::max(most.x, p.x), std::max(most.y, p.y)};
            }
        const double wide = most.x - least.x + 2.0 * pad, high = most.y - least.y + 2.0 * pad;
        const double cells =
            std::clamp(static_cast<double>(segments.size()) / kWallsPerCell, 1.0, kMostCells);
        // Square cells; a flat scene has one row of them.
        const double side = std::max(std::sqrt(wide * high / cells), std::max(wide, high) / cells);
        WallGrid& grid = store.grid;
        grid.side = static_cast<float>(side);
        grid.perSide = 1.0f / grid.side;
        grid.left = least.x - pad;
        grid.bottom = least.y - pad;
        grid.columns = static_cast<std::int32_t>(wide / side) + 1;
        grid.rows = static_cast<std::int32_t>(high / side) + 1;
    }

    static std::int32_t cellAt(float place, std::int32_t count) {
        return std::clamp(static_cast<std::int32_t>(place), 0, count - 1);
    }

    // Calls visit(cell) for all cells that a wall touches.
    template <class Visit>
    void forCells(const Segment& s, const Visit& visit) const {
        const WallGrid& grid = store.grid;
        const Flat a = inFrame(s.a), b = inFrame(s.b);
        const float minX = std::min(a.x, b.x) - pad, maxX = std::max(a.x, b.x) + pad;
        const std::int32_t firstX = cellAt((minX - grid.left) * grid.perSide, grid.columns),
                           lastX = cellAt((maxX - grid.left) * grid.perSide, grid.columns);
        const std::int32_t firstY =
                               cellAt((std::min(a.y, b.y) - pad - grid.bottom) * grid.perSide, grid.rows),
                           lastY = cellAt((std::max(a.y, b.y) + pad - grid.bottom) * grid.perSide, grid.rows);
        const float ex = b.x - a.x, ey = b.y - a.y;
        // Half the width of a widened cell, seen along the wall.
        const float reach = (0.5f * grid.side + pad) * (std::abs(ex) + std::abs(ey)) * (1.0f + 0x1p-20f) +
                            0x1p-22f * (std::abs(ex) + std::abs(ey));
        for (std::int32_t y = firstY; y <= lastY; ++y)
            for (std::int32_t x = firstX; x <= lastX; ++x) {
                const float cx = grid.left + (static_cast<float>(x) + 0.5f) * grid.side - a.x,
                            cy = grid.bottom + (static_cast<float>(y) + 0.5f) * grid.side - a.y;
                if (std::abs(cx * ey - cy * ex) <= reach)
                    visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) +
                          static_cast<std::size_t>(x));
            }
    }

    void fill() {
        const WallGrid& grid = store.grid;
        const std::size_t cells =
            static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
        std::vector<std::uint32_t> ends(cells + 1, 0);
        for (const Segment& s : segments) forCells(s, [&](std::size_t cell) { ++ends[cell + 1]; });
        for (std::size_t cell = 0; cell < cells; ++cell) ends[cell + 1] += ends[cell];
        std::vector<std::uint32_t> walls(ends[cells]);
        std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
        for (std::uint32_t i = 0; i < segments.size(); ++i)
            forCells(segments[i], [&](std::size_t cell) { walls[next[cell]++] = i; });
        store.unevenness = unevenness(ends);
        store.cellStarts.reserve(cells + 1);
        store.blocks.reserve(walls.size() / kWidth + cells / 2);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            store.cellStarts.push_back(static_cast<std::uint32_t>(store.blocks.size()));
            for (std::uint32_t first = ends[cell]; first < ends[cell + 1]; first += kWidth)
                addBlock(segments,
                         {walls.data() + first, std::min<std::size_t>(kWidth, ends[cell + 1] - first)},
                         store);
        }
        store.cellStarts.push_back(static_cast<std::uint32_t>(store.blocks.size()));
    }
};

}  // namespace

void addGrid(const std::vector<Segment>& segments, IndexStore& store) {
    GridBuilder builder{segments, store,
                        kCellPad + static_cast<float>(8.0 * store.mostShift * store.frame.scale)};
    builder.shape();
    builder.fill();
}

double gridWork(const std::vector<Segment>& segments) {
    if (segments.empty()) return 0.0;
    Vec2 least = segments.front().a, most = least;
    for (const Segment& s : segments)
        for (const Vec2 end : {s.a, s.b}) {
            least = glm::min(least, end);
            most = glm::max(most, end);
        }
    const double wide = most.x - least.x, high = most.y - least.y;
    const double count = static_cast<double>(segments.size());
    const double cells = std::clamp(count / kWallsPerCell, 1.0, kMostCells);
    const double side = std::max(std::sqrt(wide * high / cells), std::max(wide, high) / cells);
    double work = 0.0;
    for (const Segment& s : segments)
        work += (std::abs(s.b.x - s.a.x) / side + 1.0) * (std::abs(s.b.y - s.a.y) / side + 1.0);
    return work / count;
}

}  // namespace halfdisk
