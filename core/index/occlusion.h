// Is the way to a light free?
#pragma once

#include "core/index/cells.h"
#include "core/index/crossings.h"

namespace halfdisk {
namespace {

/// Whether wall `segment` stands between the ray's origin and a light at tMax, see SegmentIndex::occluded.
struct Shadow {
    const IndexView& index;
    const Ray& ray;
    double tMax, shifts;
    std::uint32_t lamp;

    Shadow(const IndexView& of, const Ray& along, double most, std::uint32_t light)
        : index(of),
          ray(along),
          tMax(most),
          shifts((light == kNoSegment ? 0.0 : shiftOf(of.segments[light])) +
                 (along.skip == kNoSegment ? 0.0 : shiftOf(of.segments[along.skip]))),
          lamp(light) {}

    bool operator()(std::uint32_t segment) const {
        if (segment == ray.skip || segment == lamp) return false;
        const Segment& s = index.segments[segment];
        const Crossing crossing = cross(s, ray);
        if (!crossing.met) return false;
        if (!liesOn(s, crossing, tMax, shifts, ray)) return crossing.t < tMax;
        return lamp == kNoSegment ? !crossing.front : facesRay(s, crossing.front) && segment < lamp;
    }
};

inline bool occludedByAny(const IndexView& index, const Ray& ray, double tMax, std::uint32_t lamp) {
    const Shadow shadow(index, ray, tMax, lamp);
    for (std::uint32_t i = 0; i < index.segmentCount; ++i)
        if (shadow(i)) return true;
    return false;
}

/// Looks for any wall that is in the way.
struct ShadowVisit {
    const Shadow& shadow;
    RayLanes lanes;
    float T;
    bool found = false;

    bool operator()(const WallBlock& block) {
        for (int first = 0; first < static_cast<int>(kWidth); first += kLanes) {
            const Lanes walls = testWalls(block, first, lanes, T);
            if (bits(walls.possible) == 0) continue;
            // Surely met, and surely before the light.
            const Mask before =
                lessEqual(walls.distance, mulSub(all(T), walls.slope, all(3.0f) * walls.slack));
            if (bits(walls.sure & before & isNot(shadow.ray.skip, block, first) &
                     isNot(shadow.lamp, block, first)) != 0) {
                found = true;
                return false;
            }
            for (unsigned left = bits(walls.possible); left != 0; left &= left - 1)
                if (shadow(block.segment[first + __builtin_ctz(left)])) {
                    found = true;
                    return false;
                }
        }
        return true;
    }
};

/// Whether a wall of a list surely stands in the way, or may (`unclear`). All walls, without a branch: one
/// that is guessed wrong costs as much as several blocks.
inline bool isBlocked(const IndexView& index, const Shadow& shadow, const RayLanes& lanes, float T,
                      bool& unclear) {
    unsigned sure = 0, maybe = 0;
    const Floats end = all(T);
    for (std::uint32_t i = 0; i < index.blockCount; ++i)
        for (int first = 0; first < static_cast<int>(kWidth); first += kLanes) {
            const WallBlock& block = index.blocks[i];
            const Lanes walls = testWalls(block, first, lanes, T);
            const Mask before = lessEqual(walls.distance, mulSub(end, walls.slope, all(3.0f) * walls.slack));
            sure |= bits(walls.sure & before & isNot(shadow.ray.skip, block, first) &
                         isNot(shadow.lamp, block, first));
            maybe |= bits(walls.possible);
        }
    unclear = maybe != 0;
    return sure != 0;
}

inline bool occluded(const IndexView& index, const Ray& ray, double tMax, std::uint32_t lamp) {
    const Shadow shadow(index, ray, tMax, lamp);
    FloatRay single;
    switch (fitRay(index, ray, single)) {
        case Fit::misses:
            return false;
        case Fit::fits:
            break;
        case Fit::tooLarge:
            return occludedByAny(index, ray, tMax, lamp);
    }
    const float upTo = single.upTo(tMax), T = upTo < kFar ? upTo : kFar;
    if (!index.cellStarts && index.nodeCount == 0) {
        bool unclear = false;
        const bool blocked = isBlocked(index, shadow, RayLanes(single), T, unclear);
        if (blocked || !unclear) return blocked;
    }
    ShadowVisit visit{shadow, RayLanes(single), T};
    forBlocks<false>(index, single, visit);
    return visit.found;
}

}  // namespace
}  // namespace halfdisk
