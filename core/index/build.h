// How is a scene's index built? Walls into blocks, blocks into a tree of boxes.
#pragma once

#include <vector>

#include "core/index/layout.h"
#include "core/ray.h"

namespace halfdisk {

struct IndexStore {
    IndexFrame frame;
    double mostShift = 0.0;
    std::vector<FewWalls> few;  ///< one, or none
    std::vector<SingleWalls> single;
    std::vector<WallBlock> blocks;
    std::vector<BoxNode> nodes;             ///< of a tree
    std::vector<std::uint32_t> cellStarts;  ///< of a grid
    WallGrid grid;
    double unevenness =
        0.0;  ///< of a grid: standard deviation of the cells' numbers of walls over their mean

    std::size_t bytes() const {
        return few.size() * sizeof(FewWalls) + single.size() * sizeof(SingleWalls) +
               blocks.size() * sizeof(WallBlock) + nodes.size() * sizeof(BoxNode) +
               cellStarts.size() * sizeof(std::uint32_t);
    }
};

/// How walls are found: all of them, by boxes, or by cells.
enum class Layout : std::uint8_t { list, tree, grid };

/// There are walls, and their coordinates are finite. In a list, the scene's order stays; else neighbours
/// share blocks.
IndexStore buildIndex(const std::vector<Segment>& segments, Layout layout);

/// All of them, in single precision.
IndexStore buildSingle(const std::vector<Segment>& segments);

/// About how many cells of a grid the walls' boxes cover, per wall. Long walls in great number make a grid
/// slow to build, and large.
double gridWork(const std::vector<Segment>& segments);

}  // namespace halfdisk
