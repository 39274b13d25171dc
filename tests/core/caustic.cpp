#include "caustic.h"

#include <cmath>

#include "core/surface.h"

namespace halfdisk::test {
namespace {

void deposit(const CausticSetup& setup, std::vector<double>& bins, double x, double power) {
    const double place = (x + setup.halfFloor) / (2.0 * setup.halfFloor) * setup.bins;
    if (place < 0.0 || place >= setup.bins) return;
    bins[static_cast<std::size_t>(place)] += power / (2.0 * setup.halfFloor / setup.bins);
}

double passes(double cosIn, double cosOut, double n1, double n2) {
    const double s = (n1 * cosIn - n2 * cosOut) / (n1 * cosIn + n2 * cosOut);
    const double p = (n2 * cosIn - n1 * cosOut) / (n2 * cosIn + n1 * cosOut);
    return 1.0 - (s * s + p * p) / 2.0;
}

}  // namespace

Scene causticScene(const CausticSetup& setup, std::uint32_t facets, bool smooth) {
    Scene scene;
    scene.materials = {Dielectric{setup.ior, Rgb(0.0)}, Diffuse{Rgb(0.0)}};
    scene.materialNames = {"glass", "black"};
    const auto at = [&](std::uint32_t k) {
        const double angle = 2.0 * kPi * (k % facets) / facets;
        return Vec2(std::cos(angle), std::sin(angle));
    };
    for (std::uint32_t k = 0; k < facets; ++k) {
        Segment wall;
        wall.a = Vec2(0.0, setup.height) + setup.radius * at(k + 1);
        wall.b = Vec2(0.0, setup.height) + setup.radius * at(k);
        if (smooth) {
            wall.normalA = at(k + 1);
            wall.normalB = at(k);
        }
        scene.segments.push_back(wall);
        scene.segmentNames.push_back("disk." + std::to_string(k));
    }
    Segment floor;
    floor.a = {-setup.halfFloor, 0.0};
    floor.b = {setup.halfFloor, 0.0};
    floor.material = 1;
    scene.segments.push_back(floor);
    scene.segmentNames.push_back("floor");
    scene.lights.push_back(DirectionalLight{});
    return scene;
}

std::vector<double> exactCaustic(const CausticSetup& setup, std::uint64_t rays) {
    std::vector<double> bins(setup.bins, 0.0);
    for (std::uint64_t i = 0; i < rays; ++i) {
        const double sine = 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(rays) - 1.0;
        const double in = std::asin(sine), refracted = std::asin(sine / setup.ior);
        const double passed = passes(std::cos(in), std::cos(refracted), 1.0, setup.ior);
        // The chord spans the central angle pi - 2 refracted, so the ray leaves at this angle from the lowest
        // point, and it has been turned towards the axis twice.
        const double exit = 2.0 * refracted - in, turned = 2.0 * (in - refracted);
        const double x = setup.radius * std::sin(exit), y = setup.height - setup.radius * std::cos(exit);
        const double power = passed * passed * 2.0 * setup.radius / static_cast<double>(rays);
        if (turned < kPi / 2 && turned > -kPi / 2) deposit(setup, bins, x - y * std::tan(turned), power);
    }
    return bins;
}

std::vector<double> facetCaustic(const CausticSetup& setup, std::uint32_t facets, bool smooth,
                                 std::uint64_t rays) {
    const Scene scene = causticScene(setup, facets, smooth);
    const SegmentIndex index(scene);
    std::vector<double> bins(setup.bins, 0.0);
    // A coin that always chooses to refract, where that is possible.
    const ScatterDraws refract{1.0 - 0x1p-53, 0.5, 0.5};
    for (std::uint64_t i = 0; i < rays; ++i) {
        const double x =
            setup.radius * (2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(rays) - 1.0);
        Ray ray{{x, setup.height + 2.0 * setup.radius}, {0.0, -1.0}};
        double power = 2.0 * setup.radius / static_cast<double>(rays);
        for (int event = 0; event < 2 && power > 0.0; ++event) {
            const Hit hit = index.closestHit(ray);
            if (!hit || hit.segment == facets) {
                power = 0.0;
                break;
            }
            const SurfacePoint at = surfaceAt(index, ray, hit);
            const double n1 = at.front ? 1.0 : setup.ior, n2 = at.front ? setup.ior : 1.0;
            power *= 1.0 - refraction(glm::dot(at.round, at.from), n1, n2).reflected;
            ray = leave(index, at, *sampleSurface(at, Carried::power, refract), 1);
        }
        const Hit floor = index.closestHit(ray);
        if (power > 0.0 && floor.segment == facets)
            deposit(setup, bins, ray.origin.x + floor.t * ray.direction.x, power);
    }
    return bins;
}

CausticError causticError(const std::vector<double>& exact, const std::vector<double>& other) {
    double distance = 0.0, whole = 0.0, power = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        distance += std::abs(exact[i] - other[i]);
        whole += exact[i];
        power += other[i];
    }
    return {distance / whole, power / whole - 1.0};
}

}  // namespace halfdisk::test
