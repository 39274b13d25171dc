// Are the exact answers exact? Closed forms against plain quadrature and against the tabulated cases.
#include <doctest/doctest.h>

#include "cases.h"
#include "core/exact.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

/// Le cos cos' / r summed over the segment, in panels of two Gauss points.
double bySum(Vec2 P, Vec2 N, const Segment& s, int panels) {
    const Vec2 edge = s.b - s.a, n = frontNormal(s);
    double sum = 0.0;
    for (int i = 0; i < panels; ++i)
        for (const double side : {-1.0, 1.0}) {
            const Vec2 way = s.a + (i + 0.5 + side * 0.5 / std::sqrt(3.0)) / panels * edge - P;
            const double r = glm::length(way), cosine = glm::dot(N, way) / r;
            const double facing = s.twoSided ? std::abs(glm::dot(n, way)) / r : -glm::dot(n, way) / r;
            sum += std::max(0.0, cosine) * std::max(0.0, facing) / r;
        }
    return sum * glm::length(edge) / (2.0 * panels) * s.emission.x;
}

/// E of the radiance that rays find, by the midpoint rule over the half-disk.
Rgb byRays(const SegmentIndex& index, const ShadedPoint& at, int rays) {
    Rgb sum(0.0);
    const Frame frame = frameFromNormal(at.N);
    for (int i = 0; i < rays; ++i) {
        const double theta = kPi * (i + 0.5) / rays;
        const Vec2 direction = frame.toWorld(std::cos(theta), std::sin(theta));
        const Hit hit = index.closestHit(rayFrom(index, at, direction));
        const Rgb L = !hit                    ? index.environment(direction)
                      : isLitSide(index, hit) ? index.scene().segments[hit.segment].emission
                                              : Rgb(0.0);
        sum += L * std::sin(theta) * kPi / static_cast<double>(rays);
    }
    return sum;
}

}  // namespace

TEST_CASE("exact: a segment's irradiance is the sum over its length") {
    Random random(1);
    int lit = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec2 P = random.pointIn(-1.0, 1.0), N = random.direction();
        const Segment s = {random.pointIn(-2.0, 2.0), random.pointIn(-2.0, 2.0), 0, Rgb(random.in(0.1, 5.0)),
                           i % 3 == 0};
        if (std::abs(glm::dot(frontNormal(s), P - s.a)) < 0.05) continue;
        const double exact = segmentIrradiance(P, N, s).x;
        lit += exact > 0.0;
        // The clipped cosine has a kink at the horizon: the sum converges with the square of the panel there.
        REQUIRE(exact == doctest::Approx(bySum(P, N, s, 4000)).epsilon(5e-6));
    }
    CHECK(lit > 1000);
}

TEST_CASE("exact: infinite walls give 2, quarter walls half of it") {
    const Vec2 P = {0.0, 0.0}, up = {0.0, 1.0};
    CHECK(segmentIrradiance(P, up, {{1e9, 1.0}, {-1e9, 1.0}, 0, Rgb(1.0)}).x ==
          doctest::Approx(2.0).epsilon(1e-15));
    CHECK(segmentIrradiance(P, up, {{1e9, 1.0}, {0.0, 1.0}, 0, Rgb(1.0)}).x ==
          doctest::Approx(1.0).epsilon(1e-9));
    CHECK(segmentIrradiance(P, up, {{-1e9, 1.0}, {1e9, 1.0}, 0, Rgb(1.0)}).x == 0.0);    // its back
    CHECK(segmentIrradiance(P, up, {{-1.0, -1.0}, {1.0, -1.0}, 0, Rgb(1.0)}).x == 0.0);  // below the horizon
    CHECK(segmentIrradiance(P, up, {{1.0, -9e9}, {1.0, 9e9}, 0, Rgb(1.0)}).x ==
          doctest::Approx(1.0));  // cut by it
}

TEST_CASE("exact: closed rooms") {
    CHECK(closedRoomRadiance(0.3, 0.7, 0) == doctest::Approx(0.3));
    CHECK(closedRoomRadiance(0.3, 0.7, 2) == doctest::Approx(0.3 * (1.0 + 0.7 + 0.49)));
    CHECK(closedRoomRadiance(0.3, 0.7, kAnyDepth) == doctest::Approx(1.0));
    CHECK(closedRoomRadiance(0.3, 1.0, 4) == doctest::Approx(1.5));
    CHECK(closedRoomRadiance(0.3, 0.0, 9) == doctest::Approx(0.3));
    for (const Answer& answer : readCase("05_white_furnace").answers)
        for (std::size_t depth = 0; depth < answer.depth.size(); ++depth)
            CHECK(closedRoomRadiance(0.3, 0.7, static_cast<int>(depth)) ==
                  doctest::Approx(answer.depth[depth].x).epsilon(1e-14));
}

TEST_CASE("exact: direct light equals the tabulated cases") {
    for (const char* name : {"01_segment_light", "03_occluded_light", "07_circle_10000_arc", "09_cornell_rgb",
                             "14_square_albedo_0.99", "16_vgroove_60", "20b_grazing", "22_environment_box",
                             "33_overhead", "33_clipped", "33_tiny_far"}) {
        const Case known = readCase(name);
        if (known.scene.segments.size() > 200) continue;
        const SegmentIndex index(known.scene);
        const Visibility visibility(index);
        for (const Answer& answer : known.answers) {
            CAPTURE(name);
            const std::size_t depth = answer.query == "radiance" ? 1 : 0;
            const Rgb exact = *answer.valueAt(depth);
            const Rgb value = quantityOf(index, answer, directIrradiance(visibility, pointOf(index, answer)));
            for (int c = 0; c < 3; ++c) {
                // The tables of product integration are good to 1e-7 or so, the closed forms to 1e-12.
                const double tolerance =
                    std::string(name) == "20b_grazing" ? 1e-9 * exact[c] : std::max(1e-12, answer.err);
                CHECK(std::abs(value[c] - exact[c]) <= tolerance);
            }
        }
    }
}

TEST_CASE("exact: a segment seen almost edge-on keeps its digits") {
    const Case known = readCase("20b_grazing");
    const double exact = known.answers.front().depth.front().x;
    CHECK(segmentIrradiance({0.0, 0.0}, {0.0, 1.0}, known.scene.segments.front()).x ==
          doctest::Approx(exact).epsilon(1e-11));
}

TEST_CASE("exact: direct light in random scenes equals 200 000 rays") {
    Random random(2);
    for (int i = 0; i < 40; ++i) {
        Scene scene;
        scene.environment = Rgb(0.3, 0.2, 0.1);
        for (int k = 0; k < 8; ++k) {  // walls cross each other
            const Vec2 a = random.pointIn(-1.0, 1.0);
            const Rgb emission = k % 2 == 0 ? Rgb(1.0, 0.5, 0.0) : Rgb(0.0, 0.1 * k, 1.0);
            addWall(scene, a, random.pointIn(-1.0, 1.0), Rgb(0.5), emission, k % 3 == 0);
        }
        const SegmentIndex index(scene);
        const Visibility visibility(index);
        for (const ShadedPoint& at :
             {ShadedPoint{random.pointIn(-1.0, 1.0), random.direction()}, shadedPointOn(index, 3, 0.4)}) {
            const Rgb exact = directIrradiance(visibility, at), sum = byRays(index, at, 200'000);
            for (int c = 0; c < 3; ++c)
                REQUIRE(std::abs(exact[c] - sum[c]) < 2e-4);  // about 10 edges of pi / 200 000 each
        }
    }
}

TEST_CASE("exact: the arcs cover the half-disk without gaps") {
    const Scene scene = mixedRoom();
    const SegmentIndex index(scene);
    const auto arcs = Visibility(index).arcs(shadedPointOn(index, 0, 0.4));
    REQUIRE(arcs.size() >= 4);
    CHECK(arcs.front().from == 0.0);
    CHECK(arcs.back().to == doctest::Approx(kPi).epsilon(1e-15));
    for (std::size_t i = 1; i < arcs.size(); ++i) CHECK(arcs[i].from == arcs[i - 1].to);
    for (const VisibleArc& arc : arcs) CHECK(arc.from < arc.to);
}

TEST_CASE("exact: mean and variance of one half-disk sample equal case 33") {
    for (const char* name : {"33_overhead", "33_oblique", "33_clipped", "33_tiny_far", "33_close_big"}) {
        CAPTURE(name);
        const Case known = readCase(name);
        const SegmentIndex index(known.scene);
        const Visibility visibility(index);
        const Answer& answer = known.answers.front();
        for (const Sampler sampler : {Sampler::uniform, Sampler::cosine}) {
            const ExactEstimate exact = halfDiskEstimate(visibility, pointOf(index, answer), sampler, 0);
            const double variance = answer.numbers.at(std::string(nameOf(kSamplers, sampler)));
            CHECK(exact.mean.x == doctest::Approx(answer.depth.front().x).epsilon(1e-9));
            CHECK(exact.variance.x == doctest::Approx(variance).epsilon(1e-8));
        }
    }
}
