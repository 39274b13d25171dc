// What do the ways of building an index share?
#pragma once

#include <array>
#include <span>

#include "core/index/build.h"

namespace halfdisk {

/// Adds a block of up to kWidth walls.
void addBlock(const std::vector<Segment>& segments, std::span<const std::uint32_t> walls, IndexStore& store);

/// These fill a store whose frame is known.
void addTree(const std::vector<Segment>& segments, IndexStore& store);
void addGrid(const std::vector<Segment>& segments, IndexStore& store);

}  // namespace halfdisk
