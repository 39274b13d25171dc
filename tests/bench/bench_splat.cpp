// What does it cost to draw a flight of light into the field, cell by cell and by the kernels?
#include <random>
#include <stdexcept>

#include "benches.h"
#include "core/field_cells.h"
#include "core/splat/field_splat.h"
#include "core/splat/kernels.h"
#include "timing.h"

namespace halfdisk {
namespace {

/// Half of what hqz takes to draw into as many pixels.
constexpr std::uint32_t kJudgedCells = 1024;
constexpr double kMostMicroseconds = 5.0;

enum class Way { crossing, steep, flat, diagonal, brief };
struct WayInfo {
    Way way;
    const char* name;
};
constexpr WayInfo kWays[]{{Way::crossing, "from side to side"},
                          {Way::steep, "nearly upright"},
                          {Way::flat, "nearly level"},
                          {Way::diagonal, "corner to corner"},
                          {Way::brief, "a hundredth of the side"}};

struct Flight {
    Ray ray;
    double distance;
};

std::vector<Flight> flightsOf(Way way, std::size_t count) {
    std::mt19937_64 engine(1);
    const auto in = [&](double from, double to) {
        return from + (to - from) * ((static_cast<double>(engine() >> 12) + 0.5) * 0x1p-52);
    };
    const auto ends = [&](std::size_t i) -> std::pair<Vec2, Vec2> {
        const double u = in(0.0, 1.0), near = std::clamp(u + in(-0.1, 0.1), 0.0, 1.0);
        switch (way) {
            case Way::crossing:
                return i % 2 == 0 ? std::pair{Vec2(0.0, u), Vec2(1.0, in(0.0, 1.0))}
                                  : std::pair{Vec2(u, 0.0), Vec2(in(0.0, 1.0), 1.0)};
            case Way::steep:
                return {{u, 0.0}, {near, 1.0}};
            case Way::flat:
                return {{0.0, u}, {1.0, near}};
            case Way::diagonal:
                return {{0.02 * u, 0.0}, {0.98 + 0.02 * u, 1.0}};
            case Way::brief:
                break;
        }
        const Vec2 from{u, in(0.0, 1.0)};
        const double angle = in(0.0, 2.0 * kPi);
        return {from, from + 0.01 * Vec2(std::cos(angle), std::sin(angle))};
    };
    std::vector<Flight> flights;
    for (std::size_t i = 0; i < count; ++i) {
        auto [from, to] = ends(i);
        if (engine() % 2 == 0) std::swap(from, to);
        flights.push_back({{from, glm::normalize(to - from)}, glm::length(to - from)});
    }
    return flights;
}

/// All flights into one picture, by one way of drawing.
struct Drawing {
    const Field& field;
    const std::vector<Flight>& flights;
    Picture picture{};

    double sum() const {
        double all = 0.0;
        for (const Rgb& cell : picture) all += cell.x;
        return all;
    }
    void clear() { picture.assign(std::size_t{field.width} * field.height, Rgb(0.0)); }
    double cellByCell() {
        clear();
        Counts counts;
        const Rgb perMetre = Rgb(1.0, 0.7, 0.3) * (static_cast<double>(field.width) * field.height);
        const double start = threadSeconds();
        for (const Flight& flight : flights)
            forCells(field, flight.ray, flight.distance, [&](std::uint32_t pixel, double from, double to) {
                addTo(picture, pixel, perMetre * (to - from), counts);
            });
        return threadSeconds() - start;
    }
    double by(SplatKernel kernel) {
        clear();
        Counts counts;
        const StopQuestion never;
        const double start = threadSeconds();
        FieldSplat splat(field, picture, never, kernel);
        for (const Flight& flight : flights) splat.add(flight.ray, flight.distance, {1.0, 0.7, 0.3}, counts);
        splat.finish();
        return threadSeconds() - start;
    }
};

struct Costs {
    double cells, cellByCell, baseline, best;  ///< microseconds a flight
};

Costs measure(std::uint32_t side, Way way, Effort effort) {
    const bool full = effort == Effort::full;
    const Field field{{0.0, 0.0}, {1.0, 1.0}, side, side};
    // Ten times as many as are drawn together.
    const std::vector<Flight> flights = flightsOf(way, full ? 160'000 : 500);
    // Cell by cell takes its time.
    const std::vector<Flight> some(flights.begin(), flights.begin() + (full ? 20'000 : 500));
    double cells = 0.0;
    for (const Flight& flight : some)
        forCells(field, flight.ray, flight.distance, [&](std::uint32_t, double, double) { cells += 1.0; });
    Drawing few{field, some}, many{field, flights};
    std::vector<double> slow, baseline, best;
    for (int turn = -1; turn < (full ? 7 : 1); ++turn) {
        const double one = few.cellByCell(), sum = few.sum();
        few.by(bestSplatKernel());
        if (std::abs(few.sum() - sum) > 1e-9 * sum) throw std::logic_error("flights lose their length");
        const double two = many.by(drawRunsBaseline), three = many.by(bestSplatKernel());
        if (turn < 0) continue;
        slow.push_back(one);
        baseline.push_back(two);
        best.push_back(three);
    }
    const double perSome = 1e6 / static_cast<double>(some.size()),
                 perFlight = 1e6 / static_cast<double>(flights.size());
    return {cells / static_cast<double>(some.size()), perSome * quantile(slow, 0.5),
            perFlight * quantile(baseline, 0.5), perFlight * quantile(best, 0.5)};
}

}  // namespace

void benchSplat(Report& report, Effort effort) {
    report.print(
        "A flight of light into the cells that it crosses: microseconds, cell by cell and by the kernels "
        "(required from side to side of {0} x {0} cells: < {1:g}; hqz: about 10)\n",
        kJudgedCells, kMostMicroseconds);
    report.print("  {:<10} {:<24} {:>8} {:>14} {:>10} {:>10} {:>8}\n", "cells", "way", "crossed",
                 "cell by cell", "baseline", "best", "ratio");
    for (const std::uint32_t side : {160u, 480u, kJudgedCells})
        for (const WayInfo& info : kWays) {
            report.progress(info.name);
            const Costs costs = measure(side, info.way, effort);
            std::optional<double> most;
            if (side == kJudgedCells && info.way == Way::crossing) most = kMostMicroseconds;
            const auto mark =
                report.judge("microseconds per flight into the field", costs.best, std::nullopt, most);
            report.print("  {:<10} {:<24} {:>8.0f} {:>14.3f} {:>10.3f} {:>10.3f} {:>8.1f} {}\n",
                         fmt::format("{}^2", side), info.name, costs.cells, costs.cellByCell, costs.baseline,
                         costs.best, costs.cellByCell / costs.best, mark);
            report.add("splat", {{"side", side},
                                 {"way", info.name},
                                 {"cells", costs.cells},
                                 {"cellByCell", costs.cellByCell},
                                 {"baseline", costs.baseline},
                                 {"best", costs.best}});
        }
    report.progress("");
}

}  // namespace halfdisk
