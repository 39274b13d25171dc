// Why is each requirement on or off? In sentences with the numbers that decided.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// One for each of kRequirements, of an answer whose plan is made.
std::vector<Requirement> requirementRows(const RequirementsQuestion& question,
                                         const RequirementsAnswer& answer);

}  // namespace halfdisk
