#include "cover.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

constexpr double kOnWall = 1e-9;  // of the wall's length

// From so far in front of it (in shifts of an origin) a ray back to a place tells what is met there.
constexpr double kLookingFrom = 1000.0;
// Where single precision decides, two of its roundings must do, which are large: a shift is eight of
// double's.
constexpr double kLookingFromInSingle = 0x1p29 / 4.0;

double leftOf(const Segment& wall) {
    return std::min(wall.a.x, wall.b.x);
}
double rightOf(const Segment& wall) {
    return std::max(wall.a.x, wall.b.x);
}

/// Whether a part of `other` lies on the wall's line, beside the wall.
bool liesAlong(const Segment& other, const Segment& wall) {
    const Vec2 edge = wall.b - wall.a;
    const double squared = glm::dot(edge, edge);
    // Of both ends: where along the wall (u), and how far off its line, in lengths of the wall.
    const double uA = glm::dot(other.a - wall.a, edge) / squared,
                 uB = glm::dot(other.b - wall.a, edge) / squared;
    const double from = std::max(0.0, std::min(uA, uB)), to = std::min(1.0, std::max(uA, uB));
    if (to - from <= kOnWall) return false;
    const double offA = cross(edge, other.a - wall.a) / squared,
                 offB = cross(edge, other.b - wall.a) / squared;
    const auto isNear = [&](double u) {
        return std::abs(offA + (u - uA) / (uB - uA) * (offB - offA)) <= kOnWall;
    };
    return isNear(from) && isNear(to);
}

}  // namespace

bool mayLieOver(const Scene& scene, std::uint32_t other, std::uint32_t wall) {
    if (other == wall) return false;
    const Segment &upper = scene.segments[other], &lower = scene.segments[wall];
    const bool sameWay = glm::dot(upper.b - upper.a, lower.b - lower.a) > 0.0;
    const bool facesBack = (!sameWay || upper.twoSided) && !lower.twoSided;
    return (other < wall || facesBack) && liesAlong(upper, lower);
}

std::uint32_t wallOver(const SegmentIndex& index, const ShadedPoint& at) {
    if (at.segment == kNoSegment) return kNoSegment;
    const bool single = precisionOf(index.method()) == Precision::single;
    const double shifts = single ? kLookingFromInSingle : kLookingFrom;
    const Hit hit = index.closestHit({at.P + at.N * (shifts * index.originShift(at.segment)), -at.N});
    return hit && mayLieOver(index.scene(), hit.segment, at.segment) ? hit.segment : kNoSegment;
}

CoveredWalls::CoveredWalls(const SegmentIndex& index, std::span<const std::uint32_t> walls) {
    const Scene& scene = index.scene();
    std::vector<std::uint32_t> fromLeft(walls.begin(), walls.end());
    const auto left = [&](std::uint32_t wall) { return leftOf(scene.segments[wall]); };
    std::sort(fromLeft.begin(), fromLeft.end(),
              [&](std::uint32_t one, std::uint32_t other) { return left(one) < left(other); });
    double widest = 0.0;
    for (const std::uint32_t wall : fromLeft)
        widest = std::max(widest, rightOf(scene.segments[wall]) - left(wall));
    for (std::uint32_t other = 0; other < scene.segments.size(); ++other) {
        const Segment& segment = scene.segments[other];
        const double reach = kOnWall * widest, first = leftOf(segment) - widest - reach,
                     last = rightOf(segment) + reach;
        auto wall = std::lower_bound(fromLeft.begin(), fromLeft.end(), first,
                                     [&](std::uint32_t candidate, double x) { return left(candidate) < x; });
        for (; wall != fromLeft.end() && left(*wall) <= last; ++wall)
            if (mayLieOver(scene, other, *wall)) partly_.push_back(*wall);
    }
    std::sort(partly_.begin(), partly_.end());
    partly_.erase(std::unique(partly_.begin(), partly_.end()), partly_.end());
}

}  // namespace halfdisk
