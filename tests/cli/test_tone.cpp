// Are light's numbers turned into a picture's bytes as the formats say?
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "app/pfm_image.h"
#include "app/tone.h"

using namespace halfdisk;

TEST_CASE("PFM: header, rows from the bottom, little-endian floats") {
    const LinearImage image{1, 2, {Rgb(1.0), {0.0, -2.0, 0.5}}};  // the top row is white
    const std::string expected = std::string("PF\n1 2\n-1.0\n") +
                                 std::string("\x00\x00\x00\x00\x00\x00\x00\xC0\x00\x00\x00\x3F", 12) +
                                 std::string("\x00\x00\x80\x3F\x00\x00\x80\x3F\x00\x00\x80\x3F", 12);
    CHECK(encodePfm(image) == expected);
    const LinearImage back = decodePfm(expected);
    CHECK(back.width == 1);
    CHECK(back.height == 2);
    CHECK(back.pixels == image.pixels);
    for (const std::string& broken : {std::string(), std::string("P6\n1 2\n255\n"), expected.substr(0, 20),
                                      expected + "x", std::string("PF\n1 2\n1.0\n")})
        CHECK_THROWS_AS(decodePfm(broken), std::runtime_error);
}

TEST_CASE("sRGB: the ends, the standard's middle grey, and no wrap") {
    CHECK(srgbByte(0.0) == 0);
    CHECK(srgbByte(1.0) == 255);
    CHECK(srgbByte(7.0) == 255);
    CHECK(srgbByte(-1.0) == 0);
    CHECK(srgbByte(std::numeric_limits<double>::quiet_NaN()) == 0);
    CHECK(srgbByte(0.2140411) == 127);  // sRGB 0.5 is linear 0.21404114, and 255 / 2 lies between bytes
    CHECK(srgbByte(0.2140412) == 128);
    CHECK(srgbByte(0.001) == std::lround(255.0 * 0.01292));
}

TEST_CASE("automatic exposure: the brightest hundredth is white") {
    std::vector<Rgb> pixels;
    for (int i = 1; i <= 200; ++i) pixels.push_back({0.0, i, 0.5 * i});
    CHECK(automaticScale(pixels) == 1.0 / 198.0);
    CHECK(automaticScale({Rgb(4.0)}) == 0.25);
    std::vector<Rgb> spark(1000, Rgb(0.0));
    spark[3] = Rgb(2.0);
    CHECK(automaticScale(spark) == 0.5);
    CHECK(automaticScale(std::vector<Rgb>(5, Rgb(0.0))) == 1.0);
    CHECK(automaticScale({Rgb(1e-310)}) == 1.0);
}
