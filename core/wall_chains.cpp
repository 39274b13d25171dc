#include "wall_chains.h"

#include <map>
#include <tuple>

namespace halfdisk {
namespace {

constexpr std::uint32_t kUnplaced = 0xFFFFFFFF;

bool goesOnInto(const Segment& before, const Segment& after) {
    return isSmooth(before) && isSmooth(after) && before.b == after.a && before.normalB == after.normalA &&
           before.material == after.material && before.twoSided == after.twoSided;
}

// The wall that follows each one and the one before it, or kNoSegment. No wall has two of either.
struct Neighbours {
    std::vector<std::uint32_t> after, before;
};

Neighbours neighboursIn(const std::vector<Segment>& walls) {
    std::multimap<std::tuple<double, double>, std::uint32_t> starts;
    for (std::uint32_t i = 0; i < walls.size(); ++i)
        if (isSmooth(walls[i])) starts.emplace(std::tuple(walls[i].a.x, walls[i].a.y), i);
    Neighbours found{std::vector(walls.size(), kNoSegment), std::vector(walls.size(), kNoSegment)};
    for (std::uint32_t i = 0; i < walls.size(); ++i) {
        const auto [first, last] = starts.equal_range(std::tuple(walls[i].b.x, walls[i].b.y));
        for (auto next = first; next != last; ++next) {
            if (!goesOnInto(walls[i], walls[next->second]) || found.before[next->second] != kNoSegment)
                continue;
            found.after[i] = next->second;
            found.before[next->second] = i;
            break;
        }
    }
    return found;
}

}  // namespace

WallChains::WallChains(const SegmentIndex& index) {
    const auto& walls = index.scene().segments;
    const Neighbours next = neighboursIn(walls);
    links_.assign(walls.size(), Link{kUnplaced, 0.0, 0.0});
    const auto addChain = [&](std::uint32_t first, bool closed) {
        const auto chain = count();
        double length = 0.0;
        for (std::uint32_t i = first; i != kNoSegment && links_[i].chain == kUnplaced; i = next.after[i]) {
            links_[i] = {chain, length, index.length(i)};
            length += index.length(i);
        }
        lengths_.push_back(length);
        closed_.push_back(closed);
    };
    for (std::uint32_t i = 0; i < walls.size(); ++i)
        if (next.before[i] == kNoSegment) addChain(i, false);
    // What has no first wall is a ring.
    for (std::uint32_t i = 0; i < walls.size(); ++i)
        if (links_[i].chain == kUnplaced) addChain(i, true);
}

}  // namespace halfdisk
