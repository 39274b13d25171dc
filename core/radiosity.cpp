#include "radiosity.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>

#include "arc_measure.h"
#include "form_factors.h"
#include "quadrature.h"

namespace halfdisk {
namespace {

/// One column a colour channel, one row a patch.
using Column = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Of the matrix I - rho F: below this, a room gives back all light, to rounding.
constexpr double kLeastRcond = 1e-13;

/// Mean irradiance of a patch straight from point lights, directional lights and the environment.
Rgb meanDirect(const Visibility& visibility, const Patch& patch) {
    const SegmentIndex& index = visibility.index();
    const bool sky = index.scene().environment.radiance != Rgb(0.0);
    Rgb sum{0.0};
    if (!sky && index.scene().lights.empty()) return sum;
    const Vec2 N = perp(patch.b - patch.a) / patch.length;
    for (const GaussPoint& point : kGauss8) {
        const double u = patch.uFrom + (patch.uTo - patch.uFrom) * (1.0 + point.x) / 2.0;
        const ShadedPoint at{index.pointOn(patch.segment, u), N, patch.segment};
        Rgb E = deltaIrradiance(index, at);
        if (sky)
            for (const VisibleArc& arc : visibility.arcs(at))
                if (!arc.hit) E += index.environment(middleOf(at, arc)) * cosineBetween(arc.from, arc.to);
        sum += E * (point.weight / 2.0);
    }
    return sum;
}

/// The form factors, and what a patch does with light.
struct System {
    Matrix factors;  // F_ij
    Column albedo;
    Column emission;
    Column first;  // radiance scattered exactly once
};

System systemOf(const Visibility& visibility, const Patches& patches) {
    const SegmentIndex& index = visibility.index();
    const auto size = static_cast<Eigen::Index>(patches.size());
    const std::vector<double> lengths = exchangeLengths(index, patches);
    System system{Eigen::Map<const Matrix>(lengths.data(), size, size), Column(size, 3), Column(size, 3),
                  Column(size, 3)};
    Column direct(size, 3);
    for (Eigen::Index i = 0; i < size; ++i) {
        const Patch& patch = patches.all()[static_cast<std::size_t>(i)];
        const Rgb albedo = std::get<Diffuse>(index.material(patch.segment)).albedo;
        const Rgb emission = index.scene().segments[patch.segment].emission;
        const Rgb E = meanDirect(visibility, patch);
        system.factors.row(i) /= patch.length;
        system.albedo.row(i) << albedo.x, albedo.y, albedo.z;
        system.emission.row(i) << emission.x, emission.y, emission.z;
        direct.row(i) << E.x, E.y, E.z;
    }
    system.first = system.albedo.cwiseProduct(direct / 2.0 + system.factors * system.emission);
    return system;
}

Column bounced(const System& system, std::uint32_t bounces) {
    Column sum = Column::Zero(system.first.rows(), 3), light = system.first;
    for (std::uint32_t k = 0; k < bounces; ++k) {
        sum += light;
        light = system.albedo.cwiseProduct(system.factors * light);
    }
    return sum;
}

Column solved(const System& system) {
    const Eigen::Index size = system.first.rows();
    Column sum(size, 3);
    Eigen::PartialPivLU<Matrix> inverse;
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
        const bool another = channel == 0 || system.albedo.col(channel) != system.albedo.col(channel - 1);
        if (another) {
            inverse.compute(Matrix::Identity(size, size) -
                            system.albedo.col(channel).asDiagonal() * system.factors);
            if (!(inverse.rcond() > kLeastRcond))
                throw std::invalid_argument(
                    "light that is never absorbed has no end to solve for: albedo 1 all around; bounce it "
                    "instead, or lower an albedo");
        }
        sum.col(channel) = inverse.solve(system.first.col(channel));
    }
    return sum;
}

}  // namespace

Radiosity::Radiosity(const SegmentIndex& index, std::uint32_t patches, std::optional<std::uint32_t> bounces)
    : visibility_(index), patches_(visibility_, patches), scattered_(patches_.size(), Rgb(0.0)) {
    if (patches_.size() == 0 || bounces == 0u) return;
    const System system = systemOf(visibility_, patches_);
    const Column sum = bounces ? bounced(system, *bounces) : solved(system);
    for (std::size_t i = 0; i < scattered_.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        scattered_[i] = {sum(row, 0), sum(row, 1), sum(row, 2)};
    }
}

// The patches that are seen within an arc, each between its own two angles.
template <class Visit>
void Radiosity::forPatches(const ShadedPoint& at, const VisibleArc& arc, const Visit& visit) const {
    const Segment& wall = index().scene().segments[arc.hit.segment];
    const Vec2 origin = rayFrom(index(), at, at.N).origin;
    const auto patchAt = [&](double theta) {
        const Vec2 direction = directionAt(at, theta);
        const double u = cross(wall.a - origin, direction) / cross(direction, wall.b - wall.a);
        return patches_.at(arc.hit.segment, arc.hit.front, std::isfinite(u) ? u : arc.hit.u);
    };
    const std::size_t first = patchAt(arc.from), last = patchAt(arc.to);
    double from = arc.from;
    for (std::size_t patch = first; patch != last; patch < last ? ++patch : --patch) {
        const double u = first < last ? patches_.all()[patch].uTo : patches_.all()[patch].uFrom;
        const double border = thetaOf(at, wall.a + u * (wall.b - wall.a) - origin);
        const double to = std::clamp(border, from, arc.to);
        visit(patch, from, to);
        from = to;
    }
    visit(last, from, arc.to);
}

template <class Measure>
Rgb Radiosity::gather(const ShadedPoint& at, const Measure& measure, Counts& counts) const {
    const std::vector<VisibleArc> arcs = visibility_.arcs(at);
    counts.rays += arcs.size();
    Rgb sum{0.0};
    for (const VisibleArc& arc : arcs) {
        if (!arc.hit) {
            sum += index().environment(middleOf(at, arc)) * measure(arc.from, arc.to);
        } else if (isLitSide(index(), arc.hit)) {
            sum += index().scene().segments[arc.hit.segment].emission * measure(arc.from, arc.to);
            forPatches(at, arc, [&](std::size_t patch, double from, double to) {
                sum += scattered_[patch] * measure(from, to);
            });
        }
    }
    return sum;
}

Rgb Radiosity::irradiance(const ShadedPoint& at, Counts& counts) const {
    counts.rays += index().scene().lights.size();
    return deltaIrradiance(index(), at) + gather(at, cosineBetween, counts);
}

Rgb Radiosity::fluence(Vec2 P, Counts& counts) const {
    counts.rays += index().scene().lights.size();
    Rgb sum = deltaFluence(index(), P);
    for (const Vec2 N : {Vec2(0.0, 1.0), Vec2(0.0, -1.0)})
        sum += gather(
            {P, N}, [](double from, double to) { return to - from; }, counts);
    return sum;
}

}  // namespace halfdisk
