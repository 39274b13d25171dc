// Which wall does a ray meet first, and is the way to a light free?
//
// Decided wall by wall in double precision (index/crossing.h); single precision and a tree of boxes only
// spare walls that cannot be met. Only where it is asked for (IndexMethod::single) does single precision
// decide.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/index/build.h"
#include "core/index/method.h"

namespace halfdisk {

/// A scene made ready for rays. Keeps a pointer to the scene, which must outlive it and stay as it is.
class SegmentIndex {
 public:
    /// Throws std::invalid_argument for a zero-length or non-finite segment or a material that does not
    /// exist.
    explicit SegmentIndex(const Scene& scene, IndexMethod method = IndexMethod::automatic,
                          const Kernels& kernels = bestKernels());
    SegmentIndex(const Scene&&, IndexMethod = {}, const Kernels& = bestKernels()) = delete;
    SegmentIndex(SegmentIndex&&) = default;
    SegmentIndex& operator=(SegmentIndex&&) = default;

    /// First wall at t > 0. Of walls that lie on each other there (within rounding) the one that faces the
    /// ray is met (a two-sided one faces all rays), then the lower index.
    Hit closestHit(const Ray& ray) const;

    /// Whether something stands between the ray's origin and a light at t = tMax: on the emitting segment
    /// `lamp`, or a point if that is kNoSegment. A wall that the light lies on does not hide it, unless it is
    /// met in the lamp's place (see closestHit) or, for a point, from its back. The origin may be shifted off
    /// ray.skip by its originShift.
    bool occluded(const Ray& ray, double tMax, std::uint32_t lamp = kNoSegment) const;

    /// The same for many rays at once; `hits` is as long as `rays`.
    void closestHits(std::span<const Ray> rays, std::span<Hit> hits) const;

    /// The same for rays that start at one place, in order of their angle: an eye's strip, a half-disk.
    void closestHitsFan(std::span<const Ray> rays, std::span<Hit> hits) const;

    /// Of many ways at once to points at tMax, or without end.
    void occluded(std::span<const Ray> rays, std::span<const double> tMax,
                  std::span<std::uint8_t> answers) const;

    const Scene& scene() const { return *scene_; }
    IndexMethod method() const { return method_; }  ///< the one in use, not `automatic`
    InstructionSet instructions() const { return kernels_->instructions; }
    std::size_t bytes() const { return store_.bytes(); }  ///< of what finds the walls, the scene itself apart
    /// Radiance that a ray in this direction meets if it meets no wall.
    Rgb environment(Vec2 direction) const { return radianceFrom(scene_->environment, direction); }
    bool hasGlass() const { return hasGlass_; }
    /// Segments that emit, ascending.
    const std::vector<std::uint32_t>& emitters() const { return emitters_; }
    Vec2 normal(std::uint32_t segment) const { return edges_[segment].normal; }
    const Material& material(std::uint32_t segment) const {
        return scene_->materials[scene_->segments[segment].material];
    }
    double length(std::uint32_t segment) const { return edges_[segment].length; }
    /// Whether it is a facet of a round thing (isSmooth).
    bool isRound(std::uint32_t segment) const { return edges_[segment].round; }

    /// Point at u of a segment, kept away from both ends so that it stays inside sharp corners too.
    Vec2 pointOn(std::uint32_t segment, double u) const;

    /// Bound (m) on how far a rounded point of this segment can lie from its line; twice over.
    double originShift(std::uint32_t segment) const { return edges_[segment].originShift; }

 private:
    struct Edge {
        Vec2 normal;         // of the front side
        double length;       // m
        double originShift;  // m
        double margin;       // of u at both ends, see pointOn
        bool round;          // a facet of a round thing: beside the normal, for every hit asks
    };

    void build();

    const Scene* scene_;
    IndexMethod method_;
    const Kernels* kernels_;
    IndexStore store_;
    IndexView view_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> emitters_;
    bool hasGlass_ = false;
};

// Here, for castRay asks for them with every ray.

inline Hit SegmentIndex::closestHit(const Ray& ray) const {
    return method_ == IndexMethod::everyWall ? kernels_->closestOfAll(view_, ray)
                                             : kernels_->closestHit(view_, ray);
}

inline bool SegmentIndex::occluded(const Ray& ray, double tMax, std::uint32_t lamp) const {
    return method_ == IndexMethod::everyWall ? kernels_->occludedByAny(view_, ray, tMax, lamp)
                                             : kernels_->occluded(view_, ray, tMax, lamp);
}

inline Vec2 SegmentIndex::pointOn(std::uint32_t segment, double u) const {
    const Segment& s = scene_->segments[segment];
    const double margin = edges_[segment].margin;
    return s.a + std::clamp(u, margin, 1.0 - margin) * (s.b - s.a);
}

}  // namespace halfdisk
