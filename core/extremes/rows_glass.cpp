// Rows of glass: hardly any, a lot, at the critical angle, and a chain of a thousand total reflections.
#include <algorithm>
#include <array>

#include "core/extremes/furnace.h"
#include "core/extremes/rows.h"
#include "core/surface.h"

namespace halfdisk {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2.0;

struct Split {
    long double reflected = 1.0L, cosine = 0.0L;
};

/// Fresnel's equations in long double, for the very same numbers.
Split trueSplit(double cosine, double n1, double n2) {
    const long double c = cosine, ratio = static_cast<long double>(n1) / n2;
    const long double square = 1.0L - ratio * ratio * (1.0L - c) * (1.0L + c);
    if (!(square > 0.0L)) return {};
    const long double t = std::sqrt(square);
    const long double s = (n1 * c - n2 * t) / (n1 * c + n2 * t), p = (n2 * c - n1 * t) / (n2 * c + n1 * t);
    return {(s * s + p * p) / 2.0L, t};
}

/// The same in `Real`, by angles, as it stands in optics books: sin(i - t) / sin(i + t), tan(i - t) / tan(i +
/// t).
template <class Real>
Refraction naiveSplit(double cosine, double n1, double n2) {
    const Real i = std::acos(static_cast<Real>(cosine));
    const Real t = std::asin(static_cast<Real>(n1) / static_cast<Real>(n2) * std::sin(i));
    const Real s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
    return {static_cast<double>((s * s + p * p) / 2), static_cast<double>(std::cos(t))};
}

/// How well a way to split light does over all angles. An error of the refracted cosine t is h / t, and moves
/// the reflected share by h / (c t): both cosines weigh the errors.
template <class Ask>
ExtremeSide sideOf(double n1, double n2, const Ask& ask) {
    ExtremeSide side;
    for (int k = 0; k <= 2000; ++k) {
        const double c = k <= 1000 ? k / 1000.0 : std::pow(10.0, -6.0 * (k - 1000) / 1000.0);
        if (c == 0.0) continue;
        const Split truth = trueSplit(c, n1, n2);
        const Refraction said = ask(c);
        ++side.counts.rays;
        if (!std::isfinite(said.reflected) || !std::isfinite(said.cosine)) {
            ++side.counts.nonFinite;
            continue;
        }
        const double weight = c * static_cast<double>(truth.cosine);
        const double off = std::max(std::abs(static_cast<double>(said.reflected - truth.reflected)),
                                    std::abs(static_cast<double>(said.cosine - truth.cosine)));
        side.error = std::max(side.error, truth.cosine == 0.0L ? off : off * weight);
    }
    return side;
}

// square = 1 - r^2 (1 - c)(1 + c): six roundings of numbers up to r^2 (at most 1 where light passes, since
// r sin <= 1), so its root t is off by 3 h / t. s and p: their numerators by h n c + h n t and what t is off
// by, over the sum of the same two: 2 (3 h / t + 2 h) / c at most; the squares' mean twice that: 16 h / (c
// t), and a few more.
constexpr double kGlassBound = 24.0 * kRounding;

ExtremeCell splitCell(const char* id, std::string title, double n1, double n2) {
    return {id,
            std::move(title),
            "R and cosine, by c t",
            kGlassBound,
            "some ten roundings, which 1 / (c t) makes larger next to grazing",
            [n1, n2](const StopQuestion&) {
                ExtremeOutcome outcome;
                outcome.ours = sideOf(n1, n2, [&](double c) { return refraction(c, n1, n2); });
                outcome.naiveFloat = sideOf(n1, n2, [&](double c) { return naiveSplit<float>(c, n1, n2); });
                outcome.naiveDouble = sideOf(n1, n2, [&](double c) { return naiveSplit<double>(c, n1, n2); });
                return outcome;
            }};
}

/// Total reflection is R = 1 and no cosine; else it is the cosine's relative error that counts.
ExtremeSide criticalSide(const Refraction& said, const Split& truth) {
    ExtremeSide side;
    side.counts.rays = 1;
    if (!std::isfinite(said.reflected) || !std::isfinite(said.cosine)) side.counts.nonFinite = 1;
    side.error = truth.cosine == 0.0L
                     ? std::abs(said.reflected - 1.0) + std::abs(said.cosine)
                     : std::abs(static_cast<double>((said.cosine - truth.cosine) / truth.cosine));
    return side;
}

// Beyond the angle nothing may pass: exact. Below it square = 2e-6 tan(critical) n^2 cos^2 = 2.2e-6, off by 3
// h: the root by half of 3 h / 2.2e-6.
ExtremeCell criticalCell(const char* id, double beyond) {
    constexpr double kIor = 1.5;
    return {id,
            beyond > 0.0 ? "glass, 1e-6 rad beyond the critical angle"
                         : "glass, 1e-6 rad short of the critical angle",
            beyond > 0.0 ? "R and cosine" : "cosine, relative",
            beyond > 0.0 ? 0.0 : 6.0 * kRounding / 2.2e-6,
            beyond > 0.0 ? "total reflection is total" : "1 - n^2 sin^2 is 2.2e-6, and off by some roundings",
            [beyond](const StopQuestion&) {
                const long double angle = std::asin(1.0L / static_cast<long double>(kIor)) + beyond;
                const auto cosine = static_cast<double>(std::cos(angle));
                const Split truth = trueSplit(cosine, kIor, 1.0);
                ExtremeOutcome outcome;
                outcome.ours = criticalSide(refraction(cosine, kIor, 1.0), truth);
                outcome.naiveFloat = criticalSide(naiveSplit<float>(cosine, kIor, 1.0), truth);
                outcome.naiveDouble = criticalSide(naiveSplit<double>(cosine, kIor, 1.0), truth);
                return outcome;
            }};
}

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

void addGlassRows(std::vector<ExtremeCell>& cells) {
    constexpr double kHardly = 1.0 + 1e-6;
    cells.push_back(splitCell("ior:1", "glass of index 1, which is none", 1.0, 1.0));
    cells.push_back(splitCell("ior:1+1e-6", "light into glass of index 1 + 1e-6", 1.0, kHardly));
    cells.push_back(splitCell("ior:1-1e-6", "light out of glass of index 1 + 1e-6", kHardly, 1.0));
    cells.push_back(splitCell("ior:4", "light into glass of index 4", 1.0, 4.0));
    cells.push_back(splitCell("ior:1/4", "light out of glass of index 4", 4.0, 1.0));
    cells.push_back(criticalCell("critical:-1e-6", -1e-6));
    cells.push_back(criticalCell("critical:+1e-6", 1e-6));
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
