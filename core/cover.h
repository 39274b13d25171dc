// Where does a wall lie behind another at the same place? Of walls that lie on each other only the one that a
// ray meets (SegmentIndex::closestHit) is there for light: behind it nothing arrives, and nothing sets out.
#pragma once

#include <span>
#include <vector>

#include "tracing.h"

namespace halfdisk {

/// Whether `other` lies along a part of `wall` (within 1e-9 of its length) and may go before it where a ray
/// meets both: because it was written first, or, at the wall's black back, because it faces the ray there.
bool mayLieOver(const Scene& scene, std::uint32_t other, std::uint32_t wall);

/// The wall that a place on a wall, on the side of its normal, lies behind; kNoSegment: none. One ray.
std::uint32_t wallOver(const SegmentIndex& index, const ShadedPoint& at);

inline bool isCovered(const SegmentIndex& index, const ShadedPoint& at) {
    return wallOver(index, at) != kNoSegment;
}

/// Prepared for many places on some walls: only those that something lies over cost a ray each.
class CoveredWalls {
 public:
    CoveredWalls() = default;
    /// O(n log k) of n walls in all and k `walls`, and the pairs of them that lie above each other.
    CoveredWalls(const SegmentIndex& index, std::span<const std::uint32_t> walls);

    bool isCovered(const SegmentIndex& index, const ShadedPoint& at) const {
        return mayBe(at.segment) && halfdisk::isCovered(index, at);
    }
    /// Walls of which a part may be covered, ascending.
    const std::vector<std::uint32_t>& all() const { return partly_; }

 private:
    bool mayBe(std::uint32_t segment) const {
        return !partly_.empty() && std::binary_search(partly_.begin(), partly_.end(), segment);
    }

    std::vector<std::uint32_t> partly_;
};

}  // namespace halfdisk
