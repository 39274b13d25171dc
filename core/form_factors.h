// How much of the light that leaves one piece of wall arrives at another? Crossed strings, pulled tight round
// what stands between.
//
// Hottel 1954, "Radiant heat transmission", in McAdams, "Heat Transmission", chapter 4: in the plane the form
// factor of two pieces is F12 = (crossed strings - uncrossed strings) / (2 l1). From a point on the first,
// light that arrives between two directions counts (cos from - cos to) / 2, and the integral along the piece
// of the cosine towards a fixed point V is the difference of the lengths of two strings to V. So the piece is
// cut where a line through two corners meets it; between cuts every visible part of the other piece is
// bounded by the same two corners, and its strings are exact.
#pragma once

#include <memory>
#include <span>

#include "hull.h"
#include "patches.h"

namespace halfdisk {

/// What is nearer than this (m) to a wall's line is on it.
double roundingOf(const SegmentIndex& index);

/// Exchange length (m) l1 F12 = l2 F21 of the sides of two pieces with nothing between them. A part of one
/// behind the other does not count.
double unoccludedExchange(const Strand& from, const Strand& to);

/// The same where `walls` may stand between them; exact to rounding, whatever they hide. Throws Stopped if
/// `stop` says so, like all that follows.
double exchangeLength(const Strand& from, const Strand& to, std::span<const Strand> walls, double rounding,
                      const StopQuestion& stop = {});

/// l_i F_ij (m) of all pairs of patches, symmetric; row by row.
struct ExchangeLengths {
    std::size_t size = 0;
    std::unique_ptr<double[]> all;

    double operator[](std::size_t place) const { return all[place]; }
};

/// O(N^2) of N patches, more where something stands between, and n^3 of n walls.
ExchangeLengths exchangeLengths(const SegmentIndex& index, const Patches& patches,
                                const StopQuestion& stop = {});

}  // namespace halfdisk
