// How does one ray find its way through the tree? Nearest boxes first, and one box or block at a time, so
// that several rays can take turns.
#pragma once

#include "core/index/block_test.h"

namespace halfdisk {
namespace {

constexpr float kFar = 1e30f;  // farther than anything; not infinity, which times 0 is NaN

/// Boxes that wait to be looked into: the child in the upper half, the bits of where the ray enters it in the
/// lower. At most all but one of the children of each level.
struct WaitingStack {
    static constexpr std::size_t kMost = kMostLevels * kWidth;
    std::uint64_t entries[kMost + 3];  // and room for some that are not there
    int count = 0;
};

inline std::uint64_t waiting(std::uint32_t child, std::int32_t enterBits) {
    return static_cast<std::uint64_t>(child) << 32 | static_cast<std::uint32_t>(enterBits);
}
inline std::uint32_t childOf(std::uint64_t entry) {
    return static_cast<std::uint32_t>(entry >> 32);
}
inline float enterOf(std::uint64_t entry) {
    const auto low = static_cast<std::uint32_t>(entry);
    float enter;
    __builtin_memcpy(&enter, &low, sizeof enter);
    return enter;
}

inline float inverseOf(float component) {
    constexpr float kLeast = 1e-12f;
    return 1.0f / (__builtin_fabsf(component) < kLeast ? __builtin_copysignf(kLeast, component) : component);
}

/// What the boxes need of a ray.
struct BoxRay {
    float ox, oy, inverseX, inverseY;

    explicit BoxRay(const FloatRay& ray)
        : ox(ray.ox), oy(ray.oy), inverseX(inverseOf(ray.dx)), inverseY(inverseOf(ray.dy)) {}
};

alignas(64) constexpr std::int32_t kNumbers[kWidth]{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// The children of a node that the ray enters before T, one bit each. `keys`, if asked for: the bits of
/// where, the last four replaced by the child's number.
inline unsigned enterBoxes(const BoxNode& node, const BoxRay& ray, float T, std::int32_t* keys) {
    const float* nearX = ray.inverseX >= 0.0f ? node.minX : node.maxX;
    const float* farX = ray.inverseX >= 0.0f ? node.maxX : node.minX;
    const float* nearY = ray.inverseY >= 0.0f ? node.minY : node.maxY;
    const float* farY = ray.inverseY >= 0.0f ? node.maxY : node.minY;
    unsigned found = 0;
    for (int first = 0; first < static_cast<int>(kWidth); first += kLanes) {
        const Floats enter = max(
            max((load(nearX + first) - ray.ox) * ray.inverseX, (load(nearY + first) - ray.oy) * ray.inverseY),
            Floats{});
        const Floats leave = min(
            min((load(farX + first) - ray.ox) * ray.inverseX, (load(farY + first) - ray.oy) * ray.inverseY),
            all(T));
        found |= bits(lessEqual(enter, leave)) << first;
        if (keys) store(keys + first, (bitsOf(enter) & ~15) | load(kNumbers + first));
    }
    return found;
}

/// How many of the keys of `found` are greater than `key`.
inline int rankOf(std::int32_t key, const std::int32_t* keys, unsigned found) {
    unsigned behind = 0;
    for (int first = 0; first < static_cast<int>(kWidth); first += kLanes)
        behind |= bits(less(all(key), load(keys + first))) << first;
    return __builtin_popcount(behind & found);
}

/// Puts the children `found` on the stack, the one with the least key on top. There is room for one key more.
inline void pushSorted(const BoxNode& node, std::int32_t* keys, unsigned found, WaitingStack& stack) {
    constexpr int kNone = static_cast<int>(kWidth);  // the number of a child that is not there
    keys[kNone] = INT32_MAX;
    unsigned left = found;
    std::uint64_t* const base = stack.entries + stack.count;
    stack.count += __builtin_popcount(found);
    const auto next = [&] {
        const int number = __builtin_ctz(left | 1u << kNone);
        left &= left - 1;
        return number;
    };
    const auto put = [&](int number) {
        const std::int32_t key = keys[number];
        base[rankOf(key, keys, found)] = waiting(node.child[key & 15], key & ~15);
    };
    // Mostly there are no more than three. Those that are not there go first, to where the last one will be:
    // a loop of unknown length would be guessed wrong time and again.
    const int first = next(), second = next(), third = next();
    while (left != 0) put(next());
    put(third);
    put(second);
    put(first);
}

/// The boxes that the ray enters, the nearest on top.
inline void pushNearestLast(const BoxNode& node, const BoxRay& ray, float T, WaitingStack& stack) {
    alignas(64) std::int32_t keys[kWidth + 1];
    const unsigned found = enterBoxes(node, ray, T, keys);
    pushSorted(node, keys, found, stack);
}

/// In no order: for rays that end at any wall.
inline void pushAll(const BoxNode& node, const BoxRay& ray, float T, WaitingStack& stack) {
    unsigned left = enterBoxes(node, ray, T, nullptr);
    std::uint64_t* const base = stack.entries + stack.count;
    stack.count += __builtin_popcount(left);
    // As above, the first three whether they are there or not.
    std::uint64_t* place = base;
    do {
        for (int i = 0; i < 3; ++i, left &= left - 1)
            *place++ = waiting(node.child[__builtin_ctz(left | 1u << (kWidth - 1))], 0);
    } while (left != 0);
}

/// Calls visit(block) for the blocks of all boxes that the ray enters before visit.T, until it returns false.
template <bool kNearestFirst, class Visit>
inline void descendTree(const IndexView& index, const FloatRay& ray, Visit& visit) {
    const BoxRay boxRay(ray);
    WaitingStack stack;
    stack.entries[stack.count++] = waiting(0, 0);
    while (stack.count > 0) {
        const std::uint64_t next = stack.entries[--stack.count];
        const std::uint32_t child = childOf(next);
        if (kNearestFirst && enterOf(next) > visit.T) continue;
        if (child & kLeaf) {
            if (!visit(index.blocks[child & ~kLeaf])) return;
        } else if (kNearestFirst) {
            pushNearestLast(index.nodes[child], boxRay, visit.T, stack);
        } else {
            pushAll(index.nodes[child], boxRay, visit.T, stack);
        }
    }
}

}  // namespace
}  // namespace halfdisk
