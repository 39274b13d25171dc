// What does a glass disk throw on the floor? The exact answer for light that crosses the true circle once,
// and what facets make of it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene.h"

namespace halfdisk::test {

/// The caustic of tests/cases/29: index 1.5, radius 1, centre 1.3 above a black floor, the sun straight
/// above.
struct CausticSetup {
    double ior = 1.5, height = 1.3, radius = 1.0, halfFloor = 3.0;
    std::uint32_t bins = 120;  ///< of 0.05 m
};

/// Disk of `facets` segments (clockwise: fronts outside), then the floor as the last segment; the sun.
Scene causticScene(const CausticSetup& setup, std::uint32_t facets, bool smooth);

/// Mean irradiance of each bin by light that is refracted in and out of the true circle: Snell and Fresnel
/// along `rays` evenly spread rays of the sun, by formulas of the circle alone.
std::vector<double> exactCaustic(const CausticSetup& setup, std::uint64_t rays);

/// The same through the program's walls and materials: facets, flat or round, each ray refracted twice and
/// weighed by what passes.
std::vector<double> facetCaustic(const CausticSetup& setup, std::uint32_t facets, bool smooth,
                                 std::uint64_t rays);

/// L1 distance of two profiles over the power of the first; and the relative difference of their powers.
struct CausticError {
    double distance, power;
};
CausticError causticError(const std::vector<double>& exact, const std::vector<double>& other);

}  // namespace halfdisk::test
