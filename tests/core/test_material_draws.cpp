// Does every material draw by the density that it states?
#include <doctest/doctest.h>

#include "core/quadrature.h"
#include "material_rows.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// Counts of draws over equal bins of the half-disk, against the integral of the pdf; the last cell is what
/// is left: lost below the wall, or specular.
double chiSquareOf(const Material& material, double angle, double stretch, Directions directions) {
    constexpr int kBins = 60, kDraws = 100'000;
    const SurfacePoint point = seenAt(material, angle);
    std::vector<double> expected(kBins + 1, 0.0);
    double left = kDraws;
    for (int bin = 0; bin < kBins; ++bin) {
        const double from = kPi * bin / kBins - kPi / 2, to = kPi * (bin + 1) / kBins - kPi / 2;
        const auto pdf = [&](double theta) {
            return Integrals<1>{pdfSurface(point, point.from, fromNormal(theta), directions)};
        };
        expected[static_cast<std::size_t>(bin)] = kDraws * integrate<1>(pdf, from, to, {1e-10}, 20)[0];
        left -= expected[static_cast<std::size_t>(bin)];
    }
    expected[kBins] = std::max(left, 0.0);
    std::vector<std::uint64_t> observed(kBins + 1, 0);
    Random random(17);
    for (int i = 0; i < kDraws; ++i) {
        const auto way = sampleSurface(point, Carried::radiance, drawsFrom(random), directions);
        if (!way || way->isDelta()) {
            ++observed[kBins];
            continue;
        }
        const double theta = std::atan2(way->direction.x, way->direction.y) * stretch;
        ++observed[static_cast<std::size_t>(std::clamp((theta / kPi + 0.5) * kBins, 0.0, kBins - 1.0))];
    }
    // Cells with few expected are joined, or the statistic is not a chi-square.
    std::vector<double> e;
    std::vector<std::uint64_t> o;
    double eSum = 0.0;
    std::uint64_t oSum = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        eSum += expected[i];
        oSum += observed[i];
        if (eSum < 10.0) continue;
        e.push_back(eSum);
        o.push_back(oSum);
        eSum = 0.0;
        oSum = 0;
    }
    e.back() += eSum;
    o.back() += oSum;
    return e.size() < 2 ? 1.0 : chiSquareTest(o, e);
}

}  // namespace

TEST_CASE("materials: draws follow the density that is stated") {
    for (const MaterialRow& row : scatteringMaterials())
        for (const double angle : kIncidences)
            for (const Directions directions : {Directions::lobe, Directions::halfDisk}) {
                INFO(row.name << " at " << angle);
                CHECK(chiSquareOf(row.material, angle, 1.0, directions) > 1e-5);
            }
}

TEST_CASE("materials: a density that is off by two percent of the angle is rejected") {
    for (const MaterialRow& row : scatteringMaterials()) {
        INFO(row.name);
        CHECK(chiSquareOf(row.material, 0.4, 0.98, Directions::lobe) < 1e-5);
    }
}

TEST_CASE("materials: what is drawn sums to the integral of the BRDF") {
    Random random(6);
    for (const MaterialRow& row : scatteringMaterials())
        for (const double angle : kIncidences) {
            const SurfacePoint point = seenAt(row.material, angle);
            const auto reflected = [&](double theta) {
                return Integrals<1>{evalSurface(point, fromNormal(theta), point.from).x * std::cos(theta)};
            };
            const double exact = integrate<1>(reflected, -kPi / 2, kPi / 2, {1e-10}, 24)[0];
            for (const Directions directions : {Directions::lobe, Directions::halfDisk}) {
                Statistics drawn;
                for (int i = 0; i < 40'000; ++i) {
                    const auto way = sampleSurface(point, Carried::radiance, drawsFrom(random), directions);
                    drawn.add(way && !way->isDelta() ? way->weight : Rgb(0.0));
                }
                INFO(row.name << " at " << angle);
                CHECK(zTest(drawn, exact, 1e-9).within(kSweep));
                // Five percent too much is told apart wherever the draws are sure to one percent.
                if (drawn.standardError().x < 0.008 * exact)
                    CHECK_FALSE(zTest(drawn, exact * 1.05, 1e-9).within(kSweep));
            }
        }
}
