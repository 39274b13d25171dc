// What does a kernel answer? The methods of SegmentIndex, for one instruction set.
#pragma once

#include <new>

#include "core/index/fan.h"
#include "core/index/few_walls.h"
#include "core/index/kernels.h"
#include "core/index/occlusion.h"
#include "core/index/single.h"

namespace halfdisk {
namespace {

inline Hit answerClosest(const IndexView& index, const Ray& ray) {
    return index.few ? closestOfFew(index, ray) : closestHit(index, ray);
}

inline bool answerOccluded(const IndexView& index, const Ray& ray, double tMax, std::uint32_t lamp) {
    return index.few ? occludedByFew(index, ray, tMax, lamp) : occluded(index, ray, tMax, lamp);
}

inline void answerBatch(const IndexView& index, const Ray* rays, Hit* hits, std::size_t count) {
    if (!index.few) return closestHits(index, rays, hits, count);
    for (std::size_t i = 0; i < count; ++i)
        new (hits + i) Hit(closestOfFew(index, rays[i]));  // in place, see meet()
}

inline void answerFan(const IndexView& index, const Ray* rays, Hit* hits, std::size_t count) {
    if (index.few) return answerBatch(index, rays, hits, count);
    closestHitsFan(index, rays, hits, count);
}

inline void answerSingly(const IndexView& index, const Ray* rays, Hit* hits, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) new (hits + i) Hit(closestInSingle(index, rays[i]));
}

constexpr Kernels tableOf(InstructionSet instructions) {
    return {instructions, closestOfAll, occludedByAny, answerClosest, answerOccluded, answerBatch, answerFan};
}

/// closestOfAll stays, for scenes without walls.
constexpr Kernels singleTableOf(InstructionSet instructions) {
    return {instructions,     closestOfAll, occludedByAny, closestInSingle,
            occludedInSingle, answerSingly, answerSingly};
}

}  // namespace
}  // namespace halfdisk
