// How is what a scene requires told to people?
#pragma once

#include <string>

#include "core/requirements/costs.h"

namespace halfdisk {

/// `on`, `off` or the number.
std::string requirementValue(const Requirement& requirement);
std::string switchedValue(RequirementId id, std::uint32_t value);

/// Every requirement with its reason, then the plan; without one, what was tried.
std::string requirementsText(const RequirementsAnswer& answer, const SegmentIndex& index);

/// What `--explain` tells before the result. `estimator` is the one that was asked for.
std::string explanation(const RequirementsAnswer& answer, const SegmentIndex& index,
                        std::string_view estimator);

/// What skipping or adding each part costs, and what everything together would.
std::string costsText(const Costs& costs);

}  // namespace halfdisk
