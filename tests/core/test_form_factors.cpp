// Are form factors right, also where something stands between? Against closed forms, and against light that
// is summed up point by point.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "cases.h"
#include "core/form_factors.h"
#include "core/quadrature.h"
#include "rooms.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

Strand strandOf(const Segment& wall) {
    return {wall.a, wall.b};
}

std::vector<Strand> othersThan(const Scene& scene, std::size_t i, std::size_t k) {
    std::vector<Strand> walls;
    for (std::size_t n = 0; n < scene.segments.size(); ++n)
        if (n != i && n != k) walls.push_back(strandOf(scene.segments[n]));
    return walls;
}

/// Exchange length by integrating along `from` what each of its points sees of the front of `to`.
double summedExchange(const Visibility& visibility, std::uint32_t from, std::uint32_t to) {
    const SegmentIndex& index = visibility.index();
    const auto seen = [&](double u) {
        const ShadedPoint at{index.pointOn(from, u), index.normal(from), from};
        double sum = 0.0;
        for (const VisibleArc& arc : visibility.arcs(at))
            if (arc.hit.segment == to && arc.hit.front) sum += (std::cos(arc.from) - std::cos(arc.to)) / 2.0;
        return Integrals<1>{sum};
    };
    // What is seen jumps where a wall stands on this one. Elsewhere views open and close within a stretch: so
    // many panels that none is overlooked.
    const Segment& wall = index.scene().segments[from];
    std::vector<double> ends{0.0, 1.0};
    for (const Vec2& corner : visibility.corners())
        if (cross(wall.b - wall.a, corner - wall.a) == 0.0)
            ends.push_back(glm::length(corner - wall.a) / index.length(from));
    std::sort(ends.begin(), ends.end());
    constexpr int kPanels = 100, kHalvings = 14;
    constexpr double kTolerance = 1e-11;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (int k = 0; k < kPanels && ends[i] < ends[i + 1]; ++k) {
            const double width = (ends[i + 1] - ends[i]) / kPanels, start = ends[i] + width * k;
            sum += integrate<1>(seen, start, start + width, {kTolerance}, kHalvings)[0];
        }
    return index.length(from) * sum;
}

/// Largest difference from 1 of the rows of F that are not hidden.
double worstClosure(const Scene& scene, std::uint32_t wanted) {
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    const Patches patches(visibility, wanted);
    const auto lengths = exchangeLengths(index, patches);
    double worst = 0.0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        if (patches.all()[i].hidden) continue;
        double sum = 0.0;
        for (std::size_t k = 0; k < patches.size(); ++k) sum += lengths[i * patches.size() + k];
        worst = std::max(worst, std::abs(sum / patches.all()[i].length - 1.0));
    }
    return worst;
}

}  // namespace

TEST_CASE("form factors: parallel plates, plates at a corner") {
    for (const double width : {0.01, 0.5, 1.0, 30.0}) {
        const Strand floor{{0.0, 0.0}, {width, 0.0}}, ceiling{{width, 1.0}, {0.0, 1.0}};
        const double F = std::sqrt(1.0 + 1.0 / (width * width)) - 1.0 / width;
        CHECK(unoccludedExchange(floor, ceiling) / width == doctest::Approx(F).epsilon(1e-12));

        const Strand wall{{width, 0.0}, {width, 1.0}};
        const double corner = (1.0 + 1.0 / width - std::sqrt(1.0 + 1.0 / (width * width))) / 2.0;
        CHECK(unoccludedExchange(floor, wall) / width == doctest::Approx(corner).epsilon(1e-12));
    }
    for (const double angle : {0.01, 0.5, 1.5, 3.0}) {
        const Strand one{{0.0, 0.0}, {1.0, 0.0}}, two{{std::cos(angle), std::sin(angle)}, {0.0, 0.0}};
        CHECK(unoccludedExchange(one, two) == doctest::Approx(1.0 - std::sin(angle / 2.0)).epsilon(1e-12));
    }
}

TEST_CASE("form factors: what lies behind the other does not count") {
    const Strand floor{{0.0, 0.0}, {1.0, 0.0}};
    CHECK(unoccludedExchange(floor, {{0.0, 1.0}, {1.0, 1.0}}) == 0.0);    // shows its back
    CHECK(unoccludedExchange(floor, {{1.0, -1.0}, {0.0, -1.0}}) == 0.0);  // below
    CHECK(unoccludedExchange(floor, {{3.0, 0.0}, {2.0, 0.0}}) == 0.0);    // in line
    // A wall that begins below the floor's line counts from there on.
    CHECK(unoccludedExchange(floor, {{2.0, -1.0}, {2.0, 1.0}}) ==
          doctest::Approx(unoccludedExchange(floor, {{2.0, 0.0}, {2.0, 1.0}})).epsilon(1e-14));
}

TEST_CASE("form factors: a screen with a slit, and one without") {
    const Strand floor{{-1.0, 0.0}, {1.0, 0.0}}, ceiling{{1.0, 2.0}, {-1.0, 2.0}};
    const double s = 0.25;
    const std::vector<Strand> slit{{{-9.0, 1.0}, {-s, 1.0}}, {{s, 1.0}, {9.0, 1.0}}};
    // Crossed strings run straight through the slit, uncrossed ones round its edges.
    const double exact = 2.0 * (std::sqrt(2.0) - std::hypot(1.0 - s, 1.0));
    CHECK(exchangeLength(floor, ceiling, slit, 1e-14) == doctest::Approx(exact).epsilon(1e-13));
    const std::vector<Strand> shut{{{-9.0, 1.0}, {0.1, 1.0}}, {{0.1, 1.0}, {9.0, 1.0}}};
    CHECK(exchangeLength(floor, ceiling, shut, 1e-14) < 1e-15);
}

TEST_CASE("form factors: with what stands between, as summed point by point, from both sides") {
    Random random(20);
    int hidden = 0;
    for (int trial = 0; trial < 60; ++trial) {
        Scene scene;
        addWall(scene, {-1.0, 0.0}, {1.0, 0.0});
        addWall(scene, {random.in(0.5, 1.5), random.in(1.5, 2.5)},
                {random.in(-1.5, -0.5), random.in(1.5, 2.5)});
        const auto between = random.integer(1, 6);
        for (int k = 0; k < between; ++k) {
            // Chains, crossings, and now and then one that stands on the floor.
            const bool chained = k > 0 && random.in(0.0, 1.0) < 0.5;
            const bool stands = random.in(0.0, 1.0) < 0.2;
            const Vec2 a = chained  ? scene.segments.back().b
                           : stands ? Vec2(random.in(-0.8, 0.8), 0.0)
                                    : Vec2(random.in(-1.5, 1.5), random.in(0.2, 1.4));
            addWall(scene, a, {random.in(-1.5, 1.5), random.in(0.2, 1.4)});
        }
        const SegmentIndex index(scene);
        const Visibility visibility(index);
        const std::vector<Strand> walls = othersThan(scene, 0, 1);
        const Strand one = strandOf(scene.segments[0]), two = strandOf(scene.segments[1]);
        const double there = exchangeLength(one, two, walls, roundingOf(index));
        const double back = exchangeLength(two, one, walls, roundingOf(index));
        INFO(fmt::format("trial {}: {} and {}, open {}", trial, there, back, unoccludedExchange(one, two)));
        CHECK(std::abs(there - back) < 1e-13);
        CHECK(std::abs(there - summedExchange(visibility, 0, 1)) < 1e-7);
        hidden += there < 0.9 * unoccludedExchange(one, two);
    }
    CHECK(hidden > 30);
}

TEST_CASE("form factors: every patch of a closed room sees walls all around") {
    CHECK(worstClosure(polygonRoom(furnacePolygon()), 150) < 1e-11);
    CHECK(worstClosure(polygonRoom(starPolygon(5, 0.4, 1.0)), 150) < 1e-11);
    CHECK(worstClosure(polygonRoom(regularPolygon(90)), 1) < 1e-11);
    CHECK(worstClosure(readCase("09_cornell_rgb").scene, 300) < 1e-11);
}

TEST_CASE("form factors: also with a screen of two sides, a round pillar and a wall on a wall") {
    Scene scene = polygonRoom(furnacePolygon());
    scene.materials.push_back(Diffuse{});
    scene.segments.push_back({{0.7, 0.3}, {1.4, 1.3}, 1, Rgb(0.0), true});
    CHECK(worstClosure(scene, 150) < 1e-11);

    const std::vector<Vec2> pillar = regularPolygon(40, 0.3, {0.6, 1.2});
    for (std::size_t k = 0; k < pillar.size(); ++k)
        scene.segments.push_back({pillar[(k + 1) % pillar.size()], pillar[k], 1});
    CHECK(worstClosure(scene, 150) < 1e-11);

    // The same wall again, shorter: of the two, the one of the lower number is met.
    scene.segments.push_back({scene.segments[5].a * 0.75 + scene.segments[5].b * 0.25,
                              scene.segments[5].a * 0.25 + scene.segments[5].b * 0.75, 1});
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    const Patches patches(visibility, 150);
    for (const Patch& patch : patches.all())
        CHECK(patch.hidden == (patch.segment + 1 == scene.segments.size()));
    CHECK(worstClosure(scene, 150) < 1e-11);
}

TEST_CASE("patches: as many as asked, and found again by their place") {
    const Scene scene = readCase("22_environment_box").scene;
    const SegmentIndex index(scene);
    const Visibility visibility(index);
    for (const std::uint32_t wanted : {1u, 10u, 399u, 4000u}) {
        const Patches patches(visibility, wanted);
        CHECK(patches.size() <= std::max(wanted, 7u));  // the ground is cut at the box
        CHECK(patches.size() + 8 > wanted);
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const Patch& patch = patches.all()[i];
            CHECK(patches.at(patch.segment, patch.front, (patch.uFrom + patch.uTo) / 2.0) == i);
        }
    }
}
