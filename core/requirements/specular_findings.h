// How many mirror and glass events in a row must be followed? By geometry, by what mirrors swallow, or else
// by a measurement.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// `rays` is added to. Throws Stopped.
SpecularFindings findSpecular(const RequirementsQuestion& question, const SceneFacts& facts,
                              std::uint64_t& rays);

/// What is left out by it, as measured, half of the tolerance at most: so much less may the bounces leave
/// out.
double specularShare(const SpecularFindings& specular, double tolerance);

/// Why so many, with all numbers.
std::string specularReason(const RequirementsAnswer& answer);

}  // namespace halfdisk
