// How do rays of one origin go together? A wedge of as many as an instruction takes: walls and boxes beside
// the wedge are spared for all of its rays at once, and the others are tried with all of them at once.
#pragma once

#include "core/index/batch.h"

namespace halfdisk {
namespace {

struct Direction {
    float x, y;
};

/// kLanes rays in order of their angle, over less than 45 degrees.
struct Wedge {
    float ox = 0.0f, oy = 0.0f;
    Direction left{}, right{}, middle{};  // the outermost rays, as seen from the origin
    float sideSlack = 0.0f, wallSlack = 0.0f;
    std::uint32_t skip = kNoSegment;
    Floats dx{}, dy{};

    // Far from their origin the rays of a wedge have nothing in common any more.
    static constexpr int kMostTried = 8 * kLanes;
    int tried = 0;

    // Of each ray, as in FirstWall.
    Floats T = all(kFar), contested = all(2.0f * kFar), earliest = all(2.0f * kFar);
    Ints segments = all(static_cast<std::int32_t>(kNoSegment));

    /// False if the rays are no such wedge.
    bool gather(const IndexView& index, const Ray* rays) {
        FloatRay single;
        if (fitRay(index, rays[0], single) != Fit::fits || single.start != 0.0) return false;
        ox = single.ox;
        oy = single.oy;
        sideSlack = single.sideSlack;
        wallSlack = single.wallSlack;
        alignas(64) float x[kLanes], y[kLanes];
        for (int i = 0; i < kLanes; ++i) {
            const Ray& ray = rays[i];
            const double size = farther(Pair{ray.direction.x, ray.direction.y});
            const bool alike = ray.skip == rays[0].skip && ray.origin.x == rays[0].origin.x &&
                               ray.origin.y == rays[0].origin.y;
            if (!alike || !(size >= 0.5 && size <= 1.0)) return false;
            x[i] = static_cast<float>(ray.direction.x);
            y[i] = static_cast<float>(ray.direction.y);
        }
        skip = rays[0].skip;
        dx = load(x);
        dy = load(y);
        const Direction first{x[0], y[0]}, last{x[kLanes - 1], y[kLanes - 1]};
        const float turn = first.x * last.y - first.y * last.x;
        left = turn > 0.0f ? last : first;
        right = turn > 0.0f ? first : last;
        middle = {x[kLanes / 2], y[kLanes / 2]};
        // Rounded products; the wedge is widened by far more.
        constexpr float kOff = 0x1p-22f;
        const Floats toLeft = mulSub(dx, all(left.y), dy * left.x),
                     toRight = mulSub(all(right.x), dy, right.y * dx);
        const bool ordered =
            bits(lessEqual(all(-kOff), toLeft) & lessEqual(all(-kOff), toRight)) == (1u << kLanes) - 1u;
        const float cosine = first.x * last.x + first.y * last.y;
        return ordered && cosine > 0.0f && (turn < 0.0f ? -turn : turn) < cosine;
    }

    /// Walls of a block that are not beside or behind the wedge, one bit each.
    unsigned wallsWithin(const WallBlock& block, int first) const {
        const Floats ax = load(block.px + first) - ox, ay = load(block.py + first) - oy;
        const Floats ex = load(block.ex + first), ey = load(block.ey + first);
        const auto sideOf = [&](Direction d) { return mulSub(all(d.x), ay, ax * d.y); };
        const auto along = [&](Direction d) { return mulSub(all(d.x), ey, ex * d.y); };
        const Floats l = sideOf(left), r = sideOf(right), lq = l + along(left), rq = r + along(right);
        const Direction across{-middle.y, middle.x};
        const Floats m = -sideOf(across), mq = m - along(across);
        const float slack = sideSlack + sideSlack;
        return bits(lessEqual(min(l, lq), all(slack)) & lessEqual(all(-slack), max(r, rq)) &
                    lessEqual(all(-slack), max(m, mq)));
    }

    /// False if it is of no use to go on together.
    bool operator()(const WallBlock& block) {
        for (int first = 0; first < static_cast<int>(kWidth); first += kLanes) {
            unsigned within = wallsWithin(block, first);
            tried += __builtin_popcount(within);
            for (; within != 0; within &= within - 1) tryWall(block, first + __builtin_ctz(within));
        }
        return tried <= kMostTried;
    }

    void tryWall(const WallBlock& block, int number) {
        if (block.segment[number] == skip) return;
        const Lanes found =
            testPairs(all(block.px[number] - ox), all(block.py[number] - oy), all(block.ex[number]),
                      all(block.ey[number]), dx, dy, all(sideSlack), all(wallSlack), T);
        if (bits(found.possible) == 0) return;
        const Range range = rangeOf(found);
        const Floats until = chosen(found.sure & found.possible, range.until, all(kFar));
        // NaN becomes 0, and is looked at with care.
        const Floats from = chosen(found.possible, max(range.from, Floats{}), all(2.0f * kFar));
        // In a grid a wall comes in every cell that it touches.
        const Ints id = all(static_cast<std::int32_t>(block.segment[number]));
        const Mask isNew = notEqual(id, segments), closer = less(until, T) & isNew;
        contested = min(contested, chosen(closer, earliest, chosen(isNew, from, all(2.0f * kFar))));
        earliest = chosen(closer, from, earliest);
        segments = chosen(closer, id, segments);
        T = chosen(closer, until, T);
    }
};

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
