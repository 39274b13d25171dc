// Which lines make up the clouds on the canvas? Rays of the recursion, and the ways that light takes.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "app/ray_cloud.h"
#include "core/light_way.h"
#include "core/recorder.h"

namespace halfdisk {

/// Records the run, and rays below depth 0 also where its record is full.
class TreeRecorder : public Recorder {
 public:
    /// Keeps at most `rays` of them.
    TreeRecorder(std::size_t events, std::size_t rays, const std::atomic<bool>* cancelled)
        : Recorder(events, cancelled), limit_(rays) {}

    void meet(const Ray& ray, const Hit& hit, std::uint32_t depth, std::uint64_t rays);
    void enter(const ShadedPoint& at, std::uint32_t depth);
    void arrival(std::uint32_t n, const Ray& ray, const Radiance& sampleColor);
    void leave(const ShadedPoint& at, const Irradiance& gathered);

    std::size_t deeperCount() const { return count_; }  ///< all, also those that are not kept

    /// Brighter the more a ray brings, compared with `brightest` (W/(m rad)); fainter with depth. The first
    /// colour is that of a ray that brings nothing. `far` (m): how long those are that meet nothing.
    std::vector<CloudLine> lines(double brightest, double far) const;

 private:
    struct Deeper {
        Vec2 from, to;  // a direction's length away if it met nothing
        float value;    // W/(m rad)
        float depth;
        bool missed;
    };
    struct Open {
        Vec2 from, to;
        bool missed;
    };
    std::vector<Deeper> rays_;
    std::vector<Open> open_;
    std::size_t count_ = 0, limit_;
};

/// The first colour is that of light which was not scattered yet.
std::vector<CloudLine> linesOf(const std::vector<LightWay>& ways);

/// How opaque the ray at corner i - 1 ... i is, and in which of the two colours.
struct WayLook {
    bool scattered;
    float opacity;
};
WayLook lookOf(const LightWay& way, std::size_t i);

/// Over the scene, and what lies around it if lines leave it. Null if cancelled on the way.
std::shared_ptr<const RayCloud> cloudOf(const std::vector<CloudLine>& lines, const Bounds& scene,
                                        std::array<std::uint32_t, 2> colors,
                                        const std::atomic<bool>& cancelled);

}  // namespace halfdisk
