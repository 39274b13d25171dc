// Does the frame of a half-disk stand upright for every normal?
#include <doctest/doctest.h>

#include "core/math.h"
#include "core/scene.h"

using namespace halfdisk;

TEST_CASE("frame: right and up are orthonormal and up is the normal, for 10 000 normals") {
    for (int k = 0; k < 10'000; ++k) {
        const double angle = 2.0 * kPi * k / 10'000.0;
        const Vec2 N = {std::cos(angle), std::sin(angle)};
        const Frame frame = frameFromNormal(N);
        const Vec2 right = frame.toWorld(1.0, 0.0), up = frame.toWorld(0.0, 1.0);
        REQUIRE(up == N);
        REQUIRE(right == Vec2(N.y, -N.x));
        REQUIRE(std::abs(glm::dot(right, up)) <= 1e-16);
        REQUIRE(std::abs(glm::length(right) - 1.0) <= 3e-16);
        // Right-handed: turning right by +90 degrees gives up, so the determinant is +1.
        REQUIRE(std::abs(cross(right, up) - 1.0) <= 5e-16);
        // A direction keeps its length and its cosine with the normal.
        const Vec2 direction = frame.toWorld(std::cos(0.3), std::sin(0.3));
        REQUIRE(std::abs(glm::dot(direction, N) - std::sin(0.3)) <= 3e-16);
        REQUIRE(std::abs(glm::length(direction) - 1.0) <= 5e-16);
    }
}

TEST_CASE("frame: the axes give exactly what the lesson's step 2 says") {
    CHECK(frameFromNormal({0.0, 1.0}).toWorld(1.0, 0.0) == Vec2(1.0, 0.0));
    CHECK(frameFromNormal({1.0, 0.0}).toWorld(1.0, 0.0) == Vec2(0.0, -1.0));
    CHECK(frameFromNormal({0.0, -1.0}).toWorld(1.0, 0.0) == Vec2(-1.0, 0.0));
    CHECK(frameFromNormal({-1.0, 0.0}).toWorld(1.0, 0.0) == Vec2(0.0, 1.0));
}

TEST_CASE("cross and perp: left is positive") {
    CHECK(cross({1.0, 0.0}, {0.0, 1.0}) == 1.0);
    CHECK(cross({0.0, 1.0}, {1.0, 0.0}) == -1.0);
    CHECK(perp({1.0, 0.0}) == Vec2(0.0, 1.0));
    CHECK(frontNormal({{0.0, 0.0}, {2.0, 0.0}}) == Vec2(0.0, 1.0));
    CHECK(frontNormal({{2.0, 0.0}, {0.0, 0.0}}) == Vec2(0.0, -1.0));
}

TEST_CASE("isFinite: any bad component counts") {
    const double nan = std::nan(""), inf = INFINITY;
    CHECK(isFinite(Vec2(1.0, -1.0)));
    CHECK_FALSE(isFinite(Vec2(nan, 0.0)));
    CHECK_FALSE(isFinite(Vec2(0.0, inf)));
    CHECK(isFinite(Rgb(0.0)));
    for (int channel = 0; channel < 3; ++channel) {
        Rgb bad(1.0);
        bad[channel] = channel == 1 ? nan : -inf;
        CHECK_FALSE(isFinite(bad));
    }
}
