// Does every sampler draw what its pdf says?
#include <doctest/doctest.h>

#include <functional>

#include "core/half_circle.h"
#include "core/sampling.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr int kCells = 90;
constexpr int kDraws = 500'000;
constexpr double kRare = 1e-4;
constexpr double kNearly0 = 0.5 * 0x1p-52, kNearly1 = 1.0 - 0.5 * 0x1p-52;  // the ends of what Rng can draw

using Sample = std::function<HalfDiskSample(double u)>;
using Pdf = std::function<double(double theta)>;

double integral(const Pdf& f, double from, double to, int panels = 2000) {
    double sum = 0.0;
    const double h = (to - from) / panels;
    for (int i = 0; i < panels; ++i) {  // Gauss-Legendre with two points
        const double middle = from + (i + 0.5) * h, off = h / (2.0 * std::sqrt(3.0));
        sum += f(middle - off) + f(middle + off);
    }
    return sum * h / 2.0;
}

/// Tail probability that angles drawn by `sample` are distributed by `pdf`.
double fit(const Sample& sample, const Pdf& pdf, std::uint64_t seed) {
    Random random(seed);
    std::vector<std::uint64_t> counts(kCells);
    for (int i = 0; i < kDraws; ++i) {
        const double theta = sample(random.in(0.0, 1.0)).theta;
        ++counts[std::min<std::size_t>(kCells - 1, static_cast<std::size_t>(theta / kPi * kCells))];
    }
    std::vector<double> expected;
    for (int i = 0; i < kCells; ++i)
        expected.push_back(kDraws * integral(pdf, kPi * i / kCells, kPi * (i + 1) / kCells, 20));
    return chiSquareTest(counts, expected);
}

}  // namespace

TEST_CASE("sampling: the pdfs integrate to 1 and vanish off the half-disk") {
    for (const Pdf& pdf : {Pdf(pdfUniformHalfDisk), Pdf(pdfCosineHalfDisk)}) {
        CHECK(integral(pdf, 0.0, kPi) == doctest::Approx(1.0).epsilon(1e-12));
        CHECK(pdf(-0.1) == 0.0);
        CHECK(pdf(kPi + 0.1) == 0.0);
    }
}

TEST_CASE("sampling: angles follow the pdf (chi-square)") {
    CHECK(fit(sampleUniformHalfDisk, pdfUniformHalfDisk, 1) > kRare);
    CHECK(fit(sampleCosineHalfDisk, pdfCosineHalfDisk, 2) > kRare);
    Random slices(4);
    const Sample stratified = [&](double u) {
        return sampleStratifiedHalfDisk(u, static_cast<std::uint32_t>(slices.integer(0, 6)), 7);
    };
    CHECK(fit(stratified, pdfUniformHalfDisk, 3) > kRare);
}

TEST_CASE("sampling: a wrong sampler is rejected") {
    CHECK(fit(sampleUniformHalfDisk, pdfCosineHalfDisk, 1) < kRare);
    CHECK(fit(sampleCosineHalfDisk, pdfUniformHalfDisk, 2) < kRare);
    const Sample slightlyWrong = [](double u) { return HalfDiskSample{std::pow(u, 1.02) * kPi, 1.0 / kPi}; };
    CHECK(fit(slightlyWrong, pdfUniformHalfDisk, 3) < kRare);
}

TEST_CASE("sampling: stratified puts exactly one angle into every slice") {
    Random random(5);
    for (const std::uint32_t N : {1u, 2u, 7u, 64u, 1000u}) {
        std::vector<int> slices(N);
        for (std::uint32_t n = 0; n < N; ++n)
            ++slices[static_cast<std::size_t>(sampleStratifiedHalfDisk(random.in(0.0, 1.0), n, N).theta /
                                              kPi * N)];
        CHECK(slices == std::vector<int>(N, 1));
    }
}

TEST_CASE("sampling: the pdf returned with a sample is the pdf of its angle") {
    Random random(6);
    for (int i = 0; i < 10'000; ++i) {
        const double u = random.in(0.0, 1.0);
        for (const auto& [sampler, name, meaning] : kSamplers) {
            const auto [theta, pdfAngle] = sampleHalfDisk(sampler, u, 3, 8);
            const double pdf = sampler == Sampler::cosine || sampler == Sampler::lobe
                                   ? pdfCosineHalfDisk(theta)
                                   : pdfUniformHalfDisk(theta);
            REQUIRE(pdfAngle == doctest::Approx(pdf).epsilon(1e-14));
            REQUIRE(pdfAngle == doctest::Approx(pdfHalfDisk(sampler, std::sin(theta))).epsilon(1e-14));
        }
    }
}

TEST_CASE("sampling: the mean of f / pdf is the integral of f") {
    // E under constant radiance 1 is the integral of the cosine over the half-disk: 2.
    Random random(7);
    Statistics uniform, cosine;
    for (int i = 0; i < kDraws; ++i) {
        const auto a = sampleUniformHalfDisk(random.in(0.0, 1.0));
        const auto b = sampleCosineHalfDisk(random.in(0.0, 1.0));
        uniform.add(Rgb(std::sin(a.theta) / a.pdfAngle));
        cosine.add(Rgb(std::sin(b.theta) / b.pdfAngle));
    }
    CHECK(zTest(uniform, 2.0).within(kSingle));
    CHECK(zTest(cosine, 2.0).within(kSingle));
    CHECK(cosine.variance().x < 1e-20);  // importance sampling of this integrand is perfect
}

TEST_CASE("sampling: the extreme random numbers stay inside the half-disk") {
    for (const double u : {kNearly0, kNearly1})
        for (const std::uint32_t N : {1u, 1024u, 1'000'000'000u})
            for (const std::uint32_t n : {0u, N - 1})
                for (const auto& sampler : kSamplers) {
                    CAPTURE(sampler.name);
                    CAPTURE(u);
                    CAPTURE(n);
                    const auto [theta, pdfAngle] = sampleHalfDisk(sampler.value, u, n, N);
                    CHECK(std::isfinite(theta));
                    CHECK(theta > 0.0);
                    CHECK(theta <= kPi);  // the double nearest to pi lies below pi
                    CHECK(std::sin(theta) > 0.0);
                    CHECK(pdfAngle > 0.0);
                }
}

TEST_CASE("sampling: names and values of the closed sets agree") {
    for (const auto& [value, name, meaning] : kSamplers) CHECK(valueOf(kSamplers, name) == value);
    for (const auto& [value, name, meaning] : kEmitters) CHECK(nameOf(kEmitters, value) == name);
    for (std::size_t k = 0; k < kDefects.size(); ++k) CHECK(static_cast<std::size_t>(kDefects[k].value) == k);
    CHECK_FALSE(valueOf(kSamplers, "Uniform"));
    DefectSet set;
    set.set(Defect::pdf, true);
    CHECK(set.has(Defect::pdf));
    CHECK_FALSE(set.has(Defect::frame));
    for (const auto& [value, name, meaning] : kDefects) set.set(value, true);
    CHECK(set == DefectSet::all());
    for (const auto& [value, name, meaning] : kDefects) set.set(value, false);
    CHECK(set == DefectSet{});
}

TEST_CASE("sampling: the direction at an angle is right to 4e-16 of its size, next to zero too") {
    const auto worst = [](double theta) {
        const long double cosine = std::cos(static_cast<long double>(theta)),
                          sine = std::sin(static_cast<long double>(theta));
        return std::max(std::abs((static_cast<long double>(halfCircleCos(theta)) - cosine) / cosine),
                        std::abs((static_cast<long double>(halfCircleSin(theta)) - sine) / sine));
    };
    Random random(5);
    for (int i = 0; i < 100'000; ++i) {
        const double theta = random.in(0.0, kPi), small = std::pow(10.0, random.in(-15.0, -0.5));
        CAPTURE(theta);
        CAPTURE(small);
        REQUIRE(worst(theta) < 4e-16L);
        REQUIRE(worst(small) < 4e-16L);
        REQUIRE(worst(kPi - small) < 4e-16L);
        REQUIRE(worst(0.5 * kPi + small) < 4e-16L);
        REQUIRE(worst(0.5 * kPi - small) < 4e-16L);
    }
    CHECK(worst(0.5 * kPi) < 4e-16L);
    CHECK(worst(kPi) < 4e-16L);
    CHECK(halfCircleSin(0.0) == 0.0);
}
