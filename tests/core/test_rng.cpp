// Are the random numbers uniform, different at every address, and the same at the same address?
#include <doctest/doctest.h>

#include <algorithm>

#include "core/rng.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// Tail probability of the hypothesis that the numbers drawn by `draw(i)` are uniform in (0, 1).
template <class Draw>
double uniformity(int count, const Draw& draw) {
    std::vector<std::uint64_t> cells(100);
    for (int i = 0; i < count; ++i)
        ++cells[static_cast<std::size_t>(draw(static_cast<std::uint32_t>(i)) * 100.0)];
    return chiSquareTest(cells, std::vector<double>(100, count / 100.0));
}

/// Correlation coefficient of pairs of uniform numbers, in its standard errors 1 / sqrt(count).
template <class Draw>
double correlation(int count, const Draw& pair) {
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const auto [x, y] = pair(static_cast<std::uint32_t>(i));
        sum += (x - 0.5) * (y - 0.5);
    }
    return 12.0 * sum / std::sqrt(static_cast<double>(count));
}

constexpr int kDraws = 200'000;
constexpr double kRare = 1e-4;  // false alarm of each chi-square test

}  // namespace

TEST_CASE("rng: the same address gives the same number, whatever was drawn before") {
    const Rng rng(7, 3);
    const double first = rng.uniform(5, 2);
    for (std::uint32_t i = 0; i < 100; ++i) (void)rng.uniform(i, i);
    CHECK(rng.uniform(5, 2) == first);
    CHECK(Rng(7, 3).uniform(5, 2) == first);
    CHECK(rng.child(4).child(2).uniform(0, 0) == Rng(7, 3).child(4).child(2).uniform(0, 0));
}

TEST_CASE("rng: four samples at once are the same four, to the bit") {
    constexpr std::uint32_t kLast = 0xFFFFFFFFu;
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{0x123456789ABCDEF0}, UINT64_MAX})
        for (std::uint64_t repeat = 0; repeat < 50; ++repeat)
            for (const std::uint32_t d : {0u, 1u, 2u, 7u, kLast - 1, kLast}) {
                const Rng rng(seed, repeat);
                for (const std::uint32_t first : {0u, 4u, 1000u, 0x7FFFFFFCu, kLast - 3}) {
                    const std::array<double, 4> four = rng.uniforms(first, d);
                    for (std::uint32_t i = 0; i < 4; ++i) CHECK(four[i] == rng.uniform(first + i, d));
                }
                UniformRow row(rng, d);
                for (const std::uint32_t n : {5u, 0u, 1u, 2u, 3u, 4u, kLast, 0u})
                    CHECK(row(n) == rng.uniform(n, d));
            }
}

TEST_CASE("rng: never an end of (0, 1), at extreme addresses too") {
    constexpr std::uint32_t kLast = 0xFFFFFFFFu;
    for (const std::uint64_t seed : {std::uint64_t{0}, UINT64_MAX})
        for (const std::uint64_t repeat : {std::uint64_t{0}, UINT64_MAX})
            for (const std::uint32_t n : {0u, 1u, kLast})
                for (const std::uint32_t d : {0u, 1u, kLast}) {
                    const double u = Rng(seed, repeat).child(n).uniform(n, d);
                    CHECK((u > 0.0 && u < 1.0));
                }
    const Rng rng(1, 1);
    for (std::uint32_t n = 0; n < 1'000'000; ++n) {
        const double u = rng.uniform(n, 0);
        REQUIRE((u > 0.0 && u < 1.0));
    }
}

TEST_CASE("rng: no two of 190 000 neighbouring addresses give the same number") {
    std::vector<double> all;
    for (std::uint64_t seed = 0; seed < 5; ++seed)
        for (std::uint64_t repeat = 0; repeat < 5; ++repeat)
            for (std::uint32_t n = 0; n < 20; ++n)
                for (std::uint32_t d = 0; d < 20; ++d) {
                    const Rng rng(seed, repeat);
                    all.push_back(rng.uniform(n, d));
                    for (std::uint32_t k = 0; k < 15; ++k) all.push_back(rng.child(k).uniform(n, d));
                    for (std::uint32_t k = 0; k < 3; ++k)
                        all.push_back(rng.child(k).child(k + 1).uniform(n, d));
                }
    std::sort(all.begin(), all.end());
    // By chance two of m = 190 000 numbers of 52 bits are equal with probability m^2 / 2^53 = 4e-6.
    CHECK(all.size() == 190'000);
    CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE("rng: the order of children matters, and a child is not its parent") {
    const Rng root(1, 0);
    CHECK(root.child(1).child(2).uniform(0, 0) != root.child(2).child(1).uniform(0, 0));
    CHECK(root.child(0).uniform(0, 0) != root.uniform(0, 0));
    CHECK(root.child(0).child(0).uniform(0, 0) != root.child(0).uniform(0, 0));
    CHECK(Rng(1, 0).uniform(0, 0) != Rng(0, 1).uniform(0, 0));
}

TEST_CASE("rng: uniform along each part of the address") {
    const Rng rng(11, 0);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return rng.uniform(i, 0); }) > kRare);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return rng.uniform(i, 1); }) > kRare);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return rng.uniform(0, i); }) > kRare);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return rng.child(i).uniform(0, 0); }) > kRare);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return rng.child(i % 16).child(i / 16).uniform(3, 0); }) >
          kRare);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return Rng(11, i).uniform(0, 0); }) > kRare);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return Rng(i, 0).uniform(0, 0); }) > kRare);
}

TEST_CASE("rng: the low bits are uniform as well") {
    const Rng rng(5, 0);
    CHECK(uniformity(kDraws, [&](std::uint32_t i) { return std::fmod(rng.uniform(i, 0) * 0x1p40, 1.0); }) >
          kRare);
}

TEST_CASE("rng: neighbouring addresses are not correlated") {
    using Pair = std::pair<double, double>;
    const Rng rng(2, 9);
    const auto close = [](double z) { return std::abs(z) < kSingle; };
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{rng.uniform(i, 0), rng.uniform(i, 1)};
    })));
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{rng.uniform(i, 0), rng.uniform(i + 1, 0)};
    })));
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{rng.uniform(i, 1), rng.uniform(i, 2)};
    })));
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{rng.child(i).uniform(0, 0), rng.child(i + 1).uniform(0, 0)};
    })));
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{rng.uniform(i, 0), rng.child(i).uniform(0, 0)};
    })));
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{Rng(2, i).uniform(0, 0), Rng(2, i + 1).uniform(0, 0)};
    })));
    CHECK(close(correlation(kDraws, [&](std::uint32_t i) {
        return Pair{Rng(i, 0).uniform(0, 0), Rng(i + 1, 0).uniform(0, 0)};
    })));
}

TEST_CASE("rng: the tests above can fail") {
    Random random(1);
    CHECK(uniformity(kDraws, [&](std::uint32_t) { return std::pow(random.in(0.0, 1.0), 1.03); }) < kRare);
    const double z = correlation(kDraws, [&](std::uint32_t) {
        const double x = random.in(0.0, 1.0);
        return std::pair{x, 0.98 * random.in(0.0, 1.0) + 0.02 * x};
    });
    CHECK(std::abs(z) > kSingle);
}
