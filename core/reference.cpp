#include "reference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "arc_measure.h"
#include "nearest_wall.h"
#include "quadrature.h"
#include "wall_contacts.h"

namespace halfdisk {
namespace {

// Panels along a stretch of wall, finer towards its ends, where light from an adjoining wall bends most.
constexpr std::array kPanelEnds{0.0, 0.02, 0.1, 0.3, 0.7, 0.9, 0.98, 1.0};

/// Panels are halved until none is longer than half its distance to a corner in front of the wall: beside it
/// what the other wall sends, or takes away, changes over such a distance. What touches the wall has its
/// panels already.
std::vector<double> refined(const std::vector<double>& ends, const Segment& wall, Vec2 N,
                            const std::vector<Vec2>& corners) {
    constexpr int kHalvings = 10;
    constexpr std::size_t kMostPanels = 120;
    constexpr double kTouches = 1e-6;  // of the wall's length
    const Vec2 edge = wall.b - wall.a;
    const double length = glm::length(edge);
    std::vector<Vec2> near;
    for (const Vec2 corner : corners)
        if (glm::dot(corner - wall.a, N) > kTouches * length) near.push_back(corner);
    std::vector<double> all{ends.front()};
    const auto add = [&](const auto& self, double from, double to, int halvings) -> void {
        const Vec2 a = wall.a + from * edge, b = wall.a + to * edge;
        const bool tooLong = std::any_of(near.begin(), near.end(), [&](Vec2 corner) {
            return 0.5 * nearestOnStretch(a, b, corner).distance < (to - from) * length;
        });
        if (!tooLong || halvings == 0 || all.size() > kMostPanels) {
            all.push_back(to);
            return;
        }
        const double middle = (from + to) / 2.0;
        self(self, from, middle, halvings - 1);
        self(self, middle, to, halvings - 1);
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) add(add, ends[i], ends[i + 1], kHalvings);
    return all;
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
        addSide(i, true);
        if (segments[i].twoSided) addSide(i, false);
    }
    for (unsigned scatterings = 1; scatterings < maxDepth; ++scatterings) {
        std::vector<Rgb> values;
        values.reserve(nodeCount_);
        for (const Side& side : sides_) {
            for (std::size_t panel = 0; panel + 1 < side.panelEnds.size(); ++panel) {
                const double from = side.panelEnds[panel], to = side.panelEnds[panel + 1];
                for (const GaussPoint& point : kGauss8) {
                    if (cancelled && cancelled->load(std::memory_order_relaxed)) return;
                    const double u = from + (to - from) * (1.0 + point.x) / 2;
                    const Hit hit{side.segment, 0.0, u, side.front};
                    values.push_back(arrivingAfter(scatterings, shadedPointAt(visibility_.index(), hit)));
                }
            }
        }
        bounces_.push_back(std::move(values));
    }
    ready_ = true;
}

void Reference::addSide(std::uint32_t segment, bool front) {
    Side side{segment, front, {0.0}, nodeCount_};
    const auto contacts = contactsOf(visibility_.index().scene().segments[segment], visibility_.corners());
    for (std::size_t i = 0; i + 1 < contacts.size(); ++i)
        for (const double end : kPanelEnds)
            if (end > 0.0) side.panelEnds.push_back(contacts[i] + (contacts[i + 1] - contacts[i]) * end);
    const SegmentIndex& index = visibility_.index();
    side.panelEnds = refined(side.panelEnds, index.scene().segments[segment],
                             front ? index.normal(segment) : -index.normal(segment), visibility_.corners());
    nodeCount_ += (side.panelEnds.size() - 1) * kGauss8.size();
    sides_.push_back(std::move(side));
}

Rgb Reference::irradiance(const ShadedPoint& at, unsigned depth) const {
    Rgb sum = directIrradiance(visibility_, at);
    for (unsigned scatterings = 1; scatterings <= depth; ++scatterings) sum += arrivingAfter(scatterings, at);
    return sum;
}

Rgb Reference::interpolatedIrradiance(const Hit& hit, unsigned depth) const {
    Rgb sum = directIrradiance(visibility_, shadedPointAt(visibility_.index(), hit));
    for (unsigned scatterings = 1; scatterings <= depth; ++scatterings) sum += irradianceAt(scatterings, hit);
    return sum;
}

Rgb Reference::radiance(const ShadedPoint& at, double theta, unsigned depth) const {
    Rgb L = arrivingRadiance(visibility_, at, theta, depth > 0 ? 1 : 0);
    if (depth < 2) return L;
    const SegmentIndex& index = visibility_.index();
    const Hit hit = index.closestHit(rayFrom(index, at, directionAt(at, theta)));
    if (!hit || !isLitSide(index, hit)) return L;
    const Rgb albedo = shadedPointAt(index, hit).albedo;
    for (unsigned scatterings = 1; scatterings < depth; ++scatterings)
        L += albedo / 2.0 * irradianceAt(scatterings, hit);
    return L;
}

double Reference::interpolationError(std::span<const std::uint32_t> walls, unsigned depth) const {
    const SegmentIndex& index = visibility_.index();
    double squares = 0.0, total = 0.0;
    for (const std::uint32_t wall : walls) {
        const Side& side = sides_[firstSide_[wall]];
        for (std::size_t panel = 0; panel + 1 < side.panelEnds.size(); ++panel) {
            const double from = side.panelEnds[panel], to = side.panelEnds[panel + 1],
                         length = (to - from) * index.length(wall);
            const Hit hit{wall, 0.0, (from + to) / 2.0, true};  // between the middle nodes
            Rgb off{0.0};
            for (unsigned k = 1; k <= depth; ++k)
                off += irradianceAt(k, hit) - arrivingAfter(k, shadedPointAt(index, hit));
            squares += length * glm::dot(off, off) / 3.0;
            total += length;
        }
    }
    return total > 0.0 ? std::sqrt(squares / total) : 0.0;
}

Rgb Reference::arrivingAfter(unsigned scatterings, const ShadedPoint& at) const {
    const SegmentIndex& index = visibility_.index();
    const auto integrand = [&](double theta) {
        const Hit hit = index.closestHit(rayFrom(index, at, directionAt(at, theta)));
        if (!hit || !isLitSide(index, hit)) return Integrals<3>{};
        const ShadedPoint there = shadedPointAt(index, hit);
        if (there.albedo == Rgb(0.0)) return Integrals<3>{};
        const Rgb E =
            scatterings == 1 ? directIrradiance(visibility_, there) : irradianceAt(scatterings - 1, hit);
        const Rgb f = there.albedo / 2.0 * E * std::sin(theta);
        return Integrals<3>{f.x, f.y, f.z};
    };
    // What is interpolated between nodes is known to 1e-3 at best, and need not be better at them.
    const double relative = ready_ ? 1e-8 : 1e-5;
    const int halvings = ready_ ? 20 : 10;
    const Integrals<3> sum = integrateOver<3>(visibility_.arcs(at), integrand, relative, halvings);
    return {sum[0], sum[1], sum[2]};
}

Rgb Reference::irradianceAt(unsigned scatterings, const Hit& hit) const {
    const Side& side = sides_[firstSide_[hit.segment] + (hit.front ? 0u : 1u)];
    const auto& ends = side.panelEnds;
    const auto above = std::upper_bound(ends.begin() + 1, ends.end() - 1, hit.u);
    const auto panel = static_cast<std::size_t>(above - ends.begin()) - 1;
    const double half = (ends[panel + 1] - ends[panel]) / 2, x = (hit.u - ends[panel]) / half - 1.0;
    return interpolate(&bounces_[scatterings - 1][side.firstNode + panel * kGauss8.size()], x);
}

}  // namespace halfdisk
