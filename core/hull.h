// What part of a wall stands between two others? The hull of two pieces that face each other, and what is cut
// off at its sides.
#pragma once

#include <array>
#include <optional>

#include "math.h"

namespace halfdisk {

/// A straight piece; where it has a side, that to the left of a->b.
struct Strand {
    Vec2 a, b;
};

/// What is left of a wall between two pieces. Ends that were cut off beside the view are no corners: behind
/// them the wall goes on.
struct Blocker {
    Strand at;
    bool cornerA = true, cornerB = true;
};

inline double lengthOf(const Strand& strand) {
    return glm::length(strand.b - strand.a);
}

/// All that lies to the left of a line. Heights over it are in units of the base's length.
struct LeftOf {
    Vec2 on, normal;
    double least;  // what rises no higher is on the line

    explicit LeftOf(const Strand& base, double rounding = 0.0)
        : on(base.a),
          normal(perp(base.b - base.a)),
          least(rounding == 0.0 ? 0.0 : rounding * lengthOf(base)) {}

    double height(Vec2 P) const { return glm::dot(normal, P - on); }
    bool hasNothingOf(const Strand& wall) const { return height(wall.a) <= least && height(wall.b) <= least; }
};

/// Cuts off what is not to the left. False if nothing is left that rises above the line.
inline bool cut(Blocker& wall, const LeftOf& side, bool cutIsCorner) {
    const double a = side.height(wall.at.a), b = side.height(wall.at.b);
    if (a <= side.least && b <= side.least) return false;
    if (a < 0.0) {
        wall.at.a += (wall.at.b - wall.at.a) * (a / (a - b));
        wall.cornerA = wall.cornerA && cutIsCorner;
    }
    if (b < 0.0) {
        wall.at.b += (wall.at.a - wall.at.b) * (b / (b - a));
        wall.cornerB = wall.cornerB && cutIsCorner;
    }
    return true;
}

/// The parts of both that lie in front of the other. False if there are none.
inline bool faceEachOther(Strand& from, Strand& to) {
    Blocker first{from}, second{to};
    if (!cut(first, LeftOf(to), true) || !cut(second, LeftOf(from), true)) return false;
    from = first.at;
    to = second.at;
    return from.a != from.b && to.a != to.b;
}

/// The hull of two pieces that face each other: from.a, from.b, to.a, to.b, counter-clockwise.
class Hull {
 public:
    Hull(const Strand& from, const Strand& to, double rounding)
        : faces_{LeftOf(from, rounding), LeftOf(to, rounding)} {
        // Pieces that share an end have no string there.
        for (const Strand& string : {Strand{from.b, to.a}, Strand{to.b, from.a}})
            if (lengthOf(string) > rounding) strings_[stringCount_++] = LeftOf(string, rounding);
    }

    /// The part of a wall within; empty if it does not reach in.
    std::optional<Blocker> partOf(const Strand& wall) const {
        for (const LeftOf& face : faces_)
            if (face.hasNothingOf(wall)) return std::nullopt;
        for (std::size_t i = 0; i < stringCount_; ++i)
            if (strings_[i].hasNothingOf(wall)) return std::nullopt;
        Blocker part{wall};
        for (const LeftOf& face : faces_)
            if (!cut(part, face, true)) return std::nullopt;
        for (std::size_t i = 0; i < stringCount_; ++i)
            if (!cut(part, strings_[i], false)) return std::nullopt;
        return part;
    }

 private:
    std::array<LeftOf, 2> faces_;
    std::array<LeftOf, 2> strings_ = faces_;  // between the two
    std::size_t stringCount_ = 0;
};

}  // namespace halfdisk
