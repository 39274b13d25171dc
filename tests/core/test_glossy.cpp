// Are a lobe's integral, albedo and exponent what the formulas say?
#include <doctest/doctest.h>

#include "core/quadrature.h"
#include "material_rows.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("materials: exact albedos of a lobe") {
    // At normal incidence the lobe loses nothing: albedo. At a slant, with exponent 1, (I - a part) by
    // quadrature is less.
    for (const double exponent : {0.0, 1.0, 2.0, 10.0, 1000.0}) {
        const Material material = Glossy{Rgb(0.7), exponent};
        const SurfacePoint point = seenAt(material, 0.0);
        const auto reflected = [&](double theta) {
            return Integrals<1>{evalSurface(point, fromNormal(theta), point.from).x * std::cos(theta)};
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
