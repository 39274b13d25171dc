// Which wall does a ray meet first, and is the way to a light free? Brute force over all segments: simple and
// clear.
//
// The test is the sign of cross(d, p - o) at both endpoints p: the ray's line separates them iff the signs
// differ. Zero counts as positive, and neighbours share their vertex bit for bit, so of two neighbours
// exactly one is hit: nothing leaks between them and nothing is hit twice.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "scene.h"

namespace halfdisk {

inline constexpr std::uint32_t kNoSegment = 0xFFFFFFFF;
inline constexpr std::uint32_t kNoMedium = 0xFFFFFFFF;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ray {
    Vec2 origin;                       ///< m
    Vec2 direction;                    ///< need not be of unit length; t counts in its length
    std::uint32_t skip = kNoSegment;   ///< the straight wall that the ray leaves, which it cannot meet again
    double pdfAngle = 0.0;             ///< density (1/rad) by which a half-disk drew it; 0: aimed, not drawn
    std::uint32_t medium = kNoMedium;  ///< the glass (an index into Scene::materials) that it runs in
    std::uint32_t speculars = 0;       ///< mirror and glass events in a row that it comes from
};

struct Hit {
    std::uint32_t segment = kNoSegment;
    double t = kInfinity;  ///< along the ray, in lengths of its direction
    double u = 0.0;        ///< along the segment, 0 at a and 1 at b
    bool front = false;    ///< the ray came from the front side (left of a->b)

    explicit operator bool() const { return segment != kNoSegment; }
};

/// A scene made ready for rays. Keeps a pointer to the scene, which must outlive it and stay as it is.
class SegmentIndex {
 public:
    /// Throws std::invalid_argument for a zero-length or non-finite segment or a material that does not
    /// exist.
    explicit SegmentIndex(const Scene& scene);

    /// First wall at t > 0. Of walls that lie on each other there (within rounding) the one that faces the
    /// ray is met, then the lower index.
    Hit closestHit(const Ray& ray) const;

    /// Whether something stands between the ray's origin and a light at t = tMax: on the emitting segment
    /// `lamp`, or a point if that is kNoSegment. A wall that the light lies on does not hide it, unless it is
    /// met in the lamp's place (see closestHit) or, for a point, from its back. The origin may be shifted off
    /// ray.skip by its originShift.
    bool occluded(const Ray& ray, double tMax, std::uint32_t lamp = kNoSegment) const;

    const Scene& scene() const { return *scene_; }
    /// Radiance that a ray in this direction meets if it meets no wall.
    Rgb environment(Vec2 direction) const { return radianceFrom(scene_->environment, direction); }
    bool hasGlass() const { return hasGlass_; }
    const std::vector<std::uint32_t>& emitters() const {
        return emitters_;
    }  ///< segments that emit, ascending
    Vec2 normal(std::uint32_t segment) const { return edges_[segment].normal; }
    const Material& material(std::uint32_t segment) const {
        return scene_->materials[scene_->segments[segment].material];
    }
    double length(std::uint32_t segment) const { return edges_[segment].length; }

    /// Point at u of a segment, kept away from both ends by `endMargin` so that it stays inside sharp corners
    /// too.
    Vec2 pointOn(std::uint32_t segment, double u) const;

    /// Bound (m) on how far a rounded point of this segment can lie from its line; twice over.
    double originShift(std::uint32_t segment) const { return edges_[segment].originShift; }

 private:
    struct Edge {
        Vec2 p, q;           // the endpoints in lexicographic order: coincident walls give bit-equal t
        Vec2 normal;         // of the front side
        double length;       // m
        double originShift;  // m
        bool flipped;        // p is b
    };

    struct Crossing {
        double t, u;  // u from p to q
        bool front;
    };
    static std::optional<Crossing> cross(const Edge& edge, const Ray& ray);
    double tieWidth(const Edge& edge, const Ray& ray, double shifts) const;

    const Scene* scene_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> emitters_;
    bool hasGlass_ = false;
};

}  // namespace halfdisk
