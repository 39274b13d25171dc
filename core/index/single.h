// What would a tracer in float find? Each wall in single precision alone, several at a time: what it costs in
// truth, and what it spares in time.
//
// The rules are those of crossing.h, crossings.h and occlusion.h (signs at both ends, the skipped wall, walls
// that lie on each other, lamps and points), with float's rounding for double's. Walls and rays are rounded
// as they are, in the scene's own coordinates: far from the origin walls move, rays start beside where they
// should, and the shift that keeps an origin on its side of a corner (SegmentIndex::originShift) is lost.
// A wall whose ends round to one place is never met. Directions are about of unit length.
//
// All walls are asked, as in double precision up to 128 of them (intersect.cpp): up to there times compare.
// No fused multiply-add, so that every instruction set gives the same hits.
#pragma once

#include "core/index/crossing.h"
#include "core/index/pick.h"
#include "core/index/single_crossing.h"

namespace halfdisk {
namespace {

inline Hit hitInSingle(std::uint32_t segment, float sideA, float sideB, float t) {
    const float u = sideA / (sideA - sideB);
    return {segment, static_cast<double>(t), u >= 0.0f ? static_cast<double>(u) : 0.0, sideB > sideA};
}

/// One wall after the other. Of those that may lie at the nearest one's place: the one that faces the ray,
/// then the lower index.
[[gnu::noinline]] Hit closestInSingleWithCare(const IndexView& index, const SingleRay& ray) {
    SinglePlace nearest{false, kFar, kFar, kFar};
    Hit chosen;
    float off = 0.0f;
    for (std::uint32_t i = 0; i < index.segmentCount; ++i) {
        const SingleCrossing<float> c = crossInSingle(index, i, ray);
        const SinglePlace place = placeOf(c, ray);
        if (i == ray.skip || !place.met || !(place.t < nearest.t)) continue;
        nearest = place;
        chosen = hitInSingle(i, c.sideA, c.sideB, place.t);
        off = c.slack / c.size;
    }
    for (std::uint32_t i = 0; nearest.met && i < index.segmentCount; ++i) {
        const SingleCrossing<float> c = crossInSingle(index, i, ray);
        const SinglePlace place = placeOf(c, ray);
        if (i == ray.skip || !place.met || place.from > nearest.until) continue;
        const bool faces = facesRay(index.segments[i], comesFromFront(c)),
                   other = facesRay(index.segments[chosen.segment], chosen.front);
        const bool before = faces != other ? faces : i < chosen.segment;
        if (before && liesOn(c, place.t, nearest.t, off, ray))
            chosen = hitInSingle(i, c.sideA, c.sideB, place.t);
    }
    return chosen;
}

inline Hit closestInSingle(const IndexView& index, const Ray& along) {
    const SingleRay ray(along);
    const Ints skip = all(static_cast<std::int32_t>(ray.skip));
    // Of each lane: the nearest wall, where it may begin and end, and where another wall may begin.
    Floats nearest = all(kFar), from = all(2.0f * kFar), until = all(kFar), contested = all(2.0f * kFar);
    Floats sideA{}, sideB{};
    Ints found{};
    unsigned unclear = 0;
    for (std::uint32_t i = 0; i < index.segmentCount; i += kLanes) {
        const int first = static_cast<int>(i % kWidth);
        const SingleCrossing<Floats> c = crossInSingle(index.single[i / kWidth], first, ray);
        const Ints number = load(kNumbers) + static_cast<std::int32_t>(i);
        const Floats slope = abs(c.slope), perSlope = 1.0f / c.slope;
        const Floats t = c.distance * perSlope, slack = c.slack * abs(perSlope);
        const Mask split = isSplit(c) & notEqual(number, skip);
        const Mask met = split & less(Floats{}, t) & less(t, all(kFar)), closer = met & less(t, nearest);
        unclear |= bits(split) & ~bits(crossesPlainly(c, slope, ray));
        const Floats begin = t - slack;
        contested = min(contested, chosen(closer, from, chosen(met, begin, all(2.0f * kFar))));
        nearest = chosen(closer, t, nearest);
        from = chosen(closer, begin, from);
        until = chosen(closer, t + slack, until);
        sideA = chosen(closer, c.sideA, sideA);
        sideB = chosen(closer, c.sideB, sideB);
        found = chosen(closer, number, found);
    }
    const float t = least(nearest);
    const int lane = __builtin_ctz(bits(lessEqual(nearest, all(t))));
    alignas(64) std::int32_t walls[kLanes];
    alignas(64) float ends[kLanes], a[kLanes], b[kLanes];
    store(walls, found);
    store(ends, until);
    store(a, sideA);
    store(b, sideB);
    // Of the nearest wall's own lane only those that it displaced, or came behind it.
    const Floats begins = min(contested, chosen(notEqual(load(kNumbers), all(lane)), from, contested));
    if ((unclear | bits(lessEqual(begins, all(ends[lane])))) != 0) return closestInSingleWithCare(index, ray);
    // Without a branch, as in closest_hit.h.
    const bool met = t < kFar;
    const Hit hit = hitInSingle(static_cast<std::uint32_t>(walls[lane]), a[lane], b[lane], t);
    return {pick(met, hit.segment, kNoSegment), pick(met, hit.t, std::numeric_limits<double>::infinity()),
            pick(met, hit.u, 0.0), (met & hit.front) != 0};
}

/// A wall that the ray crosses at about the light's place or its own, or runs along.
inline bool hidesInSingle(const IndexView& index, const SingleRay& ray, std::uint32_t segment, float end,
                          std::uint32_t lamp) {
    const SingleCrossing<float> c = crossInSingle(index, segment, ray);
    const SinglePlace place = placeOf(c, ray);
    if (!place.met) return false;
    if (!liesOn(c, place.t, end, 0.0f, ray)) return place.t < end;
    const bool front = comesFromFront(c);
    return lamp == kNoSegment ? !front : facesRay(index.segments[segment], front) && segment < lamp;
}

inline bool occludedInSingle(const IndexView& index, const Ray& along, double tMax, std::uint32_t lamp) {
    const SingleRay ray(along);
    const Ints skip = all(static_cast<std::int32_t>(ray.skip)), light = all(static_cast<std::int32_t>(lamp));
    const float end = tMax < static_cast<double>(kFar) ? static_cast<float>(tMax) : kFar;
    for (std::uint32_t i = 0; i < index.segmentCount; i += kLanes) {
        const int first = static_cast<int>(i % kWidth);
        const SingleCrossing<Floats> c = crossInSingle(index.single[i / kWidth], first, ray);
        const Ints number = load(kNumbers) + static_cast<std::int32_t>(i);
        const Floats slope = abs(c.slope), distance = turned(c.distance, c.slope), reached = end * slope;
        const Mask plain = crossesPlainly(c, slope, ray), ahead = less(Floats{}, distance),
                   split = isSplit(c) & notEqual(number, skip) & notEqual(number, light);
        if (bits(split & plain & ahead & less(distance + c.slack, reached)) != 0) return true;
        const unsigned apart = bits(plain) & (bits(less(reached + c.slack, distance)) | ~bits(ahead));
        for (unsigned unclear = bits(split) & ~apart; unclear != 0; unclear &= unclear - 1)
            if (hidesInSingle(index, ray, i + static_cast<std::uint32_t>(__builtin_ctz(unclear)), end, lamp))
                return true;
    }
    return false;
}

}  // namespace
}  // namespace halfdisk
