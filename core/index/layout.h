// What does the index keep of a scene? Single-precision copies of its walls in blocks, and a tree of boxes
// over the blocks.
//
// Single precision only proposes walls (but see single.h); whether and where a ray meets one is decided in
// double precision from the scene's own endpoints (crossing.h). So every method and every instruction set
// gives the same hits to the bit, and neighbours that share a vertex leak nothing.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/scene.h"

namespace halfdisk {

/// Walls in a block, and boxes in a node: as many as a 512-bit register has floats. Narrower registers take
/// them in parts.
inline constexpr std::size_t kWidth = 16;

/// The lanes of a block that hold no wall are NaN, which no comparison lets pass.
struct alignas(64) WallBlock {
    float px[kWidth], py[kWidth];  ///< an endpoint, in the index's frame
    float ex[kWidth], ey[kWidth];  ///< from it to the other one
    std::uint32_t segment[kWidth];
};

/// Walls of a scene that has no more than these, as they are: all are asked at once, in double precision. NaN
/// where there is no wall.
inline constexpr std::size_t kMostFew = 16;
struct alignas(64) FewWalls {
    double ax[kMostFew], ay[kMostFew], bx[kMostFew], by[kMostFew];  ///< m
};

/// Walls as a tracer in float keeps them: in the scene's own coordinates, rounded. NaN where there is no
/// wall.
struct alignas(64) SingleWalls {
    float ax[kWidth], ay[kWidth], bx[kWidth], by[kWidth];  ///< m
};

/// A child is a node, or a block if kLeaf is set.
inline constexpr std::uint32_t kLeaf = 0x80000000;

/// Boxes of up to kWidth children, widened by kBoxPad; a slot without a child is empty (min > max).
struct alignas(64) BoxNode {
    float minX[kWidth], minY[kWidth], maxX[kWidth], maxY[kWidth];
    std::uint32_t child[kWidth];
};

/// Widening of a box on each side: more than single precision may be off for rays that start within
/// kFarthestOrigin of the middle.
inline constexpr float kBoxPad = 0x1p-20f;
inline constexpr float kFarthestOrigin = 2.0f;

/// Square cells over the box of all walls, in the index's frame. A wall lies in all cells that it touches,
/// widened by kCellPad, in blocks of their own.
struct WallGrid {
    std::int32_t columns = 0, rows = 0;
    float left = 0.0f, bottom = 0.0f;
    float side = 1.0f, perSide = 1.0f;  // of a cell, and 1 / side
};
inline constexpr float kCellPad = 0x1p-19f;

/// Levels of a tree, at most: 16^7 walls and some room.
inline constexpr std::size_t kMostLevels = 12;

/// Moves the scene's middle to 0 and its farthest endpoint to between 0.5 and 1. The scale is a power of two,
/// so that it rounds nothing.
struct IndexFrame {
    Vec2 middle{0.0};    ///< m
    double scale = 1.0;  ///< 1/m
};

/// All that a kernel reads.
struct IndexView {
    const Segment* segments;
    const FewWalls* few;  ///< none: there are more, see the rest
    const WallBlock* blocks;
    std::uint32_t blockCount;
    const BoxNode* nodes;  ///< the root comes first; none: all blocks are tried
    std::uint32_t nodeCount;
    const std::uint32_t*
        cellStarts;  ///< a cell's first block, row by row, and one more; none: there is no grid
    WallGrid grid;
    std::uint32_t segmentCount;
    IndexFrame frame;
    double mostShift;  ///< m, the largest originShift of all walls
    float shiftSlack;  ///< in the index's frame, how far apart a light and its wall, or coincident walls, may
                       ///< be
    const SingleWalls* single;  ///< kWidth at a time, in the scene's order; none: see few and blocks
};

}  // namespace halfdisk
