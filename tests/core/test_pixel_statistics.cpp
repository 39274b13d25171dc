// Do pixels taken together have the statistics of each by itself, to the bit, whatever their samples?
#include <doctest/doctest.h>

#include <limits>

#include "core/film.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kHuge = std::numeric_limits<double>::infinity();

/// Values of all sizes; about one in `rarely` is zero, negative, infinite or none at all.
Picture pictureOf(Random& random, std::size_t pixels, std::int64_t rarely) {
    const double odd[] = {0.0, -0.0, -1.5, kHuge, -kHuge, kNan, std::numeric_limits<double>::max(), 5e-324};
    Picture picture(pixels);
    for (Rgb& value : picture)
        for (int c = 0; c < 3; ++c)
            value[c] = random.integer(1, rarely) == 1 ? odd[random.integer(0, 7)]
                                                      : std::pow(10.0, random.in(-8.0, 8.0));
    return picture;
}

void checkSame(const PixelStatistics& together, const std::vector<Statistics>& apart) {
    REQUIRE(together.size() == apart.size());
    std::size_t pixel = 0;
    for (const Statistics& one : together) {
        const Statistics& other = apart[pixel++];
        const bool same =
            one.count == other.count && one.nonFinite == other.nonFinite && one.negative == other.negative;
        REQUIRE(same);
        for (int c = 0; c < 3; ++c) {
            // Sums of the largest numbers overflow: no number equals itself then.
            REQUIRE((one.mean[c] == other.mean[c] || (std::isnan(one.mean[c]) && std::isnan(other.mean[c]))));
            REQUIRE((one.squares[c] == other.squares[c] ||
                     (std::isnan(one.squares[c]) && std::isnan(other.squares[c]))));
        }
    }
}

}  // namespace

TEST_CASE("pixel statistics: added and merged as each pixel by itself, to the bit") {
    Random random(1);
    constexpr std::int64_t kNever = 1'000'000'000, kRarely = 3000, kOften = 4;
    for (const std::size_t pixels :
         {std::size_t{1}, std::size_t{2}, std::size_t{511}, std::size_t{512}, std::size_t{1300}})
        for (const std::int64_t first : {kNever, kRarely, kOften})
            for (const std::int64_t second : {kNever, kRarely, kOften}) {
                PixelStatistics together[2];
                std::vector<Statistics> apart[2];
                for (int part = 0; part < 2; ++part) {
                    apart[part].resize(pixels);
                    for (int sample = 0; sample < 5; ++sample) {
                        const Picture picture = pictureOf(random, pixels, part == 0 ? first : second);
                        together[part].add(picture);
                        for (std::size_t i = 0; i < pixels; ++i) apart[part][i].add(picture[i]);
                    }
                    checkSame(together[part], apart[part]);
                }
                PixelStatistics onto;  // of no size: takes that of the other
                onto.merge(together[0]);
                checkSame(onto, apart[0]);
                onto.merge(together[1]);
                for (std::size_t i = 0; i < pixels; ++i) apart[0][i].merge(apart[1][i]);
                checkSame(onto, apart[0]);
                PixelStatistics none;
                none.reset(pixels);
                onto.merge(none);
                checkSame(onto, apart[0]);
            }
}

TEST_CASE("pixel statistics: counts are kept by pixel only where a sample was odd") {
    PixelStatistics pixels;
    pixels.add({Rgb(1.0), Rgb(2.0)});
    CHECK(pixels.odd.empty());
    pixels.add({Rgb(3.0), Rgb(1.0, kNan, 1.0)});
    CHECK(pixels.odd.size() == 2);
    CHECK(pixels[0].count == 2);
    CHECK(pixels[0].mean == Rgb(2.0));
    CHECK(pixels[1].count == 1);
    CHECK(pixels[1].nonFinite == 1);
    CHECK(pixels[1].mean == Rgb(2.0));
    CHECK(pixels[1].variance() == Rgb(0.0));
}
