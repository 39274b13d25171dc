// How does one ray find its way through the grid? From cell to cell, as it flies.
#pragma once

#include "core/index/descent.h"

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

/// Calls visit(block) for the blocks of all cells that the ray enters before visit.T, until it returns false.
/// Amanatides & Woo 1987, "A fast voxel traversal algorithm for ray tracing"; but each place is reckoned anew
/// from the cell's number, so that roundings do not add up.
template <class Visit>
inline void crossCells(const IndexView& index, const FloatRay& single, Visit& visit) {
    const WallGrid& grid = index.grid;
    const BoxRay ray(single);
    const bool forwardX = ray.inverseX >= 0.0f, forwardY = ray.inverseY >= 0.0f;
    const float right = grid.left + static_cast<float>(grid.columns) * grid.side;
    const float top = grid.bottom + static_cast<float>(grid.rows) * grid.side;
    const float enterX = ((forwardX ? grid.left : right) - ray.ox) * ray.inverseX;
    const float enterY = ((forwardY ? grid.bottom : top) - ray.oy) * ray.inverseY;
    const float leaveX = ((forwardX ? right : grid.left) - ray.ox) * ray.inverseX;
    const float leaveY = ((forwardY ? top : grid.bottom) - ray.oy) * ray.inverseY;
    float enter = enterX > enterY ? enterX : enterY;
    enter = enter > 0.0f ? enter : 0.0f;
    // No wall comes as near to the grid's border as roundings here.
    if (!(enter <= (leaveX < leaveY ? leaveX : leaveY)) || enter > visit.T) return;
    std::int32_t x = cellAt(ray.ox + enter * single.dx - grid.left, grid.perSide, grid.columns);
    std::int32_t y = cellAt(ray.oy + enter * single.dy - grid.bottom, grid.perSide, grid.rows);
    while (x >= 0 && y >= 0 && x < grid.columns && y < grid.rows) {
        const std::uint32_t* start = index.cellStarts + static_cast<std::ptrdiff_t>(y) * grid.columns + x;
        for (std::uint32_t block = start[0]; block < start[1]; ++block)
            if (!visit(index.blocks[block])) return;
        const float exitX =
            (grid.left + static_cast<float>(x + (forwardX ? 1 : 0)) * grid.side - ray.ox) * ray.inverseX;
        const float exitY =
            (grid.bottom + static_cast<float>(y + (forwardY ? 1 : 0)) * grid.side - ray.oy) * ray.inverseY;
        const bool sideways = exitX < exitY;
        if ((sideways ? exitX : exitY) > visit.T) return;
        x += sideways ? (forwardX ? 1 : -1) : 0;
        y += sideways ? 0 : (forwardY ? 1 : -1);
    }
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
