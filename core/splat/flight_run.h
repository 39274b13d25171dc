// What is left of a flight through a field when its ends are cut off? Steps from row to row, or from column
// to column, all alike: each crosses one cell or two neighbours.
#pragma once

#include <cstddef>
#include <cstdint>

namespace halfdisk {

/// A steep run steps from row to row, downwards, and each step crosses one or two neighbours of its row. A
/// flat one steps from column to column, to either side, and each crosses one or two of its column; it never
/// rises.
struct FlightRun {
    double power[4];      ///< of one whole step: what it adds to the cells that it crosses; the last is 0
    double place, slope;  ///< across the steps, in cells: where step j's lower end lies is place + slope j
    double perCell;       ///< 1 / |slope|
    std::int32_t at;      ///< row, or column, of step 0
    std::int32_t count;   ///< of steps
    std::int32_t done;    ///< of which so many are drawn
    std::int32_t side;    ///< 0: steep; 1 or -1: the way from column to column
};

/// The rows of the field that are being filled, one after the other; of each cell four numbers, the last
/// unused. A step across two rows belongs to the upper one.
struct SplatBand {
    double* cells;               ///< of firstRow, column 0; 32-byte aligned
    std::ptrdiff_t stride;       ///< numbers from row to row
    std::int32_t width, height;  ///< of the whole field, in cells, at least 2 each
    std::int32_t firstRow, endRow;
    bool isLast;  ///< with the field's last row, which no step begins in but a steep one
};

/// Draws the steps of all runs that lie in the band; those of the bands above are done.
using SplatKernel = void (*)(const SplatBand& band, FlightRun* runs, std::size_t count);

/// The fastest that this processor has. All give the same bits.
SplatKernel bestSplatKernel();

}  // namespace halfdisk
