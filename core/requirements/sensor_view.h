// What does a sensor make of the light that arrives at the patches of matt walls?
#pragma once

#include "core/patches.h"
#include "core/sensor.h"

namespace halfdisk {

/// Means over the sensor's pixels.
struct SensorView {
    /// What it measures of light that `maxDepth` = 0 carries: straight from its source or, if it looks at
    /// walls, scattered by what it sees. W/m or W/(m rad).
    Rgb straight{0.0};
    /// By patch, what irradiance 1 W/m there adds: to the light of as many scatterings, and of one more.
    std::vector<Rgb> now, later;
};

/// `direct`: by patch, irradiance (W/m) of light that was never scattered. About so many `places` are looked
/// from or at; what an eye or a free point sees through a slit, however narrow, is among them.
SensorView viewOf(const Sensor& sensor, const Visibility& visibility, const Patches& patches,
                  const std::vector<Rgb>& direct, std::uint32_t places, const StopQuestion& stop = {});

}  // namespace halfdisk
