#include "intersect.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace halfdisk {
namespace {

// Rounding of a point p + u (q - p), with unit roundoff h = epsilon / 2 and m the largest coordinate: the
// edge is off by h |e|, the product by h |e|, the sum by h m, and |e| <= 2 m: 5 h m a component, 3.6 epsilon
// m as a vector. Adding the shift along the normal rounds once more, 0.8 epsilon m. So 8 epsilon m puts the
// origin on the front side for sure, and no more than 13 epsilon m from the wall.
constexpr double kShiftRoundings = 8.0;

// A point is kept this many shifts away from the segment's ends. The shifted origin is at most 13/8 shifts
// off its wall, so it lies inside every corner of more than 13/8/128 rad (0.73 degrees) between two walls,
// and the other wall blocks as it should.
constexpr double kEndShifts = 128.0;

double sideOf(Vec2 point, const Ray& ray) {
    return cross(ray.direction, point - ray.origin);
}

void check(const Scene& scene, std::size_t i) {
    const Segment& s = scene.segments[i];
    const auto fail = [&](const char* what) {
        throw std::invalid_argument("segment " + std::to_string(i) + " " + what);
    };
    if (!isFinite(s.a) || !isFinite(s.b)) fail("has a coordinate that is not finite");
    const double length = glm::length(s.b - s.a);
    if (!(length > 0.0) || !std::isfinite(length)) fail("has no length");
    if (s.material >= scene.materials.size()) fail("names a material that does not exist");
}

}  // namespace

SegmentIndex::SegmentIndex(const Scene& scene) : scene_(&scene) {
    edges_.reserve(scene.segments.size());
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        check(scene, i);
        const Segment& s = scene.segments[i];
        const bool flipped = s.b.x < s.a.x || (s.b.x == s.a.x && s.b.y < s.a.y);
        const double largest = std::max({std::abs(s.a.x), std::abs(s.a.y), std::abs(s.b.x), std::abs(s.b.y)});
        const double shift = kShiftRoundings * std::numeric_limits<double>::epsilon() * largest;
        edges_.push_back({flipped ? s.b : s.a, flipped ? s.a : s.b, frontNormal(s), glm::length(s.b - s.a),
                          shift, flipped});
        hasGlass_ = hasGlass_ || std::holds_alternative<Dielectric>(scene.materials[s.material]);
        if (isEmitter(s)) emitters_.push_back(static_cast<std::uint32_t>(i));
    }
}

std::optional<SegmentIndex::Crossing> SegmentIndex::cross(const Edge& edge, const Ray& ray) {
    const double sideP = sideOf(edge.p, ray), sideQ = sideOf(edge.q, ray);
    if ((sideP >= 0.0) == (sideQ >= 0.0)) return std::nullopt;
    // The signs differ, so the difference is not 0; it equals cross(direction, q - p) and cannot disagree
    // with them.
    const double t = halfdisk::cross(edge.p - ray.origin, edge.q - edge.p) / (sideQ - sideP);
    if (!(t > 0.0)) return std::nullopt;
    // For a ray that comes from the front of a->b, b lies on its left: the positive side.
    return Crossing{t, sideP / (sideP - sideQ), (sideQ > sideP) != edge.flipped};
}

// Two walls that lie on each other are met at the same t but for rounding: each may be off its line by its
// shift.
double SegmentIndex::tieWidth(const Edge& edge, const Ray& ray, double shifts) const {
    return (edge.originShift + shifts) / std::abs(glm::dot(edge.normal, ray.direction));
}

Hit SegmentIndex::closestHit(const Ray& ray) const {
    Hit closest;
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        const Edge& edge = edges_[i];
        const auto crossing = cross(edge, ray);
        if (!crossing || i == ray.skip) continue;
        if (closest) {
            const double tie = tieWidth(edge, ray, edges_[closest.segment].originShift);
            const bool together = std::abs(crossing->t - closest.t) <= tie;
            const bool facesBetter = crossing->front && !closest.front;
            if (together ? !facesBetter : crossing->t > closest.t) continue;
        }
        closest = {i, crossing->t, edge.flipped ? 1.0 - crossing->u : crossing->u, crossing->front};
    }
    return closest;
}

bool SegmentIndex::occluded(const Ray& ray, double tMax, std::uint32_t lamp) const {
    const double shifts = (lamp == kNoSegment ? 0.0 : edges_[lamp].originShift) +
                          (ray.skip == kNoSegment ? 0.0 : edges_[ray.skip].originShift);
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        const auto crossing = cross(edges_[i], ray);
        if (!crossing || i == ray.skip || i == lamp) continue;
        if (std::isfinite(tMax)) {
            const double tie = tieWidth(edges_[i], ray, shifts);
            if (crossing->t > tMax + tie) continue;
            const bool lightIsOnIt = crossing->t >= tMax - tie;
            const bool hides = lamp == kNoSegment ? !crossing->front : crossing->front && i < lamp;
            if (lightIsOnIt && !hides) continue;
        }
        return true;
    }
    return false;
}

Vec2 SegmentIndex::pointOn(std::uint32_t segment, double u) const {
    const Edge& edge = edges_[segment];
    const double margin = std::min(0.5, kEndShifts * edge.originShift / edge.length);
    const double fromP = std::clamp(edge.flipped ? 1.0 - u : u, margin, 1.0 - margin);
    return edge.p + fromP * (edge.q - edge.p);
}

}  // namespace halfdisk
