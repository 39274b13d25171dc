// Which wall does a ray meet first?
#pragma once

#include "core/index/cells.h"
#include "core/index/crossings.h"
#include "core/index/pick.h"

namespace halfdisk {
namespace {

/// Looks for the first wall in single precision, which nearly always tells it for sure.
struct FirstWall {
    std::uint32_t skip;
    RayLanes lanes;
    float T = kFar;                 // no wall that may be met first lies beyond
    float contested = 2.0f * kFar;  // from here on there may be a wall besides `segment`
    float earliest = 2.0f * kFar;   // of `segment`
    std::uint32_t segment = kNoSegment;

    FirstWall(const Ray& ray, const FloatRay& single) : skip(ray.skip), lanes(single) {}

    bool isSure() const { return T < contested; }

    [[gnu::always_inline]] bool operator()(const WallBlock& block) {
        for (int first = 0; first < static_cast<int>(kWidth); first += kLanes) {
            const Lanes found = testWalls(block, first, lanes, T);
            // In a grid a wall comes in every cell that it touches.
            const Mask possible = found.possible & isNot(skip, block, first) & isNot(segment, block, first);
            if (bits(possible) == 0) continue;
            const Range range = rangeOf(found);
            alignas(64) float until[kLanes];
            store(until, range.until);
            int best = -1;
            for (unsigned sure = bits(possible & found.sure); sure != 0; sure &= sure - 1) {
                const int lane = __builtin_ctz(sure);
                best = until[lane] < T ? lane : best;
                T = until[lane] < T ? until[lane] : T;
            }
            // The walls of this block that may be the first, less the one that surely comes before T.
            unsigned others = bits(possible & notGreater(range.from, all(T)));
            if (best >= 0) {
                others &= ~(1u << best);
                contested = earliest < contested ? earliest : contested;
                segment = block.segment[first + best];
                earliest = range.from[best];
            }
            if (others != 0) contest(range.from, others);
        }
        return true;
    }

    void contest(Floats from, unsigned others) {
        for (; others != 0; others &= others - 1) {
            const float begin = from[__builtin_ctz(others)];
            contested = begin > contested ? contested : begin;  // begin, if it is NaN
        }
    }
};

/// Looks at every wall that single precision proposes in double precision.
struct ClosestVisit {
    const IndexView& index;
    const Ray& ray;
    const FloatRay& single;
    RayLanes lanes;
    Closest closest{};
    float T;

    ClosestVisit(const IndexView& of, const Ray& along, const FloatRay& inSingle, float end)
        : index(of), ray(along), single(inSingle), lanes(inSingle), T(end) {}

    bool operator()(const WallBlock& block) {
        for (int first = 0; first < static_cast<int>(kWidth); first += kLanes)
            for (unsigned left = bits(testWalls(block, first, lanes, T).possible); left != 0;
                 left &= left - 1)
                offer(block.segment[first + __builtin_ctz(left)]);
        return true;
    }

    void offer(std::uint32_t segment) {
        if (segment == ray.skip || !closest.offer(index, ray, segment)) return;
        const float nearest = single.upTo(closest.t());
        T = nearest < T ? nearest : T;
    }
};

/// Goes once more through the walls at the closest place, which are too many to have been kept.
struct CrowdVisit {
    ClosestVisit& from;
    Hit chosen;
    float T;

    bool operator()(const WallBlock& block) {
        for (int first = 0; first < static_cast<int>(kWidth); first += kLanes)
            for (unsigned left = bits(testWalls(block, first, from.lanes, T).possible); left != 0;
                 left &= left - 1) {
                const std::uint32_t segment = block.segment[first + __builtin_ctz(left)];
                if (segment == from.ray.skip) continue;
                const Crossing crossing = cross(from.index.segments[segment], from.ray);
                if (crossing.met) from.closest.prefer(from.index, from.ray, segment, crossing, chosen);
            }
        return true;
    }
};

/// The same in double precision alone.
inline Hit closestOfAll(const IndexView& index, const Ray& ray) {
    Closest closest;
    for (std::uint32_t i = 0; i < index.segmentCount; ++i)
        if (i != ray.skip) closest.offer(index, ray, i);
    Hit hit = closest.hit(index, ray);
    for (std::uint32_t i = 0; closest.isCrowded() && i < index.segmentCount; ++i) {
        const Crossing crossing = cross(index.segments[i], ray);
        if (i != ray.skip && crossing.met) closest.prefer(index, ray, i, crossing, hit);
    }
    return hit;
}

[[gnu::noinline]] Hit closestWithCare(const IndexView& index, const Ray& ray) {
    FloatRay single;
    if (fitRay(index, ray, single) != Fit::fits) return {};
    ClosestVisit visit(index, ray, single, kFar);
    forBlocks<true>(index, single, visit);
    const Hit hit = visit.closest.hit(index, ray);
    if (!visit.closest.isCrowded()) return hit;
    CrowdVisit crowd{visit, hit, visit.T};
    forBlocks<true>(index, single, crowd);
    return crowd.chosen;
}

/// Where a ray meets the wall that single precision is sure of; a miss for kNoSegment. Without a branch,
/// which would be guessed wrong wherever rays often leave the scene. Writes in place: a copy of what was just
/// written in parts has to wait for it.
[[gnu::always_inline]] inline void meet(const IndexView& index, const Ray& ray, std::uint32_t segment,
                                        Hit& hit) {
    const bool met = segment != kNoSegment;
    const Crossing crossing = crossPlainly(index.segments[pick(met, segment, 0u)], ray);
    hit.segment = segment;
    hit.t = pick(met, crossing.t, std::numeric_limits<double>::infinity());
    hit.u = pick(met, crossing.u, 0.0);
    hit.front = (met & crossing.front) != 0;
}

inline Hit closestHit(const IndexView& index, const Ray& ray) {
    FloatRay single;
    const Fit fit = fitRay(index, ray, single);
    if (fit != Fit::fits) return fit == Fit::misses ? Hit{} : closestOfAll(index, ray);
    FirstWall search(ray, single);
    forBlocks<true>(index, single, search);
    if (!search.isSure()) return closestWithCare(index, ray);
    Hit hit;
    meet(index, ray, search.segment, hit);
    return hit;
}

}  // namespace
}  // namespace halfdisk
