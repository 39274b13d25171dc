// Are the known cells of a field what it converges to? Against closed forms, and against unbiased estimators.
#include <doctest/doctest.h>

#include "agreement.h"
#include "core/exact_field.h"
#include "rooms.h"
#include "run_estimator.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// The known cells alone.
Film atCells(const Film& film, const KnownCells& known) {
    Film part = film;
    part.pixels.mean.resize(known.pixels.size());
    part.pixels.squares.resize(known.pixels.size());
    for (std::size_t i = 0; i < known.pixels.size(); ++i) {
        part.pixels.mean[i] = film.pixels.mean[known.pixels[i]];
        part.pixels.squares[i] = film.pixels.squares[known.pixels[i]];
    }
    return part;
}

}  // namespace

TEST_CASE("exact field: in a closed room that glows all over every cell within is 2 pi times the series") {
    const Scene scene = polygonRoom(furnacePolygon(), Rgb(0.6), Rgb(2.0));
    const SegmentIndex index(scene);
    const Field field{{1.0, 0.8}, {1.2, 1.0}, 6, 6};
    for (const unsigned depth : {0u, 1u, 3u}) {
        const Radiosity light(index, 200, depth);
        const KnownCells known = exactCells(light, field, 9);
        REQUIRE(known.pixels.size() == 9);
        CHECK(known.pixels.front() == 0);
        for (const Rgb& mean : known.mean)
            CHECK(mean.x == doctest::Approx(2.0 * kPi * closedRoomRadiance(2.0, 0.6, static_cast<int>(depth)))
                                .epsilon(depth < 2 ? 1e-9 : 1e-3));
    }
}

TEST_CASE("exact field: the mean over a cell with a point light in it is that of 1 / r") {
    Scene scene;
    scene.lights.emplace_back(PointLight{{0.5, 0.5}, Rgb(1.0)});
    const SegmentIndex index(scene);
    const Radiosity light(index, 1, 0u);
    const KnownCells known = exactCells(light, Field{{0.0, 0.0}, {1.0, 1.0}, 1, 1}, 1);
    // Its fluence is I / r: the integral of 1 / r over the square of side 1 about it is 4 ln(1 + sqrt 2).
    CHECK(known.mean[0].x == doctest::Approx(4.0 * std::log(1.0 + std::sqrt(2.0))).epsilon(0.02));
}

TEST_CASE("exact field: unbiased estimators converge to it, and a field two percent off is rejected") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Field field{{-1.5, 0.3}, {1.5, 1.5}, 12, 6};
    for (const std::uint32_t depth : {0u, 2u}) {
        const KnownCells known = exactCells(Radiosity(index, 800, depth), field, 20);
        REQUIRE(known.pixels.size() >= 12);
        const Film film =
            runEstimator(*findEstimator("light"), index, field, {.maxDepth = depth, .passes = 60'000});
        // Of the quadrature and of the patches, by exact_field.h.
        constexpr double kErr = 2e-3;
        const Agreement agreement = compareExact(atCells(film, known), known.mean, kErr, 2);
        CHECK_MESSAGE(agreement.holds(), "depth ", depth, ": ", agreement.where);
        std::vector<Rgb> biased = known.mean;
        for (Rgb& cell : biased) cell *= 1.02;
        CHECK_FALSE(compareExact(atCells(film, known), biased, kErr, 2).holds());
        CHECK(*relativeError(film.pixels.mean, known, field) < 0.05);
        std::vector<Rgb> brighter = film.pixels.mean;
        for (Rgb& cell : brighter) cell *= 1.5;
        CHECK(*relativeError(brighter, known, field) == doctest::Approx(0.5).epsilon(0.2));
        CHECK_FALSE(relativeError(known.mean, known, field));
    }
}

TEST_CASE("exact field: it can be called off") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Radiosity light(index, 20, 0u);
    CHECK_THROWS_AS(exactCells(light, Field{}, 10, [] { return true; }), Stopped);
}
