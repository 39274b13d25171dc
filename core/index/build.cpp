#include "core/index/build.h"

#include <algorithm>
#include <cmath>

#include "core/index/build_parts.h"
#include "core/index/crossing.h"

namespace halfdisk {
namespace {

IndexFrame frameOf(const std::vector<Segment>& segments) {
    Vec2 least(kInfinity), most(-kInfinity);
    for (const Segment& s : segments) {
        least = glm::min(least, glm::min(s.a, s.b));
        most = glm::max(most, glm::max(s.a, s.b));
    }
    IndexFrame frame;
    frame.middle = 0.5 * least + 0.5 * most;
    const Vec2 half = 0.5 * most - 0.5 * least;
    int exponent = 0;
    std::frexp(std::max(half.x, half.y), &exponent);
    frame.scale = std::ldexp(1.0, -std::clamp(exponent, -1000, 1000));
    return frame;
}

void addList(const std::vector<Segment>& segments, IndexStore& store) {
    for (std::size_t first = 0; first < segments.size(); first += kWidth) {
        std::array<std::uint32_t, kWidth> walls{};
        const std::size_t count = std::min(kWidth, segments.size() - first);
        for (std::size_t i = 0; i < count; ++i) walls[i] = static_cast<std::uint32_t>(first + i);
        addBlock(segments, {walls.data(), count}, store);
    }
}

void addFew(const std::vector<Segment>& segments, IndexStore& store) {
    FewWalls& few = store.few.emplace_back();
    for (std::size_t i = 0; i < kMostFew; ++i) {
        constexpr Vec2 kNone(std::numeric_limits<double>::quiet_NaN());
        const bool isWall = i < segments.size();
        const Vec2 a = isWall ? segments[i].a : kNone, b = isWall ? segments[i].b : kNone;
        few.ax[i] = a.x;
        few.ay[i] = a.y;
        few.bx[i] = b.x;
        few.by[i] = b.y;
    }
}

}  // namespace

IndexStore buildSingle(const std::vector<Segment>& segments) {
    IndexStore store;
    store.single.resize((segments.size() + kWidth - 1) / kWidth);
    for (std::size_t i = 0; i < store.single.size() * kWidth; ++i) {
        constexpr Vec2 kNone(std::numeric_limits<double>::quiet_NaN());
        const bool isWall = i < segments.size();
        const Vec2 a = isWall ? segments[i].a : kNone, b = isWall ? segments[i].b : kNone;
        SingleWalls& walls = store.single[i / kWidth];
        walls.ax[i % kWidth] = static_cast<float>(a.x);
        walls.ay[i % kWidth] = static_cast<float>(a.y);
        walls.bx[i % kWidth] = static_cast<float>(b.x);
        walls.by[i % kWidth] = static_cast<float>(b.y);
    }
    return store;
}

void addBlock(const std::vector<Segment>& segments, std::span<const std::uint32_t> walls, IndexStore& store) {
    WallBlock& block = store.blocks.emplace_back();
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = 0; i < kWidth; ++i) {
        if (i >= walls.size()) {
            block.px[i] = block.py[i] = block.ex[i] = block.ey[i] = kNone;
            block.segment[i] = kNoSegment;
            continue;
        }
        const Segment& s = segments[walls[i]];
        const Vec2 p = (s.a - store.frame.middle) * store.frame.scale;
        const Vec2 e = (s.b - s.a) * store.frame.scale;
        block.px[i] = static_cast<float>(p.x);
        block.py[i] = static_cast<float>(p.y);
        block.ex[i] = static_cast<float>(e.x);
        block.ey[i] = static_cast<float>(e.y);
        block.segment[i] = walls[i];
    }
}

IndexStore buildIndex(const std::vector<Segment>& segments, Layout layout) {
    IndexStore store;
    store.frame = frameOf(segments);
    for (const Segment& s : segments) store.mostShift = std::max(store.mostShift, shiftOf(s));
    const bool isOrdinary = store.frame.scale > 1e-100 && store.frame.scale < 1e100;
    if (layout == Layout::list && segments.size() <= kMostFew && isOrdinary) {
        addFew(segments, store);
    } else if (layout == Layout::list) {
        addList(segments, store);
    } else if (layout == Layout::tree) {
        addTree(segments, store);
    } else {
        addGrid(segments, store);
    }
    return store;
}

}  // namespace halfdisk
