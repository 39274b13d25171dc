// A tree of boxes over blocks of walls.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/index/build_parts.h"

namespace halfdisk {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

struct Box {
    float minX = kNothing, minY = kNothing, maxX = -kNothing, maxY = -kNothing;

    void add(const Box& other) {
        minX = std::min(minX, other.minX);
        minY = std::min(minY, other.minY);
        maxX = std::max(maxX, other.maxX);
        maxY = std::max(maxY, other.maxY);
    }
    /// A random line meets a box in proportion to its perimeter (Cauchy); 0 if empty.
    float perimeter() const { return maxX < minX ? 0.0f : (maxX - minX) + (maxY - minY); }
};

/// A wall in the index's frame.
struct Item {
    Box box;
    std::uint32_t segment;

    float middle(int axis) const { return axis == 0 ? box.minX + box.maxX : box.minY + box.maxY; }
};

struct Range {
    std::size_t first, count;
    Box box, middles;  // of the walls, and of their middles

    float cost() const { return box.perimeter() * static_cast<float>(count); }
};

class TreeBuilder {
 public:
    TreeBuilder(const std::vector<Segment>& segments, IndexStore& store)
        : segments_(segments), store_(store) {
        const double scale = store.frame.scale;
        const float pad = kBoxPad + static_cast<float>(8.0 * store.mostShift * scale);
        items_.reserve(segments.size());
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const Vec2 a = (segments[i].a - store.frame.middle) * scale,
                       b = (segments[i].b - store.frame.middle) * scale;
            const float ax = static_cast<float>(a.x), ay = static_cast<float>(a.y),
                        bx = static_cast<float>(b.x), by = static_cast<float>(b.y);
            items_.push_back({{std::min(ax, bx) - pad, std::min(ay, by) - pad, std::max(ax, bx) + pad,
                               std::max(ay, by) + pad},
                              i});
        }
    }

    void build() {
        store_.blocks.reserve(items_.size() / kWidth * 5 / 4 + 1);
        store_.nodes.emplace_back();
        fill(0, rangeOf(0, items_.size()), 1);
    }

 private:
    Range rangeOf(std::size_t first, std::size_t count) const {
        Range range{first, count, {}, {}};
        for (std::size_t i = first; i < first + count; ++i) {
            const Item& item = items_[i];
            range.box.add(item.box);
            range.middles.add({item.middle(0), item.middle(1), item.middle(0), item.middle(1)});
        }
        return range;
    }

    std::uint32_t addLeaf(const Range& range) {
        std::array<std::uint32_t, kWidth> walls{};
        for (std::size_t i = 0; i < range.count; ++i) walls[i] = items_[range.first + i].segment;
        addBlock(segments_, {walls.data(), range.count}, store_);
        return static_cast<std::uint32_t>(store_.blocks.size() - 1);
    }

    // Splits the range into as many parts as a node has room for, always the one that costs most; but none
    // that a child of full nodes can hold, so that nodes near the leaves are full.
    void fill(std::uint32_t node, const Range& whole, std::size_t level) {
        std::size_t enough = kWidth;
        while (enough * kWidth < whole.count) enough *= kWidth;
        std::array<Range, kWidth> parts;
        std::size_t count = 1;
        parts[0] = whole;
        while (count < kWidth) {
            std::size_t dearest = count;
            for (std::size_t i = 0; i < count; ++i)
                if (parts[i].count > enough && (dearest == count || parts[i].cost() > parts[dearest].cost()))
                    dearest = i;
            if (dearest == count) break;
            const auto [left, right] = split(parts[dearest], level);
            parts[dearest] = left;
            parts[count++] = right;
        }
        for (std::size_t i = 0; i < kWidth; ++i) {
            const Box box = i < count ? parts[i].box : Box{};
            BoxNode& at = store_.nodes[node];
            at.minX[i] = box.minX;
            at.minY[i] = box.minY;
            at.maxX[i] = box.maxX;
            at.maxY[i] = box.maxY;
            at.child[i] = 0;
            if (i >= count) continue;
            if (parts[i].count <= kWidth) {
                at.child[i] = kLeaf | addLeaf(parts[i]);
            } else {
                assert(level < kMostLevels);
                const auto child = static_cast<std::uint32_t>(store_.nodes.size());
                at.child[i] = child;
                store_.nodes.emplace_back();
                fill(child, parts[i], level + 1);
            }
        }
    }

    // Surface area heuristic over bins of the middles (Wald 2007, "On fast construction of SAH-based bounding
    // volume hierarchies"), along the longer side. Small ranges are then cut at a whole number of blocks, so
    // that blocks are full.
    std::pair<Range, Range> split(const Range& range, std::size_t level) {
        constexpr int kBins = 16;
        constexpr std::size_t kWholeBlocks = 512;
        const float wideX = range.middles.maxX - range.middles.minX,
                    wideY = range.middles.maxY - range.middles.minY;
        const int axis = wideX >= wideY ? 0 : 1;
        const float least = axis == 0 ? range.middles.minX : range.middles.minY,
                    wide = std::max(wideX, wideY);
        const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(range.first),
                   end = begin + static_cast<std::ptrdiff_t>(range.count);
        std::size_t left = range.count / 2;
        const float perBin = static_cast<float>(kBins) * 0.999f / wide;
        // Deep trees only come of walls in clusters of clusters; halves end them.
        const bool byBins = level < kMostLevels - 5 && std::isfinite(perBin);
        const auto binOf = [&](const Item& item) {
            return static_cast<int>((item.middle(axis) - least) * perBin);
        };
        if (byBins) {
            std::array<Box, kBins> boxes{};
            std::array<std::size_t, kBins> counts{};
            for (auto item = begin; item != end; ++item) {
                const auto bin = static_cast<std::size_t>(binOf(*item));
                boxes[bin].add(item->box);
                ++counts[bin];
            }
            std::array<float, kBins> rightCost{};
            Box right;
            std::size_t rightCount = 0;
            for (std::size_t b = kBins - 1; b > 0; --b) {
                right.add(boxes[b]);
                rightCount += counts[b];
                rightCost[b] = right.perimeter() * static_cast<float>((rightCount + kWidth - 1) / kWidth);
            }
            Box leftBox;
            std::size_t leftCount = 0, bestCount = 0;
            float best = kNothing;
            for (std::size_t b = 1; b < kBins; ++b) {
                leftBox.add(boxes[b - 1]);
                leftCount += counts[b - 1];
                const float cost =
                    leftBox.perimeter() * static_cast<float>((leftCount + kWidth - 1) / kWidth) +
                    rightCost[b];
                if (leftCount == 0 || leftCount == range.count || !(cost < best)) continue;
                best = cost;
                bestCount = leftCount;
            }
            assert(bestCount > 0);
            left = bestCount;
            if (range.count > kWholeBlocks) {
                std::size_t seen = 0;
                int cut = 0;
                while (seen < left) seen += counts[static_cast<std::size_t>(cut++)];
                std::partition(begin, end, [&](const Item& item) { return binOf(item) < cut; });
            }
        }
        if (!byBins || range.count <= kWholeBlocks) {
            left = std::clamp((left + kWidth / 2) / kWidth * kWidth, kWidth,
                              (range.count - 1) / kWidth * kWidth);
            std::nth_element(
                begin, begin + static_cast<std::ptrdiff_t>(left), end,
                [axis](const Item& a, const Item& b) { return a.middle(axis) < b.middle(axis); });
        }
        return {rangeOf(range.first, left), rangeOf(range.first + left, range.count - left)};
    }

    const std::vector<Segment>& segments_;
    IndexStore& store_;
    std::vector<Item> items_;
};

}  // namespace

void addTree(const std::vector<Segment>& segments, IndexStore& store) {
    TreeBuilder(segments, store).build();
}

}  // namespace halfdisk
