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
        return lamp == kNoSegment ? !crossing.front : crossing.front && segment < lamp;
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
    const float T = single.upTo(tMax);
    ShadowVisit visit{shadow, RayLanes(single), T < kFar ? T : kFar};
    forBlocks<false>(index, single, visit);
    return visit.found;
}

}  // namespace
}  // namespace halfdisk
