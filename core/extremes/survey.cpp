#include "survey.h"

#include <algorithm>

#include "core/estimate.h"
#include "core/rng.h"

namespace halfdisk {
namespace {

// long double: 11 bits more than double, so that of two answers it is double that is wrong.
using Long = long double;

struct TrueHit {
    std::uint32_t segment = kNoSegment;
    Long t = std::numeric_limits<Long>::infinity();
    Long x = 0, y = 0;
    bool front = false;
};

struct Start {
    std::uint32_t wall;
    double u, theta;
};

struct Answer {
    std::uint32_t segment = kNoSegment;
    double t = 0.0;  // m, where the scene was put
    bool front = false;
    double x = 0.0, y = 0.0;
};

TrueHit trueHit(const Scene& scene, const Start& start) {
    const Segment& from = scene.segments[start.wall];
    const Long ex = Long(from.b.x) - from.a.x, ey = Long(from.b.y) - from.a.y;
    const Long length = std::sqrt(ex * ex + ey * ey), c = std::cos(Long(start.theta)),
               s = std::sin(Long(start.theta));
    // As seen from the wall's own end: far from the origin a sum of coordinates would be rounded by more than
    // the start may be away from a corner, and their differences are not rounded at all.
    const Long ox = start.u * ex, oy = start.u * ey;
    const auto x = [&](Vec2 P) { return (Long(P.x) - from.a.x) - ox; };
    const auto y = [&](Vec2 P) { return (Long(P.y) - from.a.y) - oy; };
    const Long dx = (c * ex - s * ey) / length, dy = (c * ey + s * ex) / length;
    TrueHit nearest;
    for (std::uint32_t i = 0; i < scene.segments.size(); ++i) {
        if (i == start.wall) continue;
        const Segment& wall = scene.segments[i];
        const Long ax = x(wall.a), ay = y(wall.a), bx = x(wall.b), by = y(wall.b);
        const Long sideA = dx * ay - dy * ax, sideB = dx * by - dy * bx;
        if ((sideA >= 0) == (sideB >= 0)) continue;
        const Long wx = Long(wall.b.x) - wall.a.x, wy = Long(wall.b.y) - wall.a.y;
        const Long t = (ax * wy - ay * wx) / (dx * wy - dy * wx);
        // Of walls at one place the one that faces the ray is met (see SegmentIndex).
        const bool front = sideB > sideA, tie = t == nearest.t && front && !nearest.front;
        if (!(t > 0) || (t >= nearest.t && !tie)) continue;
        nearest = {i, t, from.a.x + (ox + t * dx), from.a.y + (oy + t * dy), front};
    }
    return nearest;
}

Start startOf(const Scene& scene, const SurveyRays& rays, std::uint64_t n, const Rng& rng) {
    const auto sample = static_cast<std::uint32_t>(n);
    const std::uint64_t walls = std::min<std::uint64_t>(rays.walls, scene.segments.size());
    Start start{static_cast<std::uint32_t>(n % walls), rng.uniform(sample, 0), kPi * rng.uniform(sample, 1)};
    // Every fourth nearly along the wall, every eighth next to its end: where things break.
    if (rays.theta > 0.0) start.theta = rays.theta;
    const std::uint64_t turn = n / walls;
    if (rays.theta == 0.0 && turn % 4 == 3) start.theta = std::pow(10.0, -10.0 * rng.uniform(sample, 1));
    if (rays.ends && turn % 8 == 1) start.u = std::pow(10.0, -12.0 * rng.uniform(sample, 0));
    if (rays.ends && turn % 16 == 1) start.u = 1.0 - start.u;
    if (rays.theta > 0.0 && turn % 2 == 1) start.theta = kPi - rays.theta;
    return start;
}

Rgb radianceOf(const Scene& scene, std::uint32_t segment, bool front, Vec2 direction) {
    if (segment == kNoSegment) return radianceFrom(scene.environment, direction);
    const Segment& wall = scene.segments[segment];
    return front || wall.twoSided ? wall.emission : Rgb(0.0);
}

Vec2 trueEnd(const Scene& scene, const Start& start, const TrueHit& truth) {
    const Segment& wall = scene.segments[start.wall];
    if (truth.segment != kNoSegment) return {static_cast<double>(truth.x), static_cast<double>(truth.y)};
    const Vec2 direction =
        frameFromNormal(frontNormal(wall)).toWorld(std::cos(start.theta), std::sin(start.theta));
    return glm::mix(wall.a, wall.b, start.u) + sizeOf(scene) * direction;
}

template <class Ask>
ExtremeCounts survey(const Scene& scene, const Placement& placement, const SurveyRays& rays,
                     const StopQuestion& stop, const Ask& ask) {
    ExtremeCounts counts;
    if (scene.segments.empty()) return counts;
    const Rng rng(rays.seed, 0);
    const Long size = sizeOf(scene), scale = placement.scale;
    const Vec2 shift = shiftOf(scene, placement);
    double seen = 0.0, there = 0.0;
    const auto lose = [&](LostRay::How how, std::uint64_t& count, const Start& start, const TrueHit& truth) {
        if (++count > rays.kept) return;
        const Segment& wall = scene.segments[start.wall];
        counts.lost.push_back({how, glm::mix(wall.a, wall.b, start.u), trueEnd(scene, start, truth)});
    };
    for (std::uint64_t n = 0; n < rays.count; ++n) {
        throwIfStopped(stop, n);
        const Start start = startOf(scene, rays, n, rng);
        const TrueHit truth = trueHit(scene, start);
        const Answer answer = ask(start);
        ++counts.rays;
        const Vec2 N = frontNormal(scene.segments[start.wall]);
        const Vec2 direction = frameFromNormal(N).toWorld(std::cos(start.theta), std::sin(start.theta));
        there += radianceOf(scene, truth.segment, truth.front, direction).x;
        const bool lost = answer.segment == start.wall && !answer.front;
        if (!lost) seen += radianceOf(scene, answer.segment, answer.front, direction).x;
        if (answer.segment != kNoSegment && !std::isfinite(answer.t)) {
            lose(LostRay::How::nonFinite, counts.nonFinite, start, truth);
            continue;
        }
        if (answer.segment == start.wall) {
            lose(LostRay::How::selfHit, counts.selfHits, start, truth);
            continue;
        }
        if (truth.segment == kNoSegment) continue;
        const bool beyond =
            answer.segment != truth.segment && answer.t / scale > 1.01L * truth.t + 1e-9L * size;
        const bool through = answer.segment == kNoSegment || (truth.front && !answer.front) || beyond;
        if (through) {
            lose(LostRay::How::leak, counts.leaks, start, truth);
            continue;
        }
        const Long x = answer.x / scale - shift.x, y = answer.y / scale - shift.y;
        if (answer.segment != truth.segment && std::hypot(x - truth.x, y - truth.y) > 1e-6L * size) {
            ++counts.early;
            continue;
        }
        const Vec2 met = frontNormal(scene.segments[truth.segment]);
        const Long away = std::hypot(x - truth.x, y - truth.y) * std::abs(glm::dot(met, direction)) / size;
        counts.place = std::max(counts.place, static_cast<double>(away));
    }
    counts.light = there > 0.0 ? std::abs(seen - there) / there : 0.0;
    return counts;
}

template <class Real>
ExtremeCounts surveyIn(const Scene& scene, const Placement& placement, const SurveyRays& rays,
                       EpsilonPolicy policy, double fixedEpsilon, const StopQuestion& stop) {
    const NaiveRoom<Real> room(placed(scene, placement), policy, fixedEpsilon);
    return survey(scene, placement, rays, stop, [&](const Start& start) {
        const auto ray = room.rayFrom(start.wall, room.pointOn(start.wall, static_cast<Real>(start.u)),
                                      static_cast<Real>(start.theta));
        if (!std::isfinite(ray.direction.x)) return Answer{start.wall, kInfinity, false, 0.0, 0.0};
        const auto hit = room.closestHit(ray);
        return Answer{hit.segment, static_cast<double>(hit.t), hit.front,
                      static_cast<double>(ray.origin.x + hit.t * ray.direction.x),
                      static_cast<double>(ray.origin.y + hit.t * ray.direction.y)};
    });
}

}  // namespace

void ExtremeCounts::merge(const ExtremeCounts& other) {
    rays += other.rays;
    leaks += other.leaks;
    selfHits += other.selfHits;
    nonFinite += other.nonFinite;
    early += other.early;
    place = std::max(place, other.place);
    light = std::max(light, other.light);
    lost.insert(lost.end(), other.lost.begin(), other.lost.end());
}

ExtremeCounts surveyOurs(const Scene& scene, const Placement& placement, const SurveyRays& rays,
                         const StopQuestion& stop) {
    const Scene there = placed(scene, placement);
    const SegmentIndex index(there);
    return survey(scene, placement, rays, stop, [&](const Start& start) {
        ShadedPoint at{index.pointOn(start.wall, start.u), index.normal(start.wall), start.wall};
        const Vec2 direction =
            frameFromNormal(at.N).toWorld(halfCircleCos(start.theta), halfCircleSin(start.theta));
        const Ray ray = rayFrom(index, at, direction);
        const Hit hit = index.closestHit(ray);
        const Vec2 P = hit ? index.pointOn(hit.segment, hit.u) : Vec2(0.0);
        return Answer{hit.segment, hit.t, hit.front, P.x, P.y};
    });
}

ExtremeCounts surveyNaive(const Scene& scene, const Placement& placement, const SurveyRays& rays,
                          Precision precision, EpsilonPolicy policy, double fixedEpsilon,
                          const StopQuestion& stop) {
    return precision == Precision::single
               ? surveyIn<float>(scene, placement, rays, policy, fixedEpsilon, stop)
               : surveyIn<double>(scene, placement, rays, policy, fixedEpsilon, stop);
}

}  // namespace halfdisk
