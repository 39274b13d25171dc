// How do wedges of rays go through the index? Along the cells or boxes that they cover.
#pragma once

#include "core/index/batch.h"
#include "core/index/wedge.h"

namespace halfdisk {
namespace {

/// Where a line at `place` along one axis meets a ray, along the other.
struct Slope {
    float origin, rise;

    float at(float distance) const { return origin + distance * rise; }
};

/// The cells that the wedge covers, slice by slice along the axis that it follows (Wald, Ize, Kensler, Knoll
/// & Parker 2006, "Ray tracing animated scenes using coherent grid traversal").
inline bool crossCells(const IndexView& index, Wedge& wedge) {
    const WallGrid& grid = index.grid;
    const bool alongX = __builtin_fabsf(wedge.middle.x) >= __builtin_fabsf(wedge.middle.y);
    const float origin = alongX ? wedge.ox : wedge.oy, first = alongX ? grid.left : grid.bottom,
                acrossFirst = alongX ? grid.bottom : grid.left;
    const float forward = (alongX ? wedge.middle.x : wedge.middle.y) >= 0.0f ? 1.0f : -1.0f;
    const std::int32_t slices = alongX ? grid.columns : grid.rows, across = alongX ? grid.rows : grid.columns;
    const Floats speed = abs(alongX ? wedge.dx : wedge.dy);
    const auto slopeOf = [&](Direction d) {
        return alongX ? Slope{wedge.oy, d.y / d.x} : Slope{wedge.ox, d.x / d.y};
    };
    const Slope a = slopeOf(wedge.left), b = slopeOf(wedge.right);
    const auto cellOf = [&](float place, std::int32_t count) {
        const float cell = place * grid.perSide;
        return !(cell >= 0.0f)                     ? -1
               : cell >= static_cast<float>(count) ? count
                                                   : static_cast<std::int32_t>(cell);
    };
    std::int32_t slice = cellOf(origin - first, slices);
    const std::int32_t step = forward > 0.0f ? 1 : -1;
    if (slice < 0 && step > 0) slice = 0;
    if (slice >= slices && step < 0) slice = slices - 1;
    for (; slice >= 0 && slice < slices; slice += step) {
        const float lower = first + static_cast<float>(slice) * grid.side - origin, upper = lower + grid.side;
        const float nearer = forward > 0.0f ? (lower > 0.0f ? lower : 0.0f) : (upper < 0.0f ? upper : 0.0f),
                    farther = forward > 0.0f ? upper : lower;
        if (nearer * forward > most(wedge.T * speed)) return true;
        const float a0 = a.at(nearer), a1 = a.at(farther), b0 = b.at(nearer), b1 = b.at(farther);
        const float low = __builtin_fminf(__builtin_fminf(a0, a1), __builtin_fminf(b0, b1)),
                    high = __builtin_fmaxf(__builtin_fmaxf(a0, a1), __builtin_fmaxf(b0, b1));
        std::int32_t cell = cellOf(low - acrossFirst, across);
        std::int32_t last = cellOf(high - acrossFirst, across);
        if (last < 0 || cell >= across) continue;
        cell = cell < 0 ? 0 : cell;
        last = last >= across ? across - 1 : last;
        for (; cell <= last; ++cell) {
            const std::uint32_t* start =
                index.cellStarts + (alongX ? static_cast<std::ptrdiff_t>(cell) * grid.columns + slice
                                           : static_cast<std::ptrdiff_t>(slice) * grid.columns + cell);
            for (std::uint32_t block = start[0]; block < start[1]; ++block)
                if (!wedge(index.blocks[block])) return false;
        }
    }
    return true;
}

/// Boxes that are not beside the wedge, one bit each, and the square of their distance in `keys`, as in
/// enterBoxes.
inline unsigned boxesWithin(const BoxNode& node, const Wedge& wedge, float reach, std::int32_t* keys) {
    const auto sideOf = [&](Direction d, bool largest, int first) {
        const float* y = (d.x >= 0.0f) == largest ? node.maxY : node.minY;
        const float* x = (d.y >= 0.0f) == largest ? node.minX : node.maxX;
        return mulSub(all(d.x), load(y + first) - wedge.oy, (load(x + first) - wedge.ox) * d.y);
    };
    unsigned found = 0;
    for (int first = 0; first < static_cast<int>(kWidth); first += kLanes) {
        const Floats minX = load(node.minX + first), minY = load(node.minY + first);
        const Floats x = max(max(minX - wedge.ox, wedge.ox - load(node.maxX + first)), Floats{}),
                     y = max(max(minY - wedge.oy, wedge.oy - load(node.maxY + first)), Floats{});
        const Floats distance = mulAdd(x, x, y * y);
        const Mask within = lessEqual(sideOf(wedge.left, false, first), all(wedge.sideSlack)) &
                            lessEqual(all(-wedge.sideSlack), sideOf(wedge.right, true, first)) &
                            lessEqual(distance, all(reach));
        found |= bits(within & lessEqual(minX, load(node.maxX + first))) << first;
        store(keys + first, (bitsOf(distance) & ~15) | load(kNumbers + first));
    }
    return found;
}

inline bool descendTree(const IndexView& index, Wedge& wedge) {
    const Floats length2 = mulAdd(wedge.dx, wedge.dx, wedge.dy * wedge.dy);
    WaitingStack stack;
    stack.entries[stack.count++] = waiting(0, 0);
    while (stack.count > 0) {
        const std::uint64_t next = stack.entries[--stack.count];
        const std::uint32_t child = childOf(next);
        const Floats ends = min(wedge.T, all(1e9f));
        const float reach = most(ends * ends * length2) * (1.0f + 0x1p-20f);
        if (enterOf(next) > reach) continue;
        if (child & kLeaf) {
            if (!wedge(index.blocks[child & ~kLeaf])) return false;
        } else {
            alignas(64) std::int32_t keys[kWidth + 1];
            const unsigned found = boxesWithin(index.nodes[child], wedge, reach, keys);
            pushSorted(index.nodes[child], keys, found, stack);
        }
    }
    return true;
}

/// Answers kLanes rays. False if they are no wedge.
inline bool closestHitsOfWedge(const IndexView& index, const Ray* rays, Hit* hits) {
    Wedge wedge;
    if (!wedge.gather(index, rays)) return false;
    if (index.cellStarts) {
        if (!crossCells(index, wedge)) return false;
    } else if (index.nodeCount > 0) {
        if (!descendTree(index, wedge)) return false;
    } else {
        for (std::uint32_t i = 0; i < index.blockCount; ++i) wedge(index.blocks[i]);
    }
    const unsigned contested = bits(lessEqual(wedge.contested, wedge.T));
    alignas(64) std::int32_t segments[kLanes];
    store(segments, wedge.segments);
    for (int i = 0; i < kLanes; ++i)
        if (contested >> i & 1u) {
            hits[i] = closestWithCare(index, rays[i]);
        } else {
            meet(index, rays[i], static_cast<std::uint32_t>(segments[i]), hits[i]);
        }
    return true;
}

inline void closestHitsFan(const IndexView& index, const Ray* rays, Hit* hits, std::size_t count) {
    std::size_t done = 0;
    // Where one wedge is of no use, its neighbours are not either.
    while (done + kLanes <= count && closestHitsOfWedge(index, rays + done, hits + done)) done += kLanes;
    closestHits(index, rays + done, hits + done, count - done);
}

}  // namespace
}  // namespace halfdisk
