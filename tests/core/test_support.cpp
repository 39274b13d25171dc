// Are the tests' own statistics right? Tail probabilities against tabulated values.
#include <doctest/doctest.h>

#include "sweep.h"

using namespace halfdisk;
using namespace halfdisk::test;

TEST_CASE("chi-square tail: closed forms and table values") {
    // Two degrees: e^(-x/2). One degree: the two-sided normal tail.
    for (const double x : {0.01, 0.5, 2.0, 10.0, 60.0}) {
        CHECK(chiSquareTail(x, 2.0) == doctest::Approx(std::exp(-x / 2.0)).epsilon(1e-12));
        CHECK(chiSquareTail(x, 1.0) == doctest::Approx(normalTail(std::sqrt(x))).epsilon(1e-11));
        CHECK(chiSquareTail(x, 4.0) == doctest::Approx(std::exp(-x / 2.0) * (1.0 + x / 2.0)).epsilon(1e-12));
    }
    // Critical values of the usual tables.
    CHECK(chiSquareTail(18.307, 10.0) == doctest::Approx(0.05).epsilon(1e-4));
    CHECK(chiSquareTail(135.807, 100.0) == doctest::Approx(0.01).epsilon(1e-4));
    CHECK(chiSquareTail(0.0, 7.0) == 1.0);
}

TEST_CASE("normal tail: table values") {
    CHECK(normalTail(1.959964) == doctest::Approx(0.05).epsilon(1e-6));
    CHECK(normalTail(-3.5) == doctest::Approx(4.6526e-4).epsilon(1e-4));
}

TEST_CASE("z-test: accepts the truth and rejects a bias of 1 %") {
    Random random(3);
    Statistics fair, biased;
    for (int i = 0; i < 1'000'000; ++i) {
        const double x = random.in(0.0, 2.0);
        fair.add(Rgb(x));
        biased.add(Rgb(1.01 * x));
    }
    CHECK(zTest(fair, 1.0).within(kSingle));
    CHECK_FALSE(zTest(biased, 1.0).within(kSweep));
}

TEST_CASE("z-test: without variance only rounding is forgiven") {
    CHECK(ZTest{0.0, 0.0, 0.0, 0.0}.within(kSingle));
    CHECK(ZTest{1.0 + 1e-15, 0.0, 1.0, 0.0}.within(kSingle));
    CHECK_FALSE(ZTest{1.0 + 1e-9, 0.0, 1.0, 0.0}.within(kSweep));
    CHECK(ZTest{1.0 + 1e-9, 0.0, 1.0, 2e-9}.within(kSingle));
    CHECK_FALSE(ZTest{std::nan(""), 0.1, 1.0, 0.0}.within(kSweep));
}

TEST_CASE("sweep: by chance so many, and no more") {
    // P(X > 0) = 1 - (1 - p)^n; of Poisson's distribution with mean 1, P(X > 6) = 8.3e-5 and P(X > 5)
    // = 5.9e-4.
    CHECK(mostByChance(0, 0.1) == 0);
    CHECK(mostByChance(1, 0.9e-4) == 0);
    CHECK(mostByChance(1, 1.1e-4) == 1);
    CHECK(mostByChance(1'000'000, 1e-6) == 6);
    CHECK(mostByChance(3, 0.5) == 3);
}

TEST_CASE("sweep: a right program passes, one that is off by five percent is told each time") {
    const auto sweepOf = [](double bias, std::size_t& failed) {
        Random random(4);
        Sweep sweep;
        for (int i = 0; i < 1000; ++i) {
            // Means of uniform numbers: as normal ones, with a standard error of 0.5 %.
            const auto measured = [&](bool again) {
                Statistics draws;
                for (int k = 0; k < (again ? 53'200 : 13'300); ++k)
                    draws.add(Rgb(random.in(0.0, 2.0) + bias));
                return std::vector{zTest(draws, 1.0)};
            };
            for (const ZTest& test : sweep.settle(measured)) failed += test.within(kSingle) ? 0 : 1;
        }
        return sweep;
    };
    std::size_t failed = 0;
    const Sweep right = sweepOf(0.0, failed);
    INFO(right.text());
    CHECK(failed == 0);
    CHECK(right.again() <= right.mostAgain());
    CHECK(right.mostAgain() == 5);  // Poisson with mean 0.465: P(X > 4) = 1.2e-4
    const Sweep wrong = sweepOf(0.05, failed);
    CHECK(failed == 1000);
    CHECK(wrong.again() == 1000);
    CHECK(tellsFivePercent({1.0, 0.005, 1.0, 0.0}));
    CHECK_FALSE(tellsFivePercent({1.0, 0.02, 1.0, 0.0}));
}
