// How is what a scene requires told to scripts?
#pragma once

#include "app/cli_output.h"
#include "core/requirements/costs.h"

namespace halfdisk {

Json planJson(const Plan& plan, const SegmentIndex& index);
Json requirementsJson(const RequirementsAnswer& answer, const SegmentIndex& index);
Json costsJson(const Costs& costs, const SegmentIndex& index);

/// lostWords as the result's field `loses`, null if there is nothing.
void tellLost(const RequirementsAnswer& answer, Json& result);

}  // namespace halfdisk
