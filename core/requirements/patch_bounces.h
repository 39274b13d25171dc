// How much light do further bounces bring between matt walls? By patches: the light that arrives after each
// scattering, and the factor by which it shrinks in the end, the spectral radius of the operator.
#pragma once

#include <optional>
#include <vector>

#include "core/requirements/beyond_depth.h"
#include "core/sensor.h"
#include "core/stop.h"

namespace halfdisk {

struct PatchBounces {
    /// Spectral radius of rho F by power iteration, the largest of the three channels: in the end each bounce
    /// brings so much of the one before.
    double spectralRadius = 0.0;
    std::size_t patches = 0;
    double light = 0.0, lightError = 0.0;  ///< mean of all pixels and channels, of any number of scatterings
    /// Of light at the sensor that is scattered more often than D = 0, 1, ... times: until that is surely no
    /// more than the tolerance, or 1000. The errors: how much half as many patches differ, no
    /// less than half of how much coarser ones do, and of that of one scattering less.
    std::vector<BeyondDepth> beyond;
};

/// Walls must be flat and diffuse. Empty where there are too many of them to wait for, and where no light
/// reaches the sensor. Throws Stopped if `stop` says so.
std::optional<PatchBounces> patchBounces(const SegmentIndex& index, const Sensor& sensor, double tolerance,
                                         const StopQuestion& stop = {});

}  // namespace halfdisk
