// Into which pieces are walls cut, so that each can be taken to send out the same radiance everywhere?
#pragma once

#include <span>

#include "shadow_edges.h"

namespace halfdisk {

/// A piece of a wall's lit side: the side to the left of a->b.
struct Patch {
    Vec2 a, b;  ///< m
    std::uint32_t segment = kNoSegment;
    bool front = true;              ///< of the wall
    double uFrom = 0.0, uTo = 0.0;  ///< where it lies on the wall, uFrom < uTo
    double length = 0.0;            ///< m
    /// Lies behind another wall at the same place, which is met in its stead (SegmentIndex::closestHit).
    bool hidden = false;
};

/// How finely walls are cut.
struct PatchDivision {
    std::uint32_t wanted;                  ///< about so many patches in all, shared by length
    std::span<const WallPlace> cuts = {};  ///< places where sides are cut too
    std::uint32_t times = 1;               ///< each stretch in so many times as many
};

class Patches {
 public:
    static constexpr std::uint32_t kMost = 4000;

    /// Cuts every lit side where other walls end on it or cross it, then each stretch evenly: about `wanted`
    /// patches in all, shared by length, one at least. Throws std::invalid_argument if that takes more than
    /// kMost, and Stopped if `stop` says so.
    Patches(const Visibility& visibility, std::uint32_t wanted, const StopQuestion& stop = {});
    Patches(const Visibility& visibility, const PatchDivision& division, const StopQuestion& stop = {});

    const std::vector<Patch>& all() const { return patches_; }
    std::size_t size() const { return patches_.size(); }

    /// The numbers of a lit side's patches, in order of u: first ... end - 1.
    struct Range {
        std::size_t first, end;
    };
    Range of(std::uint32_t segment, bool front) const { return sides_[2 * segment + (front ? 0 : 1)]; }
    std::size_t sideCount() const { return sides_.size(); }

    /// Number of the patch at u of a lit side.
    std::size_t at(std::uint32_t segment, bool front, double u) const;

 private:
    std::vector<Patch> patches_;
    std::vector<Range> sides_;  // front and back of each segment; empty if not lit
};

/// Sides that can be lit: one for each wall, two for a two-sided one.
std::size_t litSides(const Scene& scene);

}  // namespace halfdisk
