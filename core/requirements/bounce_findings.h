// How many scatterings must be followed? Bounds from albedos and from the spectral radius, and a measurement.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// `rays` is added to.
BounceFindings findBounces(const RequirementsQuestion& question, const SceneFacts& facts,
                           std::uint32_t maxSpecular, std::uint64_t& rays);

/// Why so many, with all numbers. `taken`: what mirror and glass events leave out of the tolerance already.
std::string bouncesReason(const BounceFindings& bounces, const SceneFacts& facts, double tolerance,
                          double taken);

}  // namespace halfdisk
