// Are exact pictures exact? Against closed forms, and against what unbiased estimators converge to.
#include <doctest/doctest.h>

#include "agreement.h"
#include "core/exact_picture.h"
#include "rooms.h"
#include "run_estimator.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Sensor stripAt(Vec2 position, Vec2 direction, std::uint32_t width) {
    return EyeStrip{Eye{position, glm::normalize(direction), 1.2}, width};
}

/// All that differs from what is said of it, as a share of that.
double worstShare(const std::vector<Rgb>& pixels, double expected) {
    double worst = 0.0;
    for (const Rgb& pixel : pixels)
        for (int channel = 0; channel < 3; ++channel)
            worst = std::max(worst, std::abs(pixel[channel] / expected - 1.0));
    return worst;
}

}  // namespace

TEST_CASE("exact picture: in a closed room that glows all over every pixel is the same series") {
    const Scene scene = polygonRoom(furnacePolygon(), Rgb(0.6), Rgb(2.0));
    const SegmentIndex index(scene);
    const Sensor strip = stripAt({1.2, 0.9}, {1.0, 0.2}, 40), profile = Profile{{0, 2}, 24};
    for (const unsigned depth : {0u, 1u, 3u}) {
        const Reference reference(index, depth + 1);
        const double L = closedRoomRadiance(2.0, 0.6, static_cast<int>(depth) + 1);
        const double E = 2.0 * closedRoomRadiance(2.0, 0.6, static_cast<int>(depth));
        // Direct light to quadrature's error; beyond it the reference's interpolation, see reference.h.
        const double err = depth < 2 ? 1e-6 : 1e-3;
        CHECK(worstShare(exactPicture(reference, strip, depth), L) < err);
        CHECK(worstShare(exactPicture(reference, profile, depth), E) < err);
    }
}

TEST_CASE("exact picture: a bin is the mean of the closed form over it, also across two walls") {
    Scene scene;
    addWall(scene, {-2.0, 0.0}, {0.5, 0.0});
    addWall(scene, {0.5, 0.0}, {2.0, 0.0});
    addWall(scene, {0.4, 1.0}, {-0.7, 1.2}, Rgb(0.0), Rgb(3.0));
    const SegmentIndex index(scene);
    const Reference reference(index, 1);
    const std::vector<Rgb> bins = exactPicture(reference, Profile{{0, 1}, 10}, 0);
    REQUIRE(bins.size() == 10);
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        constexpr int kPoints = 4000;
        double sum = 0.0;
        for (int i = 0; i < kPoints; ++i) {
            const double x = -2.0 + 4.0 * (static_cast<double>(bin) + (i + 0.5) / kPoints) / 10.0;
            sum += segmentIrradiance({x, 0.0}, {0.0, 1.0}, scene.segments[2]).x;
        }
        CHECK(bins[bin].x == doctest::Approx(sum / kPoints).epsilon(1e-6));
    }
}

TEST_CASE("exact picture: unbiased estimators converge to it, and a picture two percent off is rejected") {
    Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Sensor strip = stripAt({-1.6, 1.0}, {1.0, -0.3}, 16), profile = Profile{{0}, 8};
    for (const Sensor& sensor : {strip, profile})
        for (const std::uint32_t depth : {0u, 1u, 2u}) {
            const Reference reference(index, depth + 1);
            const std::vector<Rgb> exact = exactPicture(reference, sensor, depth);
            const Film film =
                runEstimator(*findEstimator("path"), index, sensor, {.maxDepth = depth, .passes = 40'000});
            // Of the interpolation, by reference.h; of the quadrature, by exact_picture.h.
            const double err = depth < 2 ? 2e-4 : 1e-3;
            const Agreement agreement = compareExact(film, exact, err, 12);
            CHECK_MESSAGE(agreement.holds(), sensor.index(), " depth ", depth, ": ", agreement.where);
            std::vector<Rgb> biased = exact;
            for (Rgb& pixel : biased) pixel *= 1.02;
            CHECK_FALSE(compareExact(film, biased, err, 12).holds());
            CHECK(*relativeError(biased, exact) == doctest::Approx(0.02).epsilon(0.5));
            CHECK(*relativeError(film.pixels.mean, exact) < 0.05);
        }
}

TEST_CASE("exact picture: an error of nothing is nothing, and what cannot be compared has none") {
    const std::vector<Rgb> exact{Rgb(1.0), Rgb(3.0)};
    CHECK(*relativeError(exact, exact) == 0.0);
    CHECK(*relativeError({Rgb(2.0), Rgb(4.0)}, exact) == doctest::Approx(0.5));
    CHECK_FALSE(relativeError({Rgb(1.0)}, exact));
    CHECK_FALSE(relativeError({Rgb(1.0)}, {Rgb(0.0)}));
    CHECK_FALSE(relativeError({}, {}));
}

TEST_CASE("exact picture: it can be called off") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const Reference reference(index, 1);
    CHECK_THROWS_AS(exactPicture(reference, Profile{{0}, 8}, 0, [] { return true; }), Stopped);
}

TEST_CASE("exact picture: in narrow gaps it is what every point gets, and never below zero") {
    // A lamp that almost lies on the ceiling of a white box: behind it nearly nothing arrives.
    for (const double gap : {0.03, 0.01, 0.001}) {
        Scene scene = polygonRoom({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, Rgb(1.0));
        addWall(scene, {0.6, 1.0 - gap}, {0.4, 1.0 - gap}, Rgb(1.0), Rgb(1.0));
        const SegmentIndex index(scene);
        const Reference reference(index, 2);
        constexpr std::uint32_t kBins = 32;
        const Profile ceiling{{2}, kBins};
        const std::vector<Rgb> bins = exactPicture(reference, ceiling, 1);
        double squares = 0.0, mean = 0.0;
        for (std::uint32_t bin = 0; bin < kBins; ++bin) {
            constexpr int kPoints = 40;
            double sum = 0.0;
            for (int i = 0; i < kPoints; ++i)
                sum +=
                    reference.irradiance(shadedPointOn(index, 2, (bin + (i + 0.5) / kPoints) / kBins), 1).x /
                    kPoints;
            squares += (bins[bin].x - sum) * (bins[bin].x - sum) / kBins;
            mean += sum / kBins;
            CHECK(bins[bin].x > -1e-5);
        }
        CAPTURE(gap);
        CHECK(std::sqrt(squares) < 2e-3 * mean);
        CHECK(reference.interpolationError(ceiling.segments, 1) < 1e-3 * mean);
    }
}
