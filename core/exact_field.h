// What should cells of a field show without any noise? A few of them by quadrature over each, to hold
// estimates against.
#pragma once

#include <vector>

#include "radiosity.h"
#include "sensor.h"

namespace halfdisk {

/// Some cells of a field, spread evenly, and the mean fluence (W/m) of each.
struct KnownCells {
    std::vector<std::uint32_t> pixels;
    std::vector<Rgb> mean;
};

/// About `count` cells of `field`, all if it has fewer. What is never scattered is exact, the rest as good as
/// the patches of `light` are fine (estimators/radiosity.cpp tells the error). Adaptive quadrature over each
/// cell: kinks and the edges of shadows are enclosed to 1/16 of it. Throws Stopped.
KnownCells exactCells(const Radiosity& light, const Field& field, std::size_t count,
                      const StopQuestion& stop = {});

/// The same as of a whole picture (exact_picture.h), by the known cells alone; nothing also if `pixels` is
/// not one value for each cell of `field`.
std::optional<double> relativeError(const std::vector<Rgb>& pixels, const KnownCells& known,
                                    const Field& field);

}  // namespace halfdisk
