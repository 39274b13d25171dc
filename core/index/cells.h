// How does one ray find its way through the grid? From cell to cell, as it flies.
#pragma once

#include "core/index/descent.h"
#include "core/index/pick.h"

namespace halfdisk {
namespace {

/// The grid's cell at a place, the nearest one if it lies outside.
inline std::int32_t cellAt(float place, float perSide, std::int32_t count) {
    const float cell = place * perSide;
    return !(cell >= 0.0f)                     ? 0
           : cell >= static_cast<float>(count) ? count - 1
                                               : static_cast<std::int32_t>(cell);
}

/// About where a ray's first cell is kept; exactly, if the ray starts within the grid.
inline const std::uint32_t* startCell(const IndexView& index, const FloatRay& ray) {
    const WallGrid& grid = index.grid;
    const std::int32_t x = cellAt(ray.ox - grid.left, grid.perSide, grid.columns),
                       y = cellAt(ray.oy - grid.bottom, grid.perSide, grid.rows);
    return index.cellStarts + static_cast<std::ptrdiff_t>(y) * grid.columns + x;
}

/// A ray's way from cell to cell.
/// Amanatides & Woo 1987, "A fast voxel traversal algorithm for ray tracing"; but each place is reckoned anew
/// from the cell's number, so that roundings do not add up.
struct CellWalk {
    BoxRay ray;
    std::int32_t x = 0, y = 0;  // the cell
    std::int32_t stepX, stepY;  // -1 or 1

    explicit CellWalk(const FloatRay& single)
        : ray(single), stepX(ray.inverseX >= 0.0f ? 1 : -1), stepY(ray.inverseY >= 0.0f ? 1 : -1) {}

    /// To the first cell. False if the ray passes by.
    bool enter(const WallGrid& grid, const FloatRay& single) {
        const bool forwardX = stepX > 0, forwardY = stepY > 0;
        const float right = grid.left + static_cast<float>(grid.columns) * grid.side;
        const float top = grid.bottom + static_cast<float>(grid.rows) * grid.side;
        const float enterX = ((forwardX ? grid.left : right) - ray.ox) * ray.inverseX;
        const float enterY = ((forwardY ? grid.bottom : top) - ray.oy) * ray.inverseY;
        const float leaveX = ((forwardX ? right : grid.left) - ray.ox) * ray.inverseX;
        const float leaveY = ((forwardY ? top : grid.bottom) - ray.oy) * ray.inverseY;
        float from = enterX > enterY ? enterX : enterY;
        from = from > 0.0f ? from : 0.0f;
        x = cellAt(ray.ox + from * single.dx - grid.left, grid.perSide, grid.columns);
        y = cellAt(ray.oy + from * single.dy - grid.bottom, grid.perSide, grid.rows);
        // No wall comes as near to the grid's border as roundings here.
        return from <= (leaveX < leaveY ? leaveX : leaveY);
    }

    /// To the next cell. False if the ray leaves this one behind T, or the grid.
    bool step(const WallGrid& grid, float T) {
        const float exitX =
            (grid.left + static_cast<float>(x + (stepX > 0 ? 1 : 0)) * grid.side - ray.ox) * ray.inverseX;
        const float exitY =
            (grid.bottom + static_cast<float>(y + (stepY > 0 ? 1 : 0)) * grid.side - ray.oy) * ray.inverseY;
        const bool sideways = exitX < exitY;
        x += pick(sideways, stepX, 0);
        y += pick(sideways, 0, stepY);
        const int isInside = (static_cast<std::uint32_t>(x) < static_cast<std::uint32_t>(grid.columns)) &
                             (static_cast<std::uint32_t>(y) < static_cast<std::uint32_t>(grid.rows));
        return (isInside & (pick(sideways, exitX, exitY) <= T)) != 0;
    }
};

/// Calls visit(block) for the blocks of all cells that the ray enters before visit.T, until it returns false.
template <class Visit>
inline void crossCells(const IndexView& index, const FloatRay& single, Visit& visit) {
    CellWalk walk(single);
    if (!walk.enter(index.grid, single)) return;
    do {
        const std::uint32_t* starts =
            index.cellStarts + static_cast<std::ptrdiff_t>(walk.y) * index.grid.columns + walk.x;
        for (std::uint32_t block = starts[0]; block < starts[1]; ++block)
            if (!visit(index.blocks[block])) return;
    } while (walk.step(index.grid, visit.T));
}

/// The same for whatever the index has.
template <bool kNearestFirst, class Visit>
inline void forBlocks(const IndexView& index, const FloatRay& ray, Visit& visit) {
    if (index.cellStarts) return crossCells(index, ray, visit);
    if (index.nodeCount > 0) return descendTree<kNearestFirst>(index, ray, visit);
    for (std::uint32_t i = 0; i < index.blockCount; ++i)
        if (!visit(index.blocks[i])) return;
}

}  // namespace
}  // namespace halfdisk
