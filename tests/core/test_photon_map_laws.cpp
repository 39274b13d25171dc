// By what laws does the photon map trade bias for variance? Bias ~ r^2, variance ~ 1 / (M r), and none of
// either in the end if the radius shrinks.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "photon_kernel.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

// A floor that gets one bounce from a small patch, lit by a point light below it. Light falls off within
// about a metre, and a path meets the floor at most once after it was scattered.
constexpr double kPatchAlbedo = 0.8;
Scene patchOverFloor() {
    Scene scene;
    addWall(scene, {-3.0, 0.0}, {3.0, 0.0}, Rgb(0.5));
    addWall(scene, {0.2, 1.0}, {-0.2, 1.0}, Rgb(kPatchAlbedo));
    scene.lights.emplace_back(PointLight{{0.0, 0.9}, Rgb(1.0)});
    return scene;
}

struct Line {
    double slope, standardError;
};
// Least squares of y (each off by `error`) against x.
Line fitted(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& error) {
    double w = 0.0, wx = 0.0, wy = 0.0, wxx = 0.0, wxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double weight = 1.0 / (error[i] * error[i]);
        w += weight;
        wx += weight * x[i];
        wy += weight * y[i];
        wxx += weight * x[i] * x[i];
        wxy += weight * x[i] * y[i];
    }
    const double spread = w * wxx - wx * wx;
    return {(w * wxy - wx * wy) / spread, std::sqrt(w / spread)};
}

}  // namespace

TEST_CASE("photon map: bias grows as the radius squared") {
    const Scene scene = patchOverFloor();
    const SegmentIndex index(scene);
    const Reference reference(index, 1);
    const ShadedPoint at = shadedPointOn(index, 0, 0.5);
    const double exact = (reference.irradiance(at, 1) - reference.irradiance(at, 0)).x;
    std::vector<double> logRadius, logBias, error, predicted;
    std::uint64_t seed = 1;
    for (const double radius : {0.2, 0.28, 0.4, 0.56}) {
        const double mean = kernelMean(index, reference, 0, 0.5, radius, 1).x;
        const Statistics passes = indirectPasses(
            index, at, {{{"photons", 10000}, {"radius", radius}, {"gather", 0}}, 1, 100, seed++});
        CHECK(zTest(passes, mean).within(kSingle));
        const double bias = exact - passes.mean.x;  // a peak is blurred: darker
        REQUIRE(bias > 0.0);
        logRadius.push_back(std::log(radius));
        logBias.push_back(std::log(bias));
        error.push_back(passes.standardError().x / bias);
        predicted.push_back(std::log(exact - mean));
    }
    const Line found = fitted(logRadius, logBias, error);
    const double expected = fitted(logRadius, predicted, error).slope;
    INFO(fmt::format("slope {:.3f} +- {:.3f}, by quadrature {:.3f}", found.slope, found.standardError,
                     expected));
    CHECK(std::abs(found.slope - expected) <= kSingle * found.standardError);
    CHECK(found.standardError < 0.1);
    // The law itself holds for small radii: by quadrature, to the order r^4 that is left.
    const auto biasAt = [&](double radius) {
        return exact - kernelMean(index, reference, 0, 0.5, radius, 1).x;
    };
    CHECK(std::log2(biasAt(0.1) / biasAt(0.05)) == doctest::Approx(2.0).epsilon(0.01));
}

TEST_CASE("photon map: variance falls as 1 / (photons radius), as counting predicts") {
    const Scene scene = patchOverFloor();
    const SegmentIndex index(scene);
    const Reference reference(index, 1);
    const ShadedPoint at = shadedPointOn(index, 0, 0.5);
    const double weight = 2.0 * kPi * kPatchAlbedo;  // W, of a photon times their number
    // Variance over passes with its own error, from independent groups of passes; as logarithms.
    struct Measured {
        double logVariance, error;
    };
    const auto measured = [&](double photons, double radius) {
        Statistics groups;
        for (std::uint64_t group = 0; group < 25; ++group) {
            const Statistics passes = indirectPasses(
                index, at, {{{"photons", photons}, {"radius", radius}, {"gather", 0}}, 1, 80, 100 + group});
            groups.add(passes.variance());
        }
        // A path's photon counts or it does not: weight / 2r, with the probability that gives the mean.
        const double E = kernelMean(index, reference, 0, 0.5, radius, 1).x;
        const ZTest test = zTest(groups, E * (weight / (2.0 * radius) - E) / photons);
        INFO(fmt::format("photons {} radius {}: {}", photons, radius, test.text()));
        CHECK(test.within(kSingle));
        return Measured{std::log(groups.mean.x), groups.standardError().x / groups.mean.x};
    };
    const auto slopeOf = [&](const std::vector<double>& xs, const auto& at_) {
        std::vector<double> x, y, error;
        for (const double value : xs) {
            const Measured one = at_(value);
            x.push_back(std::log(value));
            y.push_back(one.logVariance);
            error.push_back(one.error);
        }
        return fitted(x, y, error);
    };
    const Line byPhotons =
        slopeOf({100, 200, 400, 800, 1600}, [&](double photons) { return measured(photons, 0.05); });
    const Line byRadius =
        slopeOf({0.005, 0.01, 0.02, 0.04, 0.08}, [&](double radius) { return measured(800, radius); });
    INFO(fmt::format("slopes {:.3f} +- {:.3f} by photons, {:.3f} +- {:.3f} by radius", byPhotons.slope,
                     byPhotons.standardError, byRadius.slope, byRadius.standardError));
    CHECK(std::abs(byPhotons.slope + 1.0) <= kSingle * byPhotons.standardError);
    // 1 / r - 2 E / weight: the second term, 5 % of the first at the largest radius, bends the line a little.
    CHECK(std::abs(byRadius.slope + 1.0) <= kSingle * byRadius.standardError + 0.03);
    CHECK(byPhotons.standardError < 0.03);
    CHECK(byRadius.standardError < 0.03);
}

TEST_CASE("photon map: with a radius that shrinks the bias vanishes") {
    const Scene scene = patchOverFloor();
    const SegmentIndex index(scene);
    const Reference reference(index, 1);
    const ShadedPoint at = shadedPointOn(index, 0, 0.5);
    const double exact = (reference.irradiance(at, 1) - reference.irradiance(at, 0)).x;
    constexpr double kRadius = 0.8, kAlpha = 0.6;
    constexpr int kPasses = 120;
    double factor = 1.0, sum = 0.0, afterTen = 0.0;
    for (int pass = 0; pass < kPasses; ++pass) {
        sum += kernelMean(index, reference, 0, 0.5, kRadius * factor, 1).x;
        if (pass == 9) afterTen = sum / 10.0;
        factor *= (pass + 1.0 + kAlpha) / (pass + 2.0);
    }
    const double mean = sum / kPasses, fixed = kernelMean(index, reference, 0, 0.5, kRadius, 1).x;
    CHECK(exact - afterTen < 0.5 * (exact - fixed));
    CHECK(exact - mean < 0.3 * (exact - afterTen));
    const auto passesWith = [&](double alpha) {
        return indirectPasses(
            index, at,
            {{{"photons", 5000}, {"radius", kRadius}, {"gather", 0}, {"shrink", alpha}}, 1, kPasses});
    };
    const Statistics shrinking = passesWith(kAlpha), constant = passesWith(1.0);
    INFO(zTest(shrinking, mean).text());
    CHECK(zTest(shrinking, mean).within(kSingle));
    CHECK(zTest(constant, fixed).within(kSingle));
    CHECK_FALSE(zTest(constant, mean).within(kSingle));
}
