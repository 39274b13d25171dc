// How is what a scene requires told, to people and to scripts?
#pragma once

#include <string>

#include "app/cli_output.h"
#include "core/requirements/costs.h"

namespace halfdisk {

/// `on`, `off` or the number.
std::string requirementValue(const Requirement& requirement);

/// `estimator path, emitters = both, ...; depth 4, specular 0`.
std::string planLine(const Plan& plan, const SegmentIndex& index);

/// False of an answer that was called off before there was a plan.
bool isPlanned(const RequirementsAnswer& answer);

/// Every requirement with its reason, then the plan; without one, what was tried.
std::string requirementsText(const RequirementsAnswer& answer, const SegmentIndex& index);

/// What `--explain` tells before the result. `estimator` is the one that was asked for.
std::string explanation(const RequirementsAnswer& answer, const SegmentIndex& index,
                        std::string_view estimator);

/// Light that a picture lacks which is made by the plan, in words; empty: none that is known of.
std::string lostWords(const RequirementsAnswer& answer);

/// The same as a line below the result; empty if there is nothing to warn of.
std::string lostWarning(const RequirementsAnswer& answer);

/// The same as the result's field `loses`, null if there is nothing.
void tellLost(const RequirementsAnswer& answer, Json& result);

/// Options of `halfdisk eye` and the like that give the plan without asking again.
std::string planOptions(const Plan& plan);

/// What skipping or adding each part costs, and what everything together would.
std::string costsText(const Costs& costs);
Json costsJson(const Costs& costs, const SegmentIndex& index);

Json planJson(const Plan& plan, const SegmentIndex& index);
Json requirementsJson(const RequirementsAnswer& answer, const SegmentIndex& index);

}  // namespace halfdisk
