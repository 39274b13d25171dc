// Does every material draw by the density that it states, reciprocally, without making energy?
#include <doctest/doctest.h>

#include <cmath>

#include "core/estimator.h"
#include "core/quadrature.h"
#include "core/surface.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

struct MaterialRow {
    const char* name;
    Material material;
};

std::vector<MaterialRow> scatteringMaterials() {
    return {{"diffuse", Diffuse{Rgb(0.9, 0.5, 0.1)}},
            {"glossy 0", Glossy{Rgb(1.0), 0.0}},
            {"glossy 1", Glossy{Rgb(0.9), 1.0}},
            {"glossy 7.5", Glossy{Rgb(1.0, 0.5, 0.2), 7.5}},
            {"glossy 300", Glossy{Rgb(1.0), 300.0}},
            {"mix with a mirror", Mix{Diffuse{Rgb(0.6)}, Mirror{Rgb(0.9)}, 0.3}},
            {"mix with glossy", Mix{Diffuse{Rgb(0.6)}, Glossy{Rgb(0.9), 25.0}, 0.6}}};
}

std::vector<MaterialRow> allMaterials() {
    auto all = scatteringMaterials();
    all.push_back({"mirror", Mirror{Rgb(0.9, 0.8, 0.7)}});
    all.push_back({"glass", Dielectric{1.5, Rgb(0.0)}});
    all.push_back({"glass from within", Dielectric{1.5, Rgb(0.0)}});
    all.push_back({"index 1", Dielectric{1.0, Rgb(0.0)}});
    all.push_back({"index 4", Dielectric{4.0, Rgb(0.0)}});
    return all;
}

const Vec2 kUp(0.0, 1.0);

// From the normal, rad.
Vec2 at(double angle) {
    return {std::sin(angle), std::cos(angle)};
}

SurfacePoint surface(const Material& material, double angle, bool front = true) {
    return {Vec2(0.0), kUp, kUp, at(angle), 0, front, kNoMedium, &material};
}

ScatterDraws drawsFrom(Random& random) {
    const double coin = random.in(0.0, 1.0), u = random.in(0.0, 1.0);
    return {coin, u, random.in(0.0, 1.0)};
}

constexpr double kIncidences[] = {0.0, 0.4, -0.9, 1.3, 1.55};

/// Counts of draws over equal bins of the half-disk, against the integral of the pdf; the last cell is what
/// is left: lost below the wall, or specular.
double chiSquareOf(const Material& material, double angle, double stretch, Directions directions) {
    constexpr int kBins = 60, kDraws = 100'000;
    const SurfacePoint point = surface(material, angle);
    std::vector<double> expected(kBins + 1, 0.0);
    double left = kDraws;
    for (int bin = 0; bin < kBins; ++bin) {
        const double from = kPi * bin / kBins - kPi / 2, to = kPi * (bin + 1) / kBins - kPi / 2;
        const auto pdf = [&](double theta) {
            return Integrals<1>{pdfSurface(point, point.from, at(theta), directions)};
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

TEST_CASE("materials: light goes both ways alike") {
    Random random(3);
    for (const MaterialRow& row : scatteringMaterials())
        for (int i = 0; i < 1000; ++i) {
            const double a = random.in(-1.57, 1.57), b = random.in(-1.57, 1.57);
            const Rgb there = evalSurface(surface(row.material, a), at(b), at(a));
            const Rgb back = evalSurface(surface(row.material, b), at(a), at(b));
            REQUIRE(there.x == doctest::Approx(back.x).epsilon(1e-9));
            REQUIRE(there.z == doctest::Approx(back.z).epsilon(1e-9));
        }
}

TEST_CASE("materials: no more light leaves than arrives, from any angle") {
    Random random(5);
    for (const MaterialRow& row : allMaterials())
        for (int k = 0; k <= 40; ++k) {
            const double angle = -1.57 + 3.14 * k / 40.0;
            const SurfacePoint point =
                surface(row.material, angle, std::string(row.name) != "glass from within");
            Statistics sent;
            for (int i = 0; i < 4000; ++i) {
                const auto way = sampleSurface(point, Carried::power, drawsFrom(random));
                sent.add(way ? way->weight : Rgb(0.0));
            }
            INFO(row.name << " at " << angle);
            for (int c = 0; c < 3; ++c) {
                CHECK(sent.mean[c] <= 1.0 + kSweep * sent.standardError()[c] + 1e-12);
                CHECK(sent.mean[c] >= 0.0);
            }
        }
}

TEST_CASE("materials: what is drawn sums to the integral of the BRDF") {
    Random random(6);
    for (const MaterialRow& row : scatteringMaterials())
        for (const double angle : kIncidences) {
            const SurfacePoint point = surface(row.material, angle);
            const auto reflected = [&](double theta) {
                return Integrals<1>{evalSurface(point, at(theta), point.from).x * std::cos(theta)};
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

TEST_CASE("materials: exact albedos of a lobe") {
    // At normal incidence the lobe loses nothing: albedo. At a slant, with exponent 1, (I - a part) by
    // quadrature is less.
    for (const double exponent : {0.0, 1.0, 2.0, 10.0, 1000.0}) {
        const Material material = Glossy{Rgb(0.7), exponent};
        const SurfacePoint point = surface(material, 0.0);
        const auto reflected = [&](double theta) {
            return Integrals<1>{evalSurface(point, at(theta), point.from).x * std::cos(theta)};
        };
        CHECK(integrate<1>(reflected, -kPi / 2, kPi / 2, {1e-13}, 30)[0] ==
              doctest::Approx(0.7).epsilon(1e-10));
    }
}

TEST_CASE("materials: the integral of a lobe") {
    for (const double n : {0.0, 0.3, 1.0, 2.0, 3.5, 7.0, 47.9, 48.0, 100.0, 1e4}) {
        const double exact = std::sqrt(kPi) * std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2 + 1));
        INFO(n);
        CHECK(lobeIntegral(n) == doctest::Approx(exact).epsilon(1e-11));
    }
    CHECK(std::abs(lobeIntegral(0.0) - kPi) < 1e-12);
    CHECK(std::abs(lobeIntegral(1.0) - 2.0) < 1e-12);
    CHECK(std::abs(lobeIntegral(2.0) - kPi / 2) < 1e-12);
}

TEST_CASE("materials: roughness 0 and 1, and between") {
    CHECK(exponentOfRoughness(1.0) == 0.0);
    CHECK(exponentOfRoughness(0.0) == kMostExponent);
    CHECK(exponentOfRoughness(0.5) == doctest::Approx(6.0));
    double before = kMostExponent;
    for (int i = 0; i <= 1000; ++i) {
        const double exponent = exponentOfRoughness(i / 1000.0);
        REQUIRE(exponent <= before);
        REQUIRE(exponent >= 0.0);
        before = exponent;
    }
}

TEST_CASE("materials: which of them send light in one direction only") {
    Random random(8);
    for (const MaterialRow& row : allMaterials()) {
        const SurfacePoint point = surface(row.material, 0.5);
        int deltas = 0, draws = 0;
        for (int i = 0; i < 2000; ++i) {
            const auto way = sampleSurface(point, Carried::radiance, drawsFrom(random));
            if (!way) continue;
            ++draws;
            deltas += way->isDelta() ? 1 : 0;
        }
        INFO(row.name);
        const auto* mix = std::get_if<Mix>(&row.material);
        if (isSpecular(row.material)) {
            CHECK(deltas == draws);
            CHECK(evalSurface(point, at(-0.5), at(0.5)) == Rgb(0.0));
            CHECK(pdfSurface(point, at(0.5), at(-0.5)) == 0.0);
        } else if (mix && std::holds_alternative<Mirror>(mix->specular)) {
            CHECK(deltas == doctest::Approx(mix->weight * draws).epsilon(0.12));
        } else {
            CHECK(deltas == 0);
        }
    }
}

TEST_CASE("glass: Fresnel and Snell") {
    CHECK(refraction(1.0, 1.0, 1.5).reflected == doctest::Approx(0.04).epsilon(1e-14));
    CHECK(refraction(1.0, 1.5, 1.0).reflected == doctest::Approx(0.04).epsilon(1e-14));
    CHECK(refraction(1e-9, 1.0, 1.5).reflected == doctest::Approx(1.0).epsilon(1e-7));
    // At Brewster's angle p vanishes: R = s / 2 with s = ((n^2 - 1) / (n^2 + 1))^2.
    const double brewster = std::atan(1.5), s = 1.25 / 3.25;
    CHECK(refraction(std::cos(brewster), 1.0, 1.5).reflected == doctest::Approx(s * s / 2).epsilon(1e-13));
    const double critical = std::asin(1.0 / 1.5);
    CHECK(refraction(std::cos(critical + 1e-9), 1.5, 1.0).reflected == 1.0);
    CHECK(refraction(std::cos(critical - 1e-6), 1.5, 1.0).reflected < 1.0);
    Random random(9);
    for (int i = 0; i < 1000; ++i) {
        const double n = random.in(1.0, 4.0), angle = random.in(0.0, 1.57);
        const Refraction in = refraction(std::cos(angle), 1.0, n);
        // The way back loses as much.
        REQUIRE(refraction(in.cosine, n, 1.0).reflected == doctest::Approx(in.reflected).epsilon(1e-9));
        REQUIRE(std::sqrt(1 - in.cosine * in.cosine) * n == doctest::Approx(std::sin(angle)).epsilon(1e-9));
    }
}

TEST_CASE(
    "glass: radiance scales by the ratio of the indices, power does not, and index 1 is nothing at all") {
    const Material glass = Dielectric{1.5, Rgb(0.0)}, nothing = Dielectric{1.0, Rgb(0.0)};
    const ScatterDraws through{0.999, 0.5, 0.5};
    CHECK(sampleSurface(surface(glass, 0.4, true), Carried::radiance, through)->weight.x ==
          doctest::Approx(1 / 1.5));
    CHECK(sampleSurface(surface(glass, 0.4, false), Carried::radiance, through)->weight.x ==
          doctest::Approx(1.5));
    CHECK(sampleSurface(surface(glass, 0.4, true), Carried::power, through)->weight.x == 1.0);
    CHECK(sampleSurface(surface(glass, 0.4, true), Carried::radiance, {0.001, 0.5, 0.5})->weight.x == 1.0);
    for (const double angle : {0.0, 0.7, 1.5, 1.5707}) {
        const auto way = sampleSurface(surface(nothing, angle), Carried::radiance, {1e-16, 0.5, 0.5});
        CHECK(glm::length(way->direction + at(angle)) < 1e-15);
        CHECK(way->weight.x == 1.0);
    }
}

TEST_CASE("mirror: the angle out is the angle in") {
    const Material mirror = Mirror{Rgb(0.5)};
    const auto way = sampleSurface(surface(mirror, 0.6), Carried::radiance, {0.3, 0.3, 0.3});
    CHECK(glm::length(way->direction - at(-0.6)) < 1e-15);
    CHECK(way->weight == Rgb(0.5));
    CHECK(way->isDelta());
}
