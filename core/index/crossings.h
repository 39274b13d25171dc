// Which wall is met first? Keeps the nearest crossing, and those that may lie at the same place.
#pragma once

#include "core/index/crossing.h"

namespace halfdisk {
namespace {

/// |cross(direction, edge)| (t_i - t_c) <= (shift_i + shift_c) |edge|: wall i lies within rounding of the
/// closest, c, and reaches over its place.
inline bool liesOn(const Segment& s, const Crossing& crossing, double t, double shifts, const Ray& ray) {
    const double ex = s.b.x - s.a.x, ey = s.b.y - s.a.y;
    const double length2 = ex * ex + ey * ey, length = __builtin_sqrt(length2), shift = shiftOf(s) + shifts;
    if (!(magnitude(crossing.t - t) * crossing.slope <= shift * length)) return false;
    // Else a wall that ends before the place and nearly points at the ray's origin would count as well.
    const double along = ((ray.origin.x + t * ray.direction.x - s.a.x) * ex +
                          (ray.origin.y + t * ray.direction.y - s.a.y) * ey) /
                         length2;
    const double margin = 4.0 * shift / length;
    return along >= -margin && along <= 1.0 + margin;
}

/// The nearest crossing (the lower index of two at the same t), and those that may share its place.
class Closest {
 public:
    double t() const { return segment_ == kNoSegment ? std::numeric_limits<double>::infinity() : at_.t; }

    /// True if it is nearer than what was known.
    bool offer(const IndexView& index, const Ray& ray, std::uint32_t segment) {
        const Crossing crossing = cross(index.segments[segment], ray);
        if (!crossing.met) return false;
        if (segment_ == kNoSegment) {
            segment_ = segment;
            at_ = crossing;
            return true;
        }
        const bool nearer = crossing.t < at_.t || (crossing.t == at_.t && segment < segment_);
        if (nearer) {
            keepIfNear(index, segment_, at_, crossing.t);
            segment_ = segment;
            at_ = crossing;
        } else {
            keepIfNear(index, segment, crossing, at_.t);
        }
        return nearer;
    }

    /// Too many walls at one place to keep: they must be gone through again, see prefer().
    bool isCrowded() const { return count_ > kMost; }

    /// Of the walls at the closest place, the one that faces the ray, then the lower index.
    Hit hit(const IndexView& index, const Ray& ray) const {
        if (segment_ == kNoSegment) return {};
        Hit chosen{segment_, at_.t, at_.u, at_.front};
        for (int i = 0; i < count_ && i < kMost; ++i) prefer(index, ray, segments_[i], ties_[i], chosen);
        return chosen;
    }

    /// `chosen` becomes this wall if it lies at the closest place and goes before it.
    void prefer(const IndexView& index, const Ray& ray, std::uint32_t segment, const Crossing& crossing,
                Hit& chosen) const {
        const bool faces = facesRay(index.segments[segment], crossing.front),
                   other = facesRay(index.segments[chosen.segment], chosen.front);
        const bool before = faces != other ? faces : segment < chosen.segment;
        if (before &&
            liesOn(index.segments[segment], crossing, at_.t, shiftOf(index.segments[segment_]), ray))
            chosen = {segment, crossing.t, crossing.u, crossing.front};
    }

 private:
    static constexpr int kMost = 4;

    void keepIfNear(const IndexView& index, std::uint32_t segment, const Crossing& crossing, double t) {
        const Segment& s = index.segments[segment];
        const double size = magnitude(s.b.x - s.a.x) + magnitude(s.b.y - s.a.y);
        if (!((crossing.t - t) * crossing.slope <= 2.0 * index.mostShift * size)) return;
        if (count_ < kMost) {
            segments_[count_] = segment;
            ties_[count_] = crossing;
        }
        ++count_;
    }

    std::uint32_t segment_ = kNoSegment;
    Crossing at_{};
    // Within generous rounding of the closest of their time: no wall at the last closest place is missed, for
    // it only came nearer to them.
    int count_ = 0;
    std::uint32_t segments_[kMost];
    Crossing ties_[kMost];
};

}  // namespace
}  // namespace halfdisk
