#include "exact.h"

#include <algorithm>

#include "arc_measure.h"
#include "cover.h"
#include "quadrature.h"
#include "wall_contacts.h"

namespace halfdisk {
namespace {

// Arcs narrower than this (rad) hold less light than rounding takes from their neighbours.
constexpr double kNarrowest = 1e-15;

bool seesOver(const ShadedPoint& at, Vec2 direction) {
    return glm::dot(at.N, direction) > 0.0;
}

Rgb seenRadiance(const Visibility& visibility, const Hit& hit, Vec2 direction, int depth) {
    const SegmentIndex& index = visibility.index();
    if (!hit) return index.environment(direction);
    if (!isLitSide(index, hit)) return Rgb(0.0);
    const Rgb& emission = index.scene().segments[hit.segment].emission;
    if (depth == 0) return emission;
    const ShadedPoint there = shadedPointAt(index, hit);
    return emission + there.albedo / 2.0 * directIrradiance(visibility, there);
}

}  // namespace

Rgb segmentIrradiance(Vec2 P, Vec2 N, const Segment& segment) {
    if (!segment.twoSided && cross(segment.b - segment.a, P - segment.a) <= 0.0) return Rgb(0.0);
    Vec2 a = segment.a - P, b = segment.b - P;
    const double heightA = glm::dot(a, N), heightB = glm::dot(b, N);
    if (heightA <= 0.0 && heightB <= 0.0) return Rgb(0.0);
    if (heightA < 0.0) a += (b - a) * (heightA / (heightA - heightB));
    if (heightB < 0.0) b += (a - b) * (heightB / (heightB - heightA));
    a /= glm::length(a);
    b /= glm::length(b);
    const double cosine = glm::dot(a, b);
    if (cosine <= 0.0) return segment.emission * std::abs(cross(N, a) - cross(N, b));
    // sin beta - sin alpha = 2 cos((alpha + beta) / 2) sin((beta - alpha) / 2): of a small lamp, or one next
    // to the horizon, both sines are nearly the same, and their difference mere rounding.
    return segment.emission * (std::abs(cross(a, b)) * glm::dot(N, a + b) / (1.0 + cosine));
}

double closedRoomRadiance(double Le, double albedo, int depth) {
    if (depth == kAnyDepth) return Le / (1.0 - albedo);
    double sum = 0.0;
    for (int k = depth; k >= 0; --k) sum = Le + albedo * sum;
    return sum;
}

Visibility::Visibility(const SegmentIndex& index, const StopQuestion& stop)
    : index_(&index), corners_(cornersOf(index.scene().segments, stop)) {
    const std::size_t bins = index.scene().environment.strip.size();
    for (std::size_t k = 0; k < bins; ++k) {
        const double angle = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(bins);
        skyEdges_.push_back({std::cos(angle), std::sin(angle)});
    }
}

std::vector<VisibleArc> Visibility::arcs(const ShadedPoint& at) const {
    ArcMemory memory;
    arcs(at, memory);
    return std::move(memory.arcs);
}

const std::vector<VisibleArc>& Visibility::arcs(const ShadedPoint& at, ArcMemory& memory) const {
    memory.arcs.clear();
    if (isCovered(*index_, at)) return memory.arcs;
    std::vector<double>& cuts = memory.cuts;
    cuts.assign({0.0, kPi});
    for (const Vec2& corner : corners_)
        if (seesOver(at, corner - at.P)) cuts.push_back(thetaOf(at, corner - at.P));
    for (const Vec2& edge : skyEdges_)
        if (seesOver(at, edge)) cuts.push_back(thetaOf(at, edge));
    std::sort(cuts.begin(), cuts.end());

    double from = cuts.front();
    for (const double to : cuts) {
        if (to - from < kNarrowest) continue;
        VisibleArc arc{from, to, {}};
        arc.hit = index_->closestHit(rayFrom(*index_, at, middleOf(at, arc)));
        memory.arcs.push_back(arc);
        from = to;
    }
    return memory.arcs;
}

Rgb deltaIrradiance(const SegmentIndex& index, const ShadedPoint& at) {
    Rgb sum{0.0};
    if (isCovered(index, at)) return sum;
    for (std::uint32_t i = 0; i < index.scene().lights.size(); ++i) {
        const LightSample light = sampleLight(index, i, at.P, 0.5);
        if (!seesOver(at, light.L) || index.occluded(rayFrom(index, at, light.L), light.distance)) continue;
        sum += light.L_i * glm::dot(at.N, light.L);
    }
    return sum;
}

Rgb directIrradiance(const Visibility& visibility, const ShadedPoint& at) {
    Rgb sum = deltaIrradiance(visibility.index(), at);
    for (const VisibleArc& arc : visibility.arcs(at))
        sum += seenRadiance(visibility, arc.hit, middleOf(at, arc), 0) * cosineBetween(arc.from, arc.to);
    return sum;
}

Rgb arrivingRadiance(const Visibility& visibility, const ShadedPoint& at, double theta, int depth) {
    if (isCovered(visibility.index(), at)) return Rgb(0.0);
    const Vec2 direction = directionAt(at, theta);
    return seenRadiance(visibility, visibility.index().closestHit(rayFrom(visibility.index(), at, direction)),
                        direction, depth);
}

ExactEstimate halfDiskEstimate(const Visibility& visibility, const ShadedPoint& at, Sampler sampler,
                               int depth) {
    // f = L cosine is what is integrated; f / pdf is a sample's value, and E[(f / pdf)^2] = integral of f^2 /
    // pdf.
    const auto moments = [&](double theta) {
        const double cosine = std::sin(theta);
        const Rgb f = arrivingRadiance(visibility, at, theta, depth) * cosine;
        const Rgb second = f * f / pdfHalfDisk(sampler, cosine);
        return Integrals<6>{f.x, f.y, f.z, second.x, second.y, second.z};
    };
    constexpr double kRelative = 1e-11;
    constexpr int kHalvings = 36;
    const Integrals<6> sum = integrateOver<6>(visibility.arcs(at), moments, kRelative, kHalvings);
    ExactEstimate exact;
    exact.mean = Rgb(sum[0], sum[1], sum[2]);
    exact.variance = Rgb(sum[3], sum[4], sum[5]) - exact.mean * exact.mean;
    exact.mean += deltaIrradiance(visibility.index(), at);
    return exact;
}

}  // namespace halfdisk
