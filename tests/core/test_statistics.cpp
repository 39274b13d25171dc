// Are mean and variance right where sums lose digits, and are bad samples counted?
#include <doctest/doctest.h>

#include "core/statistics.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

struct TwoPass {
    long double mean = 0.0L, variance = 0.0L;
};

TwoPass twoPass(const std::vector<double>& xs) {
    TwoPass result;
    for (const double x : xs) result.mean += x;
    result.mean /= static_cast<long double>(xs.size());
    for (const double x : xs) result.variance += (x - result.mean) * (x - result.mean);
    result.variance /= static_cast<long double>(xs.size() - 1);
    return result;
}

std::vector<double> numbers(double offset, std::uint64_t seed, int count) {
    Random random(seed);
    std::vector<double> xs;
    for (int i = 0; i < count; ++i) xs.push_back(offset + random.in(-1.0, 1.0));
    return xs;
}

Statistics of(const std::vector<double>& xs) {
    Statistics s;
    for (const double x : xs) s.add({x, 2.0 * x, 0.0});
    return s;
}

}  // namespace

TEST_CASE("statistics: agrees with two passes in long double, at large offsets too") {
    for (const double offset : {0.0, 1.0, 1e6, 1e9, -1e12}) {
        CAPTURE(offset);
        const auto xs = numbers(offset, 1, 20'000);
        const Statistics s = of(xs);
        const TwoPass exact = twoPass(xs);
        const auto mean = static_cast<double>(exact.mean), variance = static_cast<double>(exact.variance);
        CHECK(std::abs(s.mean.x - mean) <= 1e-15 * (1.0 + std::abs(offset)) * 10.0);
        // Welford loses about offset * epsilon of the deviations, not offset^2.
        CHECK(s.variance().x == doctest::Approx(variance).epsilon(1e-12 + 1e-15 * std::abs(offset)));
        CHECK(s.variance().y == doctest::Approx(4.0 * variance).epsilon(1e-12 + 1e-15 * std::abs(offset)));
        CHECK(s.variance().z == 0.0);
        CHECK(s.standardError().x == doctest::Approx(std::sqrt(s.variance().x / 20'000)));
    }
}

TEST_CASE("statistics: the sum of squares alone would have failed at 1e9") {
    const auto xs = numbers(1e9, 1, 20'000);
    double sum = 0.0, squares = 0.0;
    for (const double x : xs) {
        sum += x;
        squares += x * x;
    }
    const double naive = (squares - sum * sum / 20'000) / 19'999;
    CHECK(std::abs(naive - static_cast<double>(twoPass(xs).variance)) > 1.0);
}

TEST_CASE("statistics: merging parts is adding them one after the other, up to rounding") {
    const auto xs = numbers(3.0, 2, 10'000);
    const Statistics whole = of(xs);
    for (const std::size_t cut :
         {std::size_t{0}, std::size_t{1}, std::size_t{5000}, std::size_t{9999}, xs.size()}) {
        Statistics parts = of({xs.begin(), xs.begin() + static_cast<std::ptrdiff_t>(cut)});
        parts.merge(of({xs.begin() + static_cast<std::ptrdiff_t>(cut), xs.end()}));
        CHECK(parts.count == whole.count);
        CHECK(parts.mean.x == doctest::Approx(whole.mean.x).epsilon(1e-13));
        CHECK(parts.variance().x == doctest::Approx(whole.variance().x).epsilon(1e-12));
    }
    Statistics many;
    for (std::size_t i = 0; i < xs.size(); i += 7)
        many.merge(of({xs.begin() + static_cast<std::ptrdiff_t>(i),
                       xs.begin() + static_cast<std::ptrdiff_t>(std::min(i + 7, xs.size()))}));
    CHECK(many.count == whole.count);
    CHECK(many.variance().x == doctest::Approx(whole.variance().x).epsilon(1e-12));
}

TEST_CASE("statistics: samples that are not finite are counted and left out") {
    Statistics s;
    s.add(Rgb(1.0));
    s.add({1.0, std::nan(""), 1.0});
    s.add({INFINITY, 1.0, 1.0});
    s.add({1.0, 1.0, -INFINITY});
    s.add(Rgb(3.0));
    CHECK(s.nonFinite == 3);
    CHECK(s.count == 2);
    CHECK(s.mean == Rgb(2.0));
    CHECK(s.variance() == Rgb(2.0));
    Statistics bad;
    bad.add(Rgb(std::nan("")));
    s.merge(bad);
    CHECK(s.nonFinite == 4);
    CHECK(s.mean == Rgb(2.0));
    bad.merge(s);
    CHECK(bad.nonFinite == 5);
    CHECK(bad.mean == Rgb(2.0));
}

TEST_CASE("statistics: negative samples are counted and kept") {
    Statistics s, later;
    s.add({1.0, 1.0, -1.0});
    s.add(Rgb(-0.0));
    later.add(Rgb(-2.0));
    s.merge(later);
    CHECK(s.negative == 2);
    CHECK(s.count == 3);
    CHECK(s.mean.z == doctest::Approx(-1.0));
}

TEST_CASE("statistics: nothing and one sample have no variance") {
    Statistics s;
    CHECK(s.variance() == Rgb(0.0));
    CHECK(s.standardError() == Rgb(0.0));
    s.add(Rgb(5.0));
    CHECK(s.mean == Rgb(5.0));
    CHECK(s.variance() == Rgb(0.0));
}
