// Do glass and mirrors send light where Fresnel and Snell say, and how much?
#include <doctest/doctest.h>

#include "material_rows.h"

using namespace halfdisk;
using namespace halfdisk::test;

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
    CHECK(sampleSurface(seenAt(glass, 0.4, true), Carried::radiance, through)->weight.x ==
          doctest::Approx(1 / 1.5));
    CHECK(sampleSurface(seenAt(glass, 0.4, false), Carried::radiance, through)->weight.x ==
          doctest::Approx(1.5));
    CHECK(sampleSurface(seenAt(glass, 0.4, true), Carried::power, through)->weight.x == 1.0);
    CHECK(sampleSurface(seenAt(glass, 0.4, true), Carried::radiance, {0.001, 0.5, 0.5})->weight.x == 1.0);
    for (const double angle : {0.0, 0.7, 1.5, 1.5707}) {
        const auto way = sampleSurface(seenAt(nothing, angle), Carried::radiance, {1e-16, 0.5, 0.5});
        CHECK(glm::length(way->direction + fromNormal(angle)) < 1e-15);
        CHECK(way->weight.x == 1.0);
    }
}

TEST_CASE("mirror: the angle out is the angle in") {
    const Material mirror = Mirror{Rgb(0.5)};
    const auto way = sampleSurface(seenAt(mirror, 0.6), Carried::radiance, {0.3, 0.3, 0.3});
    CHECK(glm::length(way->direction - fromNormal(-0.6)) < 1e-15);
    CHECK(way->weight == Rgb(0.5));
    CHECK(way->isDelta());
}
