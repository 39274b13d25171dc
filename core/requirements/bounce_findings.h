// How many scatterings must be followed? Bounds from albedos and from the spectral radius, and a measurement.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// `series` is followed as deep as its plan says. `rays` is added to.
BounceFindings findBounces(const RequirementsQuestion& question, const SceneFacts& facts,
                           const std::optional<Series>& series, std::uint64_t& rays);

/// What more than `depth` scatterings bring, as far as it is known: between two depths that were measured,
/// and beyond the last one where that was not enough, as if light fell by the same share from each to the
/// next.
std::optional<BeyondDepth> shareBeyondDepth(const BounceFindings& bounces, std::uint32_t depth);

/// Mean light at the sensor of at most `depth` scatterings, as far as patches know that it is surely there; 0
/// where they don't.
double knownLight(const BounceFindings& bounces, std::uint32_t depth);

/// Why so many, with all numbers. `taken`: what mirror and glass events leave out of the tolerance already.
std::string bouncesReason(const BounceFindings& bounces, const SceneFacts& facts, double tolerance,
                          double taken);

}  // namespace halfdisk
