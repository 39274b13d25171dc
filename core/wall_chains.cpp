#include "wall_chains.h"

#include "wall_contacts.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kUnplaced = 0xFFFFFFFF;

bool goesOnInto(const Segment& before, const Segment& after) {
    return isSmooth(before) && isSmooth(after) && before.b == after.a && before.normalB == after.normalA &&
           before.material == after.material && before.twoSided == after.twoSided;
}

struct WallEnd {
    Vec2 point, other;  // this end, and the wall's other one
    std::uint32_t wall;
    bool isStart;
};

bool isBefore(Vec2 a, Vec2 b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
}

std::vector<WallEnd> sortedEnds(const std::vector<Segment>& walls) {
    std::vector<WallEnd> ends;
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
        ends.push_back({walls[i].a, walls[i].b, i, true});
        ends.push_back({walls[i].b, walls[i].a, i, false});
    }
    std::sort(ends.begin(), ends.end(), [](const WallEnd& one, const WallEnd& other) {
        return one.point != other.point ? isBefore(one.point, other.point) : one.wall < other.wall;
    });
    return ends;
}

// The wall that follows each one and the one before it, or kNoSegment. No wall has two of either, and where
// another wall ends at their joint they do not follow each other.
struct Neighbours {
    std::vector<std::uint32_t> after, before;
};

Neighbours neighboursIn(const std::vector<Segment>& walls) {
    const std::vector<WallEnd> ends = sortedEnds(walls);
    Neighbours found{std::vector(walls.size(), kNoSegment), std::vector(walls.size(), kNoSegment)};
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
        if (!isSmooth(walls[i])) continue;
        const auto first =
            std::lower_bound(ends.begin(), ends.end(), walls[i].b,
                             [](const WallEnd& end, Vec2 point) { return isBefore(end.point, point); });
        const auto last =
            std::find_if(first, ends.end(), [&](const WallEnd& end) { return end.point != walls[i].b; });
        const auto next = std::find_if(first, last, [&](const WallEnd& end) {
            return end.isStart && goesOnInto(walls[i], walls[end.wall]) &&
                   found.before[end.wall] == kNoSegment;
        });
        const auto isOfBoth = [&](const WallEnd& end) {
            return end.other == walls[i].a || end.other == next->other;
        };
        if (next == last || !std::all_of(first, last, isOfBoth)) continue;
        found.after[i] = next->wall;
        found.before[next->wall] = i;
    }
    return found;
}

}  // namespace

WallChains::WallChains(const SegmentIndex& index) {
    const auto& walls = index.scene().segments;
    const std::vector<Vec2> corners = cornersOf(walls);
    const Neighbours next = neighboursIn(walls);
    links_.assign(walls.size(), Link{kUnplaced, 0.0, 0.0});
    const auto addChain = [&](std::uint32_t first, bool closed) {
        const auto chain = count();
        firstCut_.push_back(cuts_.size());
        cuts_.push_back(closed ? -kInfinity : 0.0);
        double length = 0.0;
        for (std::uint32_t i = first; i != kNoSegment && links_[i].chain == kUnplaced; i = next.after[i]) {
            links_[i] = {chain, length, index.length(i)};
            const std::vector<double> contacts = contactsOf(walls[i], corners);
            for (std::size_t k = 1; k + 1 < contacts.size(); ++k)
                cuts_.push_back(length + contacts[k] * index.length(i));
            length += index.length(i);
        }
        const std::size_t cuts = cuts_.size() - firstCut_.back() - 1;
        if (closed && cuts > 0) {
            // Each cut of a ring is met again a round later.
            cuts_[firstCut_.back()] = cuts_.back() - length;
            cuts_.push_back(cuts_[firstCut_.back() + 1] + length);
        } else {
            cuts_.push_back(closed ? kInfinity : length);
        }
        lengths_.push_back(length);
        closed_.push_back(closed);
    };
    for (std::uint32_t i = 0; i < walls.size(); ++i)
        if (next.before[i] == kNoSegment) addChain(i, false);
    // What has no first wall is a ring.
    for (std::uint32_t i = 0; i < walls.size(); ++i)
        if (links_[i].chain == kUnplaced) addChain(i, true);
    firstCut_.push_back(cuts_.size());
}

}  // namespace halfdisk
