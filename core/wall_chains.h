// Which walls go on into each other, so that something blurred along a wall may reach over its end? The
// facets of a round thing. A corner ends a chain, and another wall that stands on it or crosses it cuts it:
// what is blurred on one side of that wall stays there.
#pragma once

#include <algorithm>

#include "intersect.h"

namespace halfdisk {

/// A place on a chain of walls, by arc length.
struct ChainPlace {
    std::uint32_t chain = 0;
    double along = 0.0;  ///< m from the chain's start, in the direction of its walls
};

/// A stretch of a chain, m. On a ring it may begin below 0 or end above the ring's length: it goes over the
/// seam.
struct ChainStretch {
    double from = 0.0, to = 0.0;
};

/// Made once per scene. Every wall belongs to one chain; most are one of their own. A facet
/// (Segment::normalA) is followed by the one that starts at its end with the same normal and material.
class WallChains {
 public:
    /// See cornersOf for the time that it takes.
    explicit WallChains(const SegmentIndex& index);

    std::uint32_t count() const { return static_cast<std::uint32_t>(lengths_.size()); }
    double length(std::uint32_t chain) const { return lengths_[chain]; }  ///< m
    /// Its end is its start: a circle.
    bool isClosed(std::uint32_t chain) const { return closed_[chain]; }

    /// What lies about a place up to the chain's ends, or to where other walls touch it (on either side); of
    /// a ring that no wall touches, no end.
    ChainStretch stretchAt(std::uint32_t chain, double along) const {
        const auto first = cuts_.begin() + static_cast<std::ptrdiff_t>(firstCut_[chain]),
                   last = cuts_.begin() + static_cast<std::ptrdiff_t>(firstCut_[chain + 1]);
        const auto end = std::upper_bound(first + 1, last - 1, along);
        return {*(end - 1), *end};
    }

    /// `u` along the segment, 0 at a and 1 at b.
    ChainPlace at(std::uint32_t segment, double u) const {
        const Link& link = links_[segment];
        return {link.chain, link.start + u * link.length};
    }

    /// The other way: u of a place that lies on `segment`.
    double within(std::uint32_t segment, double along) const {
        const Link& link = links_[segment];
        return (along - link.start) / link.length;
    }

 private:
    struct Link {
        std::uint32_t chain;
        double start, length;  // m: along the chain, and of the segment
    };
    std::vector<Link> links_;  // by segment
    std::vector<double> lengths_;
    std::vector<bool> closed_;
    std::vector<double> cuts_;           // m, where stretches end, ascending within each chain
    std::vector<std::size_t> firstCut_;  // of each chain, and their number
};

}  // namespace halfdisk
