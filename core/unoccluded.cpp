#include "unoccluded.h"

#include "arc_measure.h"
#include "wall_kind.h"

namespace halfdisk {
namespace {

constexpr double kNarrowest = 1e-10;  // rad

/// Integral of max(0, cos) from 0 to `angle` (rad).
double cosineUpTo(double angle) {
    const double turns = std::floor((angle + kPi) / (2.0 * kPi));
    const double rest = angle - turns * 2.0 * kPi;  // -pi ... pi
    return 2.0 * turns + (rest < -kPi / 2.0 ? -1.0 : rest > kPi / 2.0 ? 1.0 : std::sin(rest));
}

/// Whether the lit side of an emitting segment faces P.
bool shinesOn(const Segment& lamp, Vec2 P) {
    return lamp.twoSided || cross(lamp.b - lamp.a, P - lamp.a) > 0.0;
}

bool crosses(const Segment& wall, Vec2 origin, Vec2 direction) {
    const double a = cross(direction, wall.a - origin), b = cross(direction, wall.b - origin);
    if ((a >= 0.0) == (b >= 0.0)) return false;
    return cross(wall.a - origin, wall.b - wall.a) / (b - a) > 0.0;
}

std::optional<Obstacle> obstacleBefore(const Visibility& visibility, const ShadedPoint& at,
                                       const VisibleArc& arc) {
    const SegmentIndex& index = visibility.index();
    const Vec2 direction = middleOf(at, arc);
    if (index.environment(direction) != Rgb(0.0)) return Obstacle{arc.hit.segment, "the environment"};
    for (const std::uint32_t lamp : index.emitters()) {
        if (lamp == arc.hit.segment || lamp == at.segment) continue;
        const Segment& segment = index.scene().segments[lamp];
        if (shinesOn(segment, at.P) && crosses(segment, at.P, direction))
            return Obstacle{arc.hit.segment, quotedName(index.scene(), lamp)};
    }
    return std::nullopt;
}

std::optional<Obstacle> obstacleOfArcs(const Visibility& visibility, const ShadedPoint& at,
                                       ArcMemory& memory) {
    for (const VisibleArc& arc : visibility.arcs(at, memory))
        if (arc.hit && arc.to - arc.from > kNarrowest)
            if (auto obstacle = obstacleBefore(visibility, at, arc)) return obstacle;
    return std::nullopt;
}

/// `from`: the half-disk that counts; null: all directions.
std::optional<Obstacle> obstacleOfLights(const SegmentIndex& index, const ShadedPoint& at, bool halfDisk) {
    for (std::uint32_t i = 0; i < index.scene().lights.size(); ++i) {
        const LightSample light = sampleLight(index, i, at.P, 0.5);
        if (halfDisk && glm::dot(at.N, light.L) <= 0.0) continue;
        const Ray ray = rayFrom(index, at, light.L);
        if (!index.occluded(ray, light.distance)) continue;
        return Obstacle{index.closestHit(ray).segment,
                        isPoint(index, i) ? "a point light" : "a directional light"};
    }
    return std::nullopt;
}

}  // namespace

Rgb environmentIrradiance(const Environment& environment, Vec2 N) {
    const std::size_t entries = environment.strip.size();
    if (entries == 0) return environment.radiance * 2.0;
    const double up = std::atan2(N.y, N.x), width = 2.0 * kPi / static_cast<double>(entries);
    Rgb sum{0.0};
    for (std::size_t k = 0; k < entries; ++k) {
        const double from = width * static_cast<double>(k) - up;
        sum += environment.strip[k] * (cosineUpTo(from + width) - cosineUpTo(from));
    }
    return environment.radiance * sum;
}

Rgb unoccludedIrradiance(const SegmentIndex& index, const ShadedPoint& at) {
    Rgb sum = environmentIrradiance(index.scene().environment, at.N);
    for (std::uint32_t i = 0; i < index.scene().lights.size(); ++i) {
        const LightSample light = sampleLight(index, i, at.P, 0.5);
        sum += light.L_i * std::max(0.0, glm::dot(at.N, light.L));
    }
    for (const std::uint32_t lamp : index.emitters())
        if (lamp != at.segment) sum += segmentIrradiance(at.P, at.N, index.scene().segments[lamp]);
    return sum;
}

Rgb unoccludedFluence(const SegmentIndex& index, Vec2 P) {
    const Environment& environment = index.scene().environment;
    Rgb sum = environment.radiance * (2.0 * kPi);
    if (!environment.strip.empty()) {
        Rgb mean{0.0};
        for (const Rgb& factor : environment.strip) mean += factor;
        sum *= mean / static_cast<double>(environment.strip.size());
    }
    for (std::uint32_t i = 0; i < index.scene().lights.size(); ++i) sum += sampleLight(index, i, P, 0.5).L_i;
    for (const std::uint32_t lamp : index.emitters()) {
        const Segment& segment = index.scene().segments[lamp];
        if (!shinesOn(segment, P)) continue;
        const Vec2 a = segment.a - P, b = segment.b - P;
        sum += segment.emission * std::abs(std::atan2(cross(a, b), glm::dot(a, b)));
    }
    return sum;
}

std::optional<Obstacle> obstacleAt(const Visibility& visibility, const ShadedPoint& at, ArcMemory& memory) {
    if (auto obstacle = obstacleOfLights(visibility.index(), at, true)) return obstacle;
    return obstacleOfArcs(visibility, at, memory);
}

std::optional<Obstacle> obstacleAround(const Visibility& visibility, Vec2 P, ArcMemory& memory) {
    const ShadedPoint up{P, {0.0, 1.0}}, down{P, {0.0, -1.0}};
    if (auto obstacle = obstacleOfLights(visibility.index(), up, false)) return obstacle;
    if (auto obstacle = obstacleOfArcs(visibility, up, memory)) return obstacle;
    return obstacleOfArcs(visibility, down, memory);
}

}  // namespace halfdisk
