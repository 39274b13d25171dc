// How is a step added to the one or two cells that it crosses, without a branch or a division?
//
// Step j's lower end, across the steps, lies at x = place + slope j cells, and its upper one |slope| <= 1
// further: in cell floor(x), and beyond its border in the next one. The first has the share (floor(x) + 1 -
// x) / |slope| of the step, at most all of it. Shares are worked out for a block of steps at a time, in
// vectors; then each step adds two vectors of red, green and blue.
//
// Included only by the kernels; the unnamed namespace gives each instruction set its own copy, so that the
// linker never hands an old processor a new one's code. All do the same sums in the same order.
#pragma once

#include "core/splat/flight_run.h"

namespace halfdisk {
namespace {

#if defined(__AVX2__)
constexpr int kLanes = 4;
#else
constexpr int kLanes = 2;
#endif
constexpr int kBlock = 64;

using Numbers [[gnu::vector_size(kLanes * 8)]] = double;
using Wholes [[gnu::vector_size(kLanes * 4)]] = std::int32_t;
using Color [[gnu::vector_size(32), gnu::may_alias]] = double;

/// Of some steps in a row: the first cell that each crosses, and its share.
struct Shares {
    alignas(32) double share[kBlock];
    alignas(32) std::int32_t cell[kBlock];
};

inline std::int32_t least(std::int32_t a, std::int32_t b) {
    return a < b ? a : b;
}

inline std::int32_t cellOf(const FlightRun& run, std::int32_t step, double lastPair) {
    const double x = run.place + run.slope * static_cast<double>(step);
    const double inside = x < lastPair ? x : lastPair;
    return static_cast<std::int32_t>(inside > 0.0 ? inside : 0.0);
}

/// Steps `first` ... first + count - 1, and some more up to whole vectors. `lastPair`: a step may cross this
/// cell and the next, and none further on.
inline void plan(const FlightRun& run, std::int32_t first, std::int32_t count, double lastPair,
                 Shares& shares) {
    const Numbers zero{}, one = zero + 1.0, most = zero + lastPair;
    Numbers step = zero + static_cast<double>(first);
    for (int lane = 0; lane < kLanes; ++lane) step[lane] += lane;
    for (std::int32_t j = 0; j < count; j += kLanes) {
        const Numbers x = run.place + run.slope * step;
        step += static_cast<double>(kLanes);
        Numbers inside = x < most ? x : most;
        inside = inside > zero ? inside : zero;
        const Wholes cell = __builtin_convertvector(inside, Wholes);
        Numbers share = (__builtin_convertvector(cell, Numbers) + one - x) * run.perCell;
        share = share < one ? share : one;
        share = share > zero ? share : zero;
        *reinterpret_cast<Wholes*>(shares.cell + j) = cell;
        *reinterpret_cast<Numbers*>(shares.share + j) = share;
    }
}

/// Steps `from` ... to - 1. `at`: where step `from` finds cell 0 of its row or column; `along` and `across`:
/// numbers from step to step, and from cell to cell.
inline void draw(const FlightRun& run, std::int32_t from, std::int32_t to, double lastPair, double* at,
                 std::ptrdiff_t along, std::ptrdiff_t across) {
    Color power;
    for (int c = 0; c < 4; ++c) power[c] = run.power[c];
    Shares shares;
    for (std::int32_t first = from; first < to; first += kBlock) {
        const std::int32_t count = least(kBlock, to - first);
        plan(run, first, count, lastPair, shares);
        for (std::int32_t j = 0; j < count; ++j, at += along) {
            double* const cell = at + across * shares.cell[j];
            const Color mine = power * shares.share[j];
            *reinterpret_cast<Color*>(cell) += mine;
            *reinterpret_cast<Color*>(cell + across) += power - mine;
        }
    }
}

inline void drawSteep(const SplatBand& band, FlightRun& run) {
    const std::int32_t to = least(run.count, (band.isLast ? band.height : band.endRow) - run.at);
    if (to <= run.done) return;
    draw(run, run.done, to, band.width - 2, band.cells + band.stride * (run.at + run.done - band.firstRow),
         band.stride, 4);
    run.done = to;
}

/// Steps are done up to the first that lies below the band.
inline std::int32_t endOfFlat(const SplatBand& band, const FlightRun& run) {
    if (band.isLast) return run.count;
    const double lastPair = band.height - 2;
    const double guess = (band.endRow - run.place) * run.perCell;
    std::int32_t to =
        guess < run.count ? (guess > run.done ? static_cast<std::int32_t>(guess) : run.done) : run.count;
    while (to < run.count && cellOf(run, to, lastPair) < band.endRow) ++to;
    while (to > run.done && cellOf(run, to - 1, lastPair) >= band.endRow) --to;
    return to;
}

inline void drawFlat(const SplatBand& band, FlightRun& run) {
    const std::int32_t to = endOfFlat(band, run);
    if (to <= run.done) return;
    draw(run, run.done, to, band.height - 2,
         band.cells - band.stride * band.firstRow +
             4 * (std::ptrdiff_t{run.at} + std::ptrdiff_t{run.side} * run.done),
         4 * run.side, band.stride);
    run.done = to;
}

void drawRuns(const SplatBand& band, FlightRun* runs, std::size_t count) {
    for (FlightRun* run = runs; run != runs + count; ++run) {
        if (run->done == run->count) continue;
        if (run->side == 0) {
            drawSteep(band, *run);
        } else {
            drawFlat(band, *run);
        }
    }
}

}  // namespace
}  // namespace halfdisk
