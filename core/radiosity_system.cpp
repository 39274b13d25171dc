#include "radiosity_system.h"

#include <algorithm>
#include <stdexcept>

#include "arc_measure.h"
#include "cholesky.h"
#include "form_factors.h"
#include "quadrature.h"

namespace halfdisk {
namespace {

/// Of the matrix I - rho F: below this, a room gives back all light, to rounding.
constexpr double kLeastRcond = 1e-13;

/// Where on the way from A to B (0 ... 1) the shadow of a corner ends; outside of that if nowhere.
double shadowEdge(const DeltaLight& light, Vec2 corner, Vec2 A, Vec2 B) {
    const auto* point = std::get_if<PointLight>(&light);
    const Vec2 way = point ? corner - point->position : std::get<DirectionalLight>(light).direction;
    const double s = cross(way, corner - A) / cross(way, B - A);
    const bool behind = glm::dot(way, A + s * (B - A) - corner) > 0.0;
    return behind ? s : -1.0;
}

/// 0, where any light's shadow begins or ends on the way from A to B, 1.
std::vector<double> piecesBetweenShadows(const Visibility& visibility, Vec2 A, Vec2 B) {
    std::vector<double> ends{0.0, 1.0};
    for (const DeltaLight& light : visibility.index().scene().lights)
        for (const Vec2 corner : visibility.corners())
            if (const double s = shadowEdge(light, corner, A, B); s > 0.0 && s < 1.0) ends.push_back(s);
    std::sort(ends.begin(), ends.end());
    return ends;
}

}  // namespace

// Between shadows, so that a beam through a slit is not missed between the nodes.
Rgb meanDirect(const Visibility& visibility, const Patch& patch) {
    const SegmentIndex& index = visibility.index();
    const bool sky = index.scene().environment.radiance != Rgb(0.0);
    Rgb sum{0.0};
    if (!sky && index.scene().lights.empty()) return sum;
    const Vec2 N = perp(patch.b - patch.a) / patch.length;
    const auto ends = piecesBetweenShadows(visibility, index.pointOn(patch.segment, patch.uFrom),
                                           index.pointOn(patch.segment, patch.uTo));
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece)
        for (const GaussPoint& point : kGauss8) {
            const double length = ends[piece + 1] - ends[piece],
                         s = ends[piece] + length * (1.0 + point.x) / 2.0;
            const double u = patch.uFrom + (patch.uTo - patch.uFrom) * s;
            const ShadedPoint at{index.pointOn(patch.segment, u), N, patch.segment};
            Rgb E = deltaIrradiance(index, at);
            if (sky)
                for (const VisibleArc& arc : visibility.arcs(at))
                    if (!arc.hit) E += index.environment(middleOf(at, arc)) * cosineBetween(arc.from, arc.to);
            sum += E * (length * point.weight / 2.0);
        }
    return sum;
}

namespace {

/// What patches exchange, and what each does with light.
struct System {
    SquareMatrix exchange;  // l_i F_ij: symmetric
    Column length;          // l_i
    Columns albedo;
    Columns emission;
    Columns direct;  // E straight from lights that are no patches

    /// Radiance that arrives, to be scattered: sum over j of F_ij light_j.
    Columns arriving(const Columns& light, const StopQuestion& stop) const {
        return product(exchange, light, stop).array().colwise() / length.array();
    }
    /// Radiance that is scattered exactly once.
    Columns first(const StopQuestion& stop) const {
        return albedo.cwiseProduct(direct / 2.0 + arriving(emission, stop));
    }
};

System systemOf(const Visibility& visibility, const Patches& patches, const StopQuestion& stop) {
    const SegmentIndex& index = visibility.index();
    const auto size = static_cast<Eigen::Index>(patches.size());
    ExchangeLengths lengths = exchangeLengths(index, patches, stop);
    System system{
        {size, std::move(lengths.all)}, Column(size), Columns(size, 3), Columns(size, 3), Columns(size, 3)};
    for (Eigen::Index i = 0; i < size; ++i) {
        throwIfStopped(stop);
        const Patch& patch = patches.all()[static_cast<std::size_t>(i)];
        const Rgb albedo = std::get<Diffuse>(index.material(patch.segment)).albedo;
        const Rgb emission = index.scene().segments[patch.segment].emission;
        const Rgb E = meanDirect(visibility, patch);
        system.length[i] = patch.length;
        system.albedo.row(i) << albedo.x, albedo.y, albedo.z;
        system.emission.row(i) << emission.x, emission.y, emission.z;
        system.direct.row(i) << E.x, E.y, E.z;
    }
    return system;
}

Columns bounced(const System& system, std::uint32_t bounces, const StopQuestion& stop) {
    Columns light = system.first(stop), sum = light;
    for (std::uint32_t k = 1; k < bounces; ++k) {
        light = system.albedo.cwiseProduct(system.arriving(light, stop));
        sum += light;
    }
    return sum;
}

/// S = b + rho F S of one channel, for the columns b. With R^2 = rho / l and X = l F, which is symmetric, it
/// is S = b + R z, where (I - R X R) z = R X b: symmetric and positive definite where light is absorbed.
class EndlessBounces {
 public:
    EndlessBounces(const System& system, Eigen::Index channel, const StopQuestion& stop)
        : system_(system),
          root_((system.albedo.col(channel).array() / system.length.array()).sqrt()),
          stop_(stop) {
        const Eigen::Index size = root_.size();
        factor_ = {size, std::make_unique_for_overwrite<double[]>(static_cast<std::size_t>(size * size))};
        for (Eigen::Index i = 0; i < size; ++i) {
            throwIfStopped(stop, static_cast<std::uint64_t>(i));
            factor_.map().row(i) = system.exchange.map().row(i).cwiseProduct(root_.transpose()) * -root_[i];
            factor_.map()(i, i) += 1.0;
        }
        isFinite_ = factorize(factor_, stop);
    }

    Columns of(const Columns& b) const {
        Columns z = product(system_.exchange, b, stop_).array().colwise() * root_.array();
        solve(factor_, z, stop_);
        return b.array() + z.array().colwise() * root_.array();
    }

    /// No entry of the inverse of I - rho F is negative, so it is as large as the sums of its rows: what the
    /// room makes of a radiance of 1 everywhere.
    bool isFinite() const {
        if (!isFinite_) return false;
        const Columns ofOne = of(Columns::Ones(root_.size(), 1));
        const double most = ofOne.maxCoeff();
        return ofOne.minCoeff() > 0.0 && 2.0 * most * kLeastRcond < 1.0;
    }

 private:
    const System& system_;
    Column root_;  // R
    SquareMatrix factor_;
    const StopQuestion& stop_;
    bool isFinite_ = false;
};

Columns solved(const System& system, const StopQuestion& stop) {
    const Columns first = system.first(stop);
    Columns sum(first.rows(), 3);
    std::unique_ptr<EndlessBounces> endless;
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
        if (channel == 0 || system.albedo.col(channel) != system.albedo.col(channel - 1)) {
            endless.reset();  // gives its memory back first
            endless = std::make_unique<EndlessBounces>(system, channel, stop);
            if (!endless->isFinite())
                throw std::invalid_argument(
                    "light that is never absorbed has no end to solve for: albedo 1 all around; bounce it "
                    "instead, or lower an albedo");
        }
        sum.col(channel) = endless->of(first.col(channel));
    }
    return sum;
}

}  // namespace

std::vector<Rgb> scatteredRadiance(const Visibility& visibility, const Patches& patches,
                                   std::optional<std::uint32_t> bounces, const StopQuestion& stop) {
    std::vector<Rgb> scattered(patches.size(), Rgb(0.0));
    if (patches.size() == 0 || bounces == 0u) return scattered;
    const System system = systemOf(visibility, patches, stop);
    const Columns sum = bounces ? bounced(system, *bounces, stop) : solved(system, stop);
    for (std::size_t i = 0; i < scattered.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        scattered[i] = {sum(row, 0), sum(row, 1), sum(row, 2)};
    }
    return scattered;
}

}  // namespace halfdisk
