#include "reference.h"

#include <stdexcept>

#include "quadrature.h"

namespace halfdisk {
namespace {

// Panels along a wall, finer towards its ends, where light from an adjoining wall bends most.
constexpr std::array kPanelEnds{0.0, 0.02, 0.1, 0.3, 0.7, 0.9, 0.98, 1.0};
constexpr std::size_t kPanels = kPanelEnds.size() - 1;
constexpr std::size_t kNodes = kPanels * kGauss8.size();

double nodePosition(std::size_t k) {
    const std::size_t panel = k / kGauss8.size();
    const double half = (kPanelEnds[panel + 1] - kPanelEnds[panel]) / 2;
    return kPanelEnds[panel] + half * (1.0 + kGauss8[k % kGauss8.size()].x);
}

/// Lagrange interpolation of the values at a panel's nodes; x in -1 ... 1.
Rgb interpolate(const Rgb* values, double x) {
    Rgb sum{0.0};
    for (std::size_t i = 0; i < kGauss8.size(); ++i) {
        double basis = 1.0;
        for (std::size_t j = 0; j < kGauss8.size(); ++j)
            if (j != i) basis *= (x - kGauss8[j].x) / (kGauss8[i].x - kGauss8[j].x);
        sum += values[i] * basis;
    }
    return sum;
}

}  // namespace

Reference::Reference(const SegmentIndex& index, unsigned maxDepth, const std::atomic<bool>* cancelled)
    : visibility_(index) {
    const auto& segments = index.scene().segments;
    if (segments.size() > (maxDepth < 2 ? kMostWalls : kMostWallsDeep))
        throw std::invalid_argument("too many walls for a reference");
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        firstSide_.push_back(static_cast<std::uint32_t>(sides_.size()));
        sides_.push_back({i, true});
        if (segments[i].twoSided) sides_.push_back({i, false});
    }
    for (unsigned scatterings = 1; scatterings < maxDepth; ++scatterings) {
        std::vector<Rgb> values;
        values.reserve(sides_.size() * kNodes);
        for (std::size_t side = 0; side < sides_.size(); ++side) {
            for (std::size_t k = 0; k < kNodes; ++k) {
                if (cancelled && cancelled->load(std::memory_order_relaxed)) return;
                values.push_back(arrivingAfter(scatterings, node(side, k)));
            }
        }
        bounces_.push_back(std::move(values));
    }
    ready_ = true;
}

ShadedPoint Reference::node(std::size_t side, std::size_t k) const {
    const double u = nodePosition(k);
    return shadedPointAt(visibility_.index(), Hit{sides_[side].segment, 0.0, u, sides_[side].front});
}

Rgb Reference::irradiance(const ShadedPoint& at, unsigned depth) const {
    Rgb sum = directIrradiance(visibility_, at);
    for (unsigned scatterings = 1; scatterings <= depth; ++scatterings) sum += arrivingAfter(scatterings, at);
    return sum;
}

Rgb Reference::radiance(const ShadedPoint& at, double theta, unsigned depth) const {
    Rgb L = arrivingRadiance(visibility_, at, theta, depth > 0 ? 1 : 0);
    if (depth < 2) return L;
    const SegmentIndex& index = visibility_.index();
    const Vec2 direction = frameFromNormal(at.N).toWorld(std::cos(theta), std::sin(theta));
    const Hit hit = index.closestHit(rayFrom(index, at, direction));
    if (!hit || !isLitSide(index, hit)) return L;
    const Rgb albedo = shadedPointAt(index, hit).albedo;
    for (unsigned scatterings = 1; scatterings < depth; ++scatterings)
        L += albedo / 2.0 * irradianceAt(scatterings, hit);
    return L;
}

Rgb Reference::arrivingAfter(unsigned scatterings, const ShadedPoint& at) const {
    const SegmentIndex& index = visibility_.index();
    const Frame frame = frameFromNormal(at.N);
    const auto integrand = [&](double theta) {
        const Hit hit = index.closestHit(rayFrom(index, at, frame.toWorld(std::cos(theta), std::sin(theta))));
        if (!hit || !isLitSide(index, hit)) return Integrals<3>{};
        const ShadedPoint there = shadedPointAt(index, hit);
        if (there.albedo == Rgb(0.0)) return Integrals<3>{};
        const Rgb E =
            scatterings == 1 ? directIrradiance(visibility_, there) : irradianceAt(scatterings - 1, hit);
        const Rgb f = there.albedo / 2.0 * E * std::sin(theta);
        return Integrals<3>{f.x, f.y, f.z};
    };
    constexpr double kRelative = 1e-8;
    constexpr int kHalvings = 20;
    const Integrals<3> sum = integrateOver<3>(visibility_.arcs(at), integrand, kRelative, kHalvings);
    return {sum[0], sum[1], sum[2]};
}

Rgb Reference::irradianceAt(unsigned scatterings, const Hit& hit) const {
    const std::size_t side = firstSide_[hit.segment] + (hit.front ? 0u : 1u);
    std::size_t panel = 0;
    while (panel + 1 < kPanels && hit.u > kPanelEnds[panel + 1]) ++panel;
    const double half = (kPanelEnds[panel + 1] - kPanelEnds[panel]) / 2;
    const double x = (hit.u - kPanelEnds[panel]) / half - 1.0;
    return interpolate(&bounces_[scatterings - 1][side * kNodes + panel * kGauss8.size()], x);
}

}  // namespace halfdisk
