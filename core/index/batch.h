// How are many rays answered that have nothing in common? In turns, so that what one waits for from memory is
// fetched while others are looked at.
#pragma once

#include "core/index/closest_hit.h"

namespace halfdisk {
namespace {

inline void fetch(const void* first, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(static_cast<const char*>(first) + i);
}

/// Rays that take turns.
struct Group {
    static constexpr std::size_t kMost = 16;
    FloatRay single[kMost];
    Fit fit[kMost];
    const std::uint32_t* starts[kMost];
    std::uint32_t found[kMost];
    bool sure[kMost];
};

inline void closestHitsOfGroup(const IndexView& index, const Ray* rays, Hit* hits, std::size_t count) {
    Group group;
    for (std::size_t i = 0; i < count; ++i) {
        group.fit[i] = fitRay(index, rays[i], group.single[i]);
        if (!index.cellStarts || group.fit[i] != Fit::fits) continue;
        group.starts[i] = startCell(index, group.single[i]);
        __builtin_prefetch(group.starts[i]);
    }
    for (std::size_t i = 0; i < count && index.cellStarts; ++i)
        if (group.fit[i] == Fit::fits && group.starts[i][0] < index.blockCount)
            fetch(index.blocks + group.starts[i][0], sizeof(WallBlock));
    for (std::size_t i = 0; i < count; ++i) {
        if (group.fit[i] != Fit::fits) continue;
        FirstWall search(rays[i], group.single[i]);
        forBlocks<true>(index, group.single[i], search);
        group.sure[i] = search.isSure();
        group.found[i] = search.segment;
        if (search.segment != kNoSegment) __builtin_prefetch(index.segments + search.segment);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (group.fit[i] != Fit::fits) {
            hits[i] = group.fit[i] == Fit::misses ? Hit{} : closestOfAll(index, rays[i]);
        } else if (group.sure[i]) {
            meet(index, rays[i], group.found[i], hits[i]);
        } else {
            hits[i] = closestWithCare(index, rays[i]);
        }
    }
}

inline void closestHits(const IndexView& index, const Ray* rays, Hit* hits, std::size_t count) {
    for (std::size_t i = 0; i < count; i += Group::kMost)
        closestHitsOfGroup(index, rays + i, hits + i, count - i < Group::kMost ? count - i : Group::kMost);
}

}  // namespace
}  // namespace halfdisk
