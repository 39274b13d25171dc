#include "app/cloud_stages.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

/// One number for a colour.
double meanOf(const Rgb& c) {
    return (c.x + c.y + c.z) / 3.0;
}

}  // namespace

void TreeRecorder::meet(const Ray& ray, const Hit& hit, std::uint32_t depth, std::uint64_t rays) {
    Recorder::meet(ray, hit, depth, rays);
    if (ray.speculars > 0 || open_.empty()) return;
    open_.back().missed = !hit;
    open_.back().to = ray.origin + ray.direction * (hit ? hit.t : 1.0);
}

void TreeRecorder::enter(const ShadedPoint& at, std::uint32_t depth) {
    Recorder::enter(at, depth);
    open_.push_back({at.P, at.P, true});
}

void TreeRecorder::arrival(std::uint32_t n, const Ray& ray, const Radiance& sampleColor) {
    Recorder::arrival(n, ray, sampleColor);
    if (open_.size() < 2) return;
    ++count_;
    if (rays_.size() >= limit_) return;
    const Open& here = open_.back();
    rays_.push_back({here.from, here.missed ? here.from + ray.direction : here.to,
                     static_cast<float>(meanOf(sampleColor.total())), static_cast<float>(open_.size() - 1),
                     here.missed});
}

void TreeRecorder::leave(const ShadedPoint& at, const Irradiance& gathered) {
    Recorder::leave(at, gathered);
    open_.pop_back();
}

std::vector<CloudLine> TreeRecorder::lines(double brightest, double far) const {
    std::vector<CloudLine> lines;
    lines.reserve(rays_.size());
    const auto top = static_cast<float>(brightest);
    for (const Deeper& ray : rays_) {
        const bool dark = !(top > 0.0f) || !(ray.value > 0.0f);
        const float bright = dark ? 0.0f : std::sqrt(std::min(ray.value / top, 1.0f));
        // As opaque as a line, times its thickness.
        const float opacity = 0.4f / ray.depth * (0.55f + 0.45f * bright) * (1.0f + 1.5f * bright);
        lines.push_back({ray.from,
                         ray.missed ? ray.from + far * (ray.to - ray.from) : ray.to,
                         {opacity * (1.0f - bright), opacity * bright}});
    }
    return lines;
}

WayLook lookOf(const LightWay& way, std::size_t i) {
    const auto met = static_cast<std::ptrdiff_t>(std::min(i, way.word.size()));
    const auto scatterings = static_cast<float>(std::count(way.word.begin(), way.word.begin() + met, 'D'));
    // Straight from the light bright, fainter with every scattering.
    if (scatterings > 0.0f) return {true, 0.45f / scatterings};
    return {false, 0.65f};
}

std::vector<CloudLine> linesOf(const std::vector<LightWay>& ways) {
    std::vector<CloudLine> lines;
    for (const LightWay& way : ways)
        for (std::size_t i = 1; i < way.corners.size(); ++i) {
            const WayLook look = lookOf(way, i);
            lines.push_back({way.corners[i - 1],
                             way.corners[i],
                             {look.scattered ? 0.0f : look.opacity, look.scattered ? look.opacity : 0.0f}});
        }
    return lines;
}

std::shared_ptr<const RayCloud> cloudOf(const std::vector<CloudLine>& lines, const Bounds& scene,
                                        std::array<std::uint32_t, 2> colors,
                                        const std::atomic<bool>& cancelled) {
    // Lines along the outermost walls are whole, and what leaves the scene is seen to leave it.
    constexpr double kMargin = 0.01, kAround = 0.35;
    const Vec2 size = scene.size();
    const double longer = std::max({size.x, size.y, 1e-9});
    const Bounds close{scene.min - kMargin * longer, scene.max + kMargin * longer};
    // A square, for a flat scene may stand in a tall canvas.
    const Vec2 reach((0.5 + kAround) * longer);
    const Bounds wide{scene.center() - reach, scene.center() + reach};
    const auto isOutside = [&](Vec2 at) {
        return at.x < close.min.x || at.y < close.min.y || at.x > close.max.x || at.y > close.max.y;
    };
    const bool leaves = std::any_of(lines.begin(), lines.end(), [&](const CloudLine& line) {
        return isOutside(line.from) || isOutside(line.to);
    });
    const std::uint32_t side = leaves ? kCloudSide * 6 / 5 : kCloudSide;
    const auto sums =
        sumUp(lines, leaves ? wide : close, side, [&] { return cancelled.load(std::memory_order_relaxed); });
    if (!sums) return nullptr;
    return std::make_shared<const RayCloud>(
        RayCloud{sums->area, cloudPicture(*sums, colors), std::min(lines.size(), kMostCloudLines)});
}

}  // namespace halfdisk
