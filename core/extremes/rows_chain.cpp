// Row of chains: light that a square of glass keeps in for a thousand total reflections.
#include <algorithm>

#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"
#include "core/surface.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kChain = 1000;
constexpr double kChainAngle = 0.75;  // rad: beyond the critical angle (0.73) at all four sides of a square

/// A square of glass of 1 m, turned by 0.3 rad; walls face outward.
Scene glassSquare() {
    const double c = std::cos(0.3), s = std::sin(0.3);
    std::vector<Vec2> points;
    for (const Vec2 p : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 1), Vec2(1, 0)})
        points.emplace_back(c * p.x - s * p.y, s * p.x + c * p.y);
    Scene scene = furnaceOf(points, 0.5, 0.0);
    scene.materials.front() = Dielectric{1.5, Rgb(0.0)};
    return scene;
}

/// Of a light that runs in a square between mirrors: 0 ... 1 and back.
long double folded(long double x) {
    const long double rest = x - 2.0L * std::floor(x / 2.0L);
    return rest > 1.0L ? 2.0L - rest : rest;
}

/// How far P is from where light is after the path length `way`.
double offChain(Vec2 P, long double way) {
    const long double c = std::cos(0.3L), s = std::sin(0.3L);
    const long double x = c * P.x + s * P.y, y = -s * P.x + c * P.y;
    const long double dx = std::sin(static_cast<long double>(kChainAngle)),
                      dy = std::cos(static_cast<long double>(kChainAngle));
    return static_cast<double>(std::hypot(x - folded(0.31L + way * dx), y - folded(0.43L + way * dy)));
}

Vec2 chainStart() {
    const double c = std::cos(0.3), s = std::sin(0.3);
    return {c * 0.31 - s * 0.43, s * 0.31 + c * 0.43};
}
Vec2 chainDirection() {
    return {std::sin(kChainAngle) * std::cos(0.3) - std::cos(kChainAngle) * std::sin(0.3),
            std::sin(kChainAngle) * std::sin(0.3) + std::cos(kChainAngle) * std::cos(0.3)};
}

ExtremeSide chainOfOurs() {
    const Scene scene = glassSquare();
    const SegmentIndex index(scene);
    Ray ray{chainStart(), chainDirection(), kNoSegment, 0.0, 0};
    long double way = 0.0L;
    ExtremeSide side;
    for (std::uint32_t k = 0; k < kChain; ++k) {
        const Hit hit = index.closestHit(ray);
        ++side.counts.rays;
        if (!hit || hit.front || hit.segment == ray.skip) {
            ++side.counts.leaks;
            return side;
        }
        const SurfacePoint at = surfaceAt(index, ray, hit);
        const auto next = sampleSurface(at, Carried::radiance, {1.0 - 1e-12, 0.5, 0.5});
        way += hit.t;
        // Light that is let through is lost to the chain.
        if (!next || glm::dot(next->direction, at.N) < 0.0 || next->weight != Rgb(1.0)) ++side.counts.leaks;
        if (!next || side.counts.leaks > 0) return side;
        side.error = std::max(side.error, offChain(at.P, way));
        ray = leave(index, at, *next, k + 1);
    }
    return side;
}

template <class Real>
ExtremeSide chainOfNaive() {
    const NaiveRoom<Real> room(glassSquare());
    const Vec2 start = chainStart(), along = chainDirection();
    NaiveRay<Real> ray{{static_cast<Real>(start.x), static_cast<Real>(start.y)},
                       {static_cast<Real>(along.x), static_cast<Real>(along.y)}};
    long double way = 0.0L;
    ExtremeSide side;
    for (std::uint32_t k = 0; k < kChain; ++k) {
        const auto hit = room.closestHit(ray);
        ++side.counts.rays;
        if (hit.segment == kNoSegment || hit.front) {
            ++side.counts.leaks;
            side.error = std::max(side.error, 1.0);
            return side;
        }
        way += hit.t;
        ray.origin = {ray.origin.x + hit.t * ray.direction.x, ray.origin.y + hit.t * ray.direction.y};
        side.error =
            std::max(side.error,
                     offChain({static_cast<double>(ray.origin.x), static_cast<double>(ray.origin.y)}, way));
        const auto& [a, b] = room.walls[hit.segment];
        const Real ex = b.x - a.x, ey = b.y - a.y, length = std::sqrt(ex * ex + ey * ey);
        const Real nx = -ey / length, ny = ex / length, fall = ray.direction.x * nx + ray.direction.y * ny;
        ray.direction = {ray.direction.x - 2 * fall * nx, ray.direction.y - 2 * fall * ny};
    }
    return side;
}

}  // namespace

void addChainRows(std::vector<ExtremeCell>& cells) {
    // Each reflection turns the ray by up to 4 h, and every metre beyond carries that along: after K of them
    // of 1 m and less, 4 h K^2 / 2; each hit is off by 13 epsilon of the largest coordinate (1.3 m) over the
    // sine of 0.75: 50 h more, K times if all went one way.
    cells.push_back({"chain:1000", "a thousand total reflections in glass", "m, of a square of 1 m",
                     (2.0 * kChain * kChain + 50.0 * kChain) * kRounding,
                     "each reflection turns the ray by 4 roundings, and all that follow carry it along",
                     [](const StopQuestion&) {
                         ExtremeOutcome outcome;
                         outcome.ours = chainOfOurs();
                         outcome.naiveFloat = chainOfNaive<float>();
                         outcome.naiveDouble = chainOfNaive<double>();
                         return outcome;
                     }});
}

}  // namespace halfdisk
