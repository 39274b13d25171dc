// What do rays of one origin have in common? As many as an instruction takes make a wedge: walls beside it
// are spared for all of its rays at once, and the others are tried with all of them at once.
#pragma once

#include "core/index/closest_hit.h"

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

}  // namespace
}  // namespace halfdisk
