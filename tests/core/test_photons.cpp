// Are photons found where they lie, over the borders of facets and not over corners?
#include <doctest/doctest.h>

#include "core/estimators/photons.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("wall chains: facets of a round thing join, corners and other materials end a chain") {
    Scene scene = polygonRoom({{-3.0, -3.0}, {3.0, -3.0}, {3.0, 3.0}, {-3.0, 3.0}});
    const auto ring = regularPolygon(8);
    for (std::size_t k = 0; k < 8; ++k)
        scene.segments.push_back(
            {.a = ring[k], .b = ring[(k + 1) % 8], .normalA = ring[k], .normalB = ring[(k + 1) % 8]});
    const auto arc = regularPolygon(8, 2.0);
    scene.materials.push_back(Diffuse{});
    for (std::size_t k = 0; k < 4; ++k)
        scene.segments.push_back({.a = arc[k],
                                  .b = arc[k + 1],
                                  .material = k < 3 ? 0u : 1u,
                                  .normalA = arc[k] / 2.0,
                                  .normalB = arc[k + 1] / 2.0});
    const SegmentIndex index(scene);
    const WallChains chains(index);
    CHECK(chains.count() == 4 + 1 + 2);
    const double facet = 2.0 * std::sin(kPi / 8);
    const ChainPlace middle = chains.at(4 + 3, 0.5);
    CHECK(chains.isClosed(middle.chain));
    CHECK(chains.length(middle.chain) == doctest::Approx(8 * facet));
    CHECK(middle.along == doctest::Approx(3.5 * facet));
    CHECK(chains.within(4 + 3, middle.along) == doctest::Approx(0.5));
    const ChainPlace onArc = chains.at(12 + 2, 1.0);
    CHECK_FALSE(chains.isClosed(onArc.chain));
    CHECK(chains.length(onArc.chain) == doctest::Approx(3 * 2 * facet));
    CHECK(onArc.along == doctest::Approx(chains.length(onArc.chain)));
    CHECK(chains.at(12 + 3, 0.0).chain != onArc.chain);
    CHECK(chains.at(0, 0.5).chain != chains.at(1, 0.5).chain);
}

TEST_CASE("photons: sorted sums are the sums over all photons within the radius") {
    Scene scene = polygonRoom(furnacePolygon());
    const auto ring = regularPolygon(12, 0.3, {1.2, 0.8});
    for (std::size_t k = 0; k < 12; ++k)
        scene.segments.push_back({.a = ring[k],
                                  .b = ring[(k + 1) % 12],
                                  .twoSided = true,
                                  .normalA = (ring[k] - Vec2(1.2, 0.8)) / 0.3,
                                  .normalB = (ring[(k + 1) % 12] - Vec2(1.2, 0.8)) / 0.3});
    const SegmentIndex index(scene);
    const WallChains chains(index);
    Random random(7);
    const auto last = static_cast<std::int64_t>(scene.segments.size()) - 1;
    const auto anywhere = [&] {
        const auto segment = static_cast<std::uint32_t>(random.integer(0, last));
        return std::pair(segment, sideOf(chains, segment, random.in(0.0, 1.0), random.integer(0, 1) == 0));
    };
    std::vector<Photon> photons;
    for (int i = 0; i < 500; ++i) {
        const auto [segment, place] = anywhere();
        photons.push_back({place.side, segment, place.along, Rgb(random.in(0.0, 1.0), 0.0, 1.0), {0.0, 1.0}});
    }
    const PhotonMap map(index, chains, photons);
    for (int i = 0; i < 300; ++i) {
        const auto [segment, place] = anywhere();
        const double radius = std::exp(random.in(-4.0, 2.0));
        const double length = chains.length(place.side / 2);
        const bool closed = chains.isClosed(place.side / 2);
        Rgb sum{0.0};
        for (const Photon& photon : photons) {
            double gap = std::abs(photon.along - place.along);
            if (closed) gap = std::min(gap, length - gap);
            if (photon.side == place.side && gap <= radius) sum += photon.power;
        }
        const double covered =
            closed ? std::min(length, 2.0 * radius)
                   : std::min(length, place.along + radius) - std::max(0.0, place.along - radius);
        const Rgb found = map.irradiance(place, radius);
        for (int c = 0; c < 3; ++c) CHECK(found[c] == doctest::Approx(sum[c] / covered).epsilon(1e-12));
        CHECK(found.y == 0.0);
    }
}

TEST_CASE("photons: the radius shrinks by its product, also where a series replaces it") {
    for (const double a : {0.01, 0.5, 0.8, 0.999, 1.0}) {
        double product = 1.0;
        for (std::uint64_t pass = 0; pass < 3000; ++pass) {
            // z log z, 2e4, keeps 12 digits behind the point.
            REQUIRE(shrinking(a, pass) == doctest::Approx(product).epsilon(1e-11));
            product *= (static_cast<double>(pass) + 1.0 + a) / (static_cast<double>(pass) + 2.0);
        }
    }
    // As p^(a - 1) in the end.
    CHECK(shrinking(0.6, 2'000'000) / shrinking(0.6, 1'000'000) ==
          doctest::Approx(std::pow(2.0, -0.4)).epsilon(1e-6));
}
