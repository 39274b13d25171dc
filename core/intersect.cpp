#include "intersect.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/index/crossing.h"

namespace halfdisk {
namespace {

// A point is kept this many shifts away from the segment's ends. The shifted origin is at most 13/8 shifts
// off its wall, so it lies inside every corner of more than 13/8/2048 rad (0.8e-3) between two walls,
// and the other wall blocks as it should.
constexpr double kEndShifts = 2048.0;

// Walls up to which trying all of them is faster than the tree.
constexpr std::size_t kMostByBruteForce = 128;

// Cells serve better than boxes from so many walls on, if they hold about as many each (by measurement: 0.3
// for walls strewn at random, 0.6 and more for round things made of walls).
constexpr std::size_t kLeastByGrid = 700;
constexpr double kMostUneven = 0.55;
constexpr double kMostGridWork = 64.0;  // walls strewn at random: about 4

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

SegmentIndex::SegmentIndex(const Scene& scene, IndexMethod method, const Kernels& kernels)
    : scene_(&scene),
      method_(method),
      kernels_(method == IndexMethod::single ? &singleKernels(kernels) : &kernels) {
    edges_.reserve(scene.segments.size());
    for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        check(scene, i);
        const Segment& s = scene.segments[i];
        const double length = glm::length(s.b - s.a), shift = shiftOf(s);
        edges_.push_back(
            {frontNormal(s), length, shift, std::min(0.5, kEndShifts * shift / length), isSmooth(s)});
        hasGlass_ = hasGlass_ || std::holds_alternative<Dielectric>(scene.materials[s.material]);
        if (isEmitter(s)) emitters_.push_back(static_cast<std::uint32_t>(i));
    }
    double mostShift = 0.0;
    for (const Edge& edge : edges_) mostShift = std::max(mostShift, edge.originShift);
    build();
    view_ = {.segments = scene.segments.data(),
             .few = store_.few.empty() ? nullptr : store_.few.data(),
             .blocks = store_.blocks.data(),
             .blockCount = static_cast<std::uint32_t>(store_.blocks.size()),
             .nodes = store_.nodes.data(),
             .nodeCount = static_cast<std::uint32_t>(store_.nodes.size()),
             .cellStarts = store_.cellStarts.empty() ? nullptr : store_.cellStarts.data(),
             .grid = store_.grid,
             .segmentCount = static_cast<std::uint32_t>(scene.segments.size()),
             .frame = store_.frame,
             .mostShift = mostShift,
             .shiftSlack = static_cast<float>(4.0 * mostShift * store_.frame.scale),
             .single = store_.single.data()};
}

void SegmentIndex::build() {
    const std::vector<Segment>& segments = scene_->segments;
    if (segments.empty()) method_ = IndexMethod::everyWall;  // the others take it that there are some
    if (method_ == IndexMethod::everyWall) return;
    if (method_ == IndexMethod::single) {
        store_ = buildSingle(segments);
        return;
    }
    if (method_ == IndexMethod::automatic && segments.size() > kMostByBruteForce) {
        method_ = IndexMethod::tree;
        if (segments.size() >= kLeastByGrid && gridWork(segments) <= kMostGridWork) {
            store_ = buildIndex(segments, Layout::grid);
            if (store_.unevenness <= kMostUneven) method_ = IndexMethod::grid;
        }
        if (method_ == IndexMethod::tree) store_ = buildIndex(segments, Layout::tree);
        return;
    }
    if (method_ == IndexMethod::automatic) method_ = IndexMethod::bruteForce;
    store_ = buildIndex(segments, method_ == IndexMethod::tree   ? Layout::tree
                                  : method_ == IndexMethod::grid ? Layout::grid
                                                                 : Layout::list);
}

void SegmentIndex::closestHits(std::span<const Ray> rays, std::span<Hit> hits) const {
    if (method_ != IndexMethod::everyWall)
        return kernels_->closestHits(view_, rays.data(), hits.data(), rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closestHit(rays[i]);
}

void SegmentIndex::closestHitsFan(std::span<const Ray> rays, std::span<Hit> hits) const {
    if (method_ == IndexMethod::everyWall) return closestHits(rays, hits);
    kernels_->closestHitsFan(view_, rays.data(), hits.data(), rays.size());
}

void SegmentIndex::occluded(std::span<const Ray> rays, std::span<const double> tMax,
                            std::span<std::uint8_t> answers) const {
    for (std::size_t i = 0; i < rays.size(); ++i) answers[i] = occluded(rays[i], tMax[i]);
}

}  // namespace halfdisk
