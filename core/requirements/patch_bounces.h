// How much light do further bounces bring between matt walls? By patches: the light that arrives after each
// scattering, and the factor by which it shrinks in the end, the spectral radius of the operator.
#pragma once

#include <optional>
#include <vector>

#include "core/sensor.h"
#include "core/stop.h"

namespace halfdisk {

struct PatchBounces {
    /// Spectral radius of rho F by power iteration, the largest of the three channels: in the end each bounce
    /// brings so much of the one before.
    double spectralRadius = 0.0;
    std::size_t patches = 0;
    /// Share of the light at the sensor that comes after more than D scatterings, D = 0, 1, ...: the larger
    /// one of means and of root mean squares over what the sensor sees. Until it is below the tolerance, or
    /// 1000: of all light, that of still later scatterings too.
    std::vector<double> beyond;
};

/// Walls must be flat and diffuse. Empty where there are too many of them to wait for, and where the sensor
/// sees no patch. Throws Stopped if `stop` says so.
std::optional<PatchBounces> patchBounces(const SegmentIndex& index, const Sensor& sensor, double tolerance,
                                         const StopQuestion& stop = {});

}  // namespace halfdisk
