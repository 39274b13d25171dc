// Does every flight leave its exact length in the cells that it crosses, whatever its way through the grid?
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/field_cells.h"
#include "core/splat/field_splat.h"
#include "core/splat/kernels.h"
#include "support.h"

using namespace halfdisk;
using namespace halfdisk::test;

namespace {

const StopQuestion kNever;

struct Flight {
    Ray ray;
    double distance = kInfinity;
};

Vec2 cellOf(const Field& field) {
    return (field.max - field.min) / Vec2(field.width, field.height);
}

double areaOf(const Field& field) {
    return cellOf(field).x * cellOf(field).y;
}

std::vector<SplatKernel> kernels() {
    std::vector<SplatKernel> all{drawRunsBaseline};
    if (bestSplatKernel() != drawRunsBaseline) all.push_back(bestSplatKernel());
    return all;
}

/// Metres in every cell: of a power of 1 the picture's value times the area.
std::vector<double> splatted(const Field& field, const std::vector<Flight>& flights, SplatKernel kernel) {
    Picture picture(std::size_t{field.width} * field.height, Rgb(0.0));
    Counts counts;
    FieldSplat splat(field, picture, kNever, kernel);
    for (const Flight& flight : flights) splat.add(flight.ray, flight.distance, {1.0, 0.5, 2.0}, counts);
    splat.finish();
    std::vector<double> metres;
    bool sameInAll = true;  // powers of two: to the bit
    for (const Rgb& value : picture) {
        sameInAll = sameInAll && value.y == value.x * 0.5 && value.z == value.x * 2.0;
        metres.push_back(value.x * areaOf(field));
    }
    REQUIRE(sameInAll);
    REQUIRE(counts.nonFinite == 0);
    REQUIRE(counts.negative == 0);
    return metres;
}

/// Of the part of a flight within a box, by cutting it at the box's sides.
long double lengthWithin(Vec2 min, Vec2 max, const Flight& flight, Vec2 shift = Vec2(0.0)) {
    long double enter = 0.0L, exit = flight.distance;
    for (int axis = 0; axis < 2; ++axis) {
        const long double speed = flight.ray.direction[axis],
                          place = static_cast<long double>(flight.ray.origin[axis]) + shift[axis];
        if (speed == 0.0L) {
            if (place < min[axis] || place >= max[axis]) return 0.0L;
            continue;
        }
        const long double a = (min[axis] - place) / speed, b = (max[axis] - place) / speed;
        enter = std::max(enter, std::min(a, b));
        exit = std::min(exit, std::max(a, b));
    }
    return std::max(0.0L, exit - enter);
}

/// A flight, and how it was made.
Flight flightOf(const Field& field, Random& random, int kind) {
    const Vec2 cell = cellOf(field), size = field.max - field.min;
    const auto within = [&](double margin) {
        return field.min - margin * size +
               (1.0 + 2.0 * margin) * size * Vec2(random.in(0.0, 1.0), random.in(0.0, 1.0));
    };
    const auto vertex = [&] {
        return field.min + cell * Vec2(static_cast<double>(random.integer(0, field.width)),
                                       static_cast<double>(random.integer(0, field.height)));
    };
    const auto axis = [&] {
        const Vec2 axes[] = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};
        return axes[random.integer(0, 3)];
    };
    const double reach = glm::length(size) * random.in(0.0, 1.5);
    switch (kind) {
        case 0:  // from within or without
            return {{within(0.5), random.direction()}, reach};
        case 1:  // through vertices
            return {{vertex(), random.direction()}, reach};
        case 2: {  // from vertex to vertex
            const Vec2 from = vertex(), to = vertex();
            if (from == to) return {{from, {1.0, 0.0}}, reach};
            return {{from, glm::normalize(to - from)}, glm::length(to - from)};
        }
        case 3:  // along an axis
            return {{within(0.5), axis()}, kInfinity};
        case 4: {  // nearly along an axis
            const double turn =
                std::pow(10.0, random.in(-18.0, -1.0)) * (random.in(0.0, 1.0) < 0.5 ? -1.0 : 1.0);
            const Vec2 along = axis();
            return {{within(0.5), glm::normalize(along + turn * perp(along))}, reach};
        }
        case 5:  // shorter than a cell, down to nothing
            return {{within(0.1), random.direction()}, std::pow(10.0, random.in(-20.0, 0.0)) * cell.x};
        case 6:  // from far away
            return {{within(0.0) - 1e6 * size.x * Vec2(0.6, 0.8), {0.6, 0.8}}, kInfinity};
        default:  // along the diagonal of a cell
            return {{vertex() - 3.5 * cell, glm::normalize(cell)}, kInfinity};
    }
}
constexpr int kKinds = 8;

const std::vector<Field> kFields{
    {{-1.0, 0.5}, {2.0, 2.0}, 7, 5},          {{0.0, 0.0}, {1.0, 1.0}, 2, 2},
    {{-3.0, -2.0}, {5.0, 1.0}, 1, 9},         {{0.0, 0.0}, {1.0, 1.0}, 16, 1},
    {{1e3, 1e3}, {1e3 + 1, 1e3 + 1}, 13, 30}, {{0.0, 0.0}, {1e-6, 2e-6}, 31, 8},
    {{0.0, -1e6}, {1e6, 1e6}, 12, 20},
};

}  // namespace

TEST_CASE("splat: each cell gets the length of the flight in it, and nothing of it is lost") {
    Random random(1);
    for (const Field& field : kFields)
        for (int i = 0; i < 400 * kKinds; ++i) {
            const int kind = i % kKinds;
            const Flight flight = flightOf(field, random, kind);
            const Vec2 cell = cellOf(field);
            const double most = std::max(cell.x, cell.y);
            INFO(fmt::format("kind {}: from ({}, {}) along ({}, {}), {} m, cells {} x {}", kind,
                             flight.ray.origin.x, flight.ray.origin.y, flight.ray.direction.x,
                             flight.ray.direction.y, flight.distance, field.width, field.height));
            const std::vector<double> metres = splatted(field, {flight}, drawRunsBaseline);
            // Where the flight lies is known as well as its origin's coordinates are, and the field's.
            const double known = 1e-15 * (glm::length(flight.ray.origin) + glm::length(field.min) +
                                          glm::length(field.max - field.min)) +
                                 1e-13 * most;
            double sum = 0.0;
            for (std::uint32_t pixel = 0; pixel < metres.size(); ++pixel) {
                const Vec2 corner{field.min.x + pixel % field.width * cell.x,
                                  field.max.y - (pixel / field.width + 1) * cell.y};
                // Of flights along a border either side may have it: so many lie between the least and the
                // most that they are when the flight is shifted by what is not known.
                double least = kInfinity, greatest = 0.0;
                for (const Vec2 shift : {Vec2(0.0), Vec2(known, known), Vec2(-known, known),
                                         Vec2(known, -known), Vec2(-known, -known)}) {
                    const auto exact =
                        static_cast<double>(lengthWithin(corner, corner + cell, flight, shift));
                    least = std::min(least, exact);
                    greatest = std::max(greatest, exact);
                }
                if (metres[pixel] < least - 4.0 * known || metres[pixel] > greatest + 4.0 * known)
                    FAIL_CHECK(pixel << ": " << metres[pixel] << " m, not " << least << " ... " << greatest);
                sum += metres[pixel];
            }
            const auto exact = static_cast<double>(lengthWithin(field.min, field.max, flight));
            // The flight is cut off at the field's sides by coordinates that are rounded too.
            const double cut =
                1e-15 * (glm::length(flight.ray.origin) + glm::length(field.min) + glm::length(field.max));
            REQUIRE(std::abs(sum - exact) <= 1e-12 * exact + cut);
        }
}

TEST_CASE("splat: within a field about the origin the lengths add up to 1e-12 of the flight, however short") {
    const Field field{{-0.5, -0.5}, {0.5, 0.5}, 64, 48};
    Random random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Flight flight{{random.pointIn(-0.3, 0.3), random.direction()},
                            std::pow(10.0, random.in(-13.0, -0.8))};
        double sum = 0.0;
        for (const double length : splatted(field, {flight}, bestSplatKernel())) sum += length;
        REQUIRE(std::abs(sum - flight.distance) <= 1e-12 * flight.distance);
    }
}

TEST_CASE(
    "splat: thousands of flights over many bands of rows, as cell by cell, the same bits by every kernel") {
    // Wider than a band is high, and more flights than are drawn at once.
    const Field field{{-1.0, -1.0}, {2.0, 1.0}, 611, 407};
    Random random(3);
    std::vector<Flight> flights;
    // Of kinds that do not run along borders, where rounding chooses the side.
    for (int i = 0; i < 20'000; ++i)
        flights.push_back(flightOf(field, random, i % 3 == 0 ? 3 : i % 3 == 1 ? 5 : 0));
    std::vector<double> exact(std::size_t{field.width} * field.height, 0.0);
    for (const Flight& flight : flights)
        forCells(field, flight.ray, flight.distance,
                 [&](std::uint32_t pixel, double from, double to) { exact[pixel] += to - from; });
    const std::vector<double> metres = splatted(field, flights, drawRunsBaseline);
    double sum = 0.0, exactSum = 0.0;
    for (std::size_t pixel = 0; pixel < metres.size(); ++pixel) {
        REQUIRE(std::abs(metres[pixel] - exact[pixel]) <= 1e-9 * exact[pixel] + 1e-12);
        sum += metres[pixel];
        exactSum += exact[pixel];
    }
    CHECK(std::abs(sum - exactSum) <= 1e-12 * exactSum);
    for (const SplatKernel kernel : kernels()) CHECK(splatted(field, flights, kernel) == metres);
}

TEST_CASE("splat: powers that are not finite or below zero are counted in every cell that they reach") {
    const Field field{{0.0, 0.0}, {1.0, 1.0}, 9, 9};
    const Flight flight{{{-0.5, 0.31}, glm::normalize(Vec2(1.0, 0.13))}, kInfinity};
    std::uint64_t cells = 0;
    forCells(field, flight.ray, flight.distance, [&](std::uint32_t, double, double) { ++cells; });
    REQUIRE(cells > 8);
    for (const Rgb& power : {Rgb(1.0, kInfinity, 0.0), Rgb(std::nan(""), 0.0, 0.0)}) {
        Picture picture(81, Rgb(0.0));
        Counts counts;
        FieldSplat splat(field, picture, kNever);
        splat.add(flight.ray, flight.distance, power, counts);
        splat.finish();
        CHECK(counts.nonFinite == cells);
        for (const Rgb& value : picture) CHECK(value == Rgb(0.0));
    }
    Picture picture(81, Rgb(0.0));
    Counts counts;
    FieldSplat splat(field, picture, kNever);
    splat.add(flight.ray, flight.distance, {1.0, 1.0, -1.0}, counts);
    splat.finish();
    CHECK(counts.negative == cells);
    double blue = 0.0;
    for (const Rgb& value : picture) blue += value.z;
    CHECK(blue / 81.0 == doctest::Approx(-1.0 / flight.ray.direction.x).epsilon(1e-12));
}

TEST_CASE("splat: flights that miss, stand still or cannot be placed leave no trace and no harm") {
    const Field field{{0.0, 0.0}, {1.0, 1.0}, 20, 30};
    const std::vector<Flight> flights{
        {{{2.0, 0.5}, {1.0, 0.0}}, kInfinity},
        {{{0.5, 0.5}, {0.6, 0.8}}, 0.0},
        {{{-1.0, 0.5}, {1.0, 0.0}}, 0.5},
        {{{0.5, 1.0}, {1.0, 0.0}}, kInfinity},
    };
    for (const Flight& flight : flights)
        for (const double metres : splatted(field, {flight}, bestSplatKernel())) REQUIRE(metres == 0.0);
    // From where rounding is wider than the field it may cross any of it: a length, and no cell outside.
    Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const Vec2 direction = random.direction();
        const double away = std::pow(10.0, random.in(10.0, 300.0));
        for (const double metres :
             splatted(field, {{{-away * direction, direction}, kInfinity}}, bestSplatKernel()))
            REQUIRE(metres >= 0.0);
    }
}
