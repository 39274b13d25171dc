// How is a plan told, and what it leaves out?
#pragma once

#include <string>

#include "core/requirements/requirements.h"

namespace halfdisk {

/// How it looks walls up: of IndexMethod::automatic what that comes to.
std::string_view methodOf(const Plan& plan, const SegmentIndex& index);

/// `estimator path, emitters = both, ...; depth 4, specular 0`.
std::string planLine(const Plan& plan, const SegmentIndex& index);

/// False of an answer that was called off before there was a plan.
bool isPlanned(const RequirementsAnswer& answer);

/// Light that a picture lacks which is made by the plan, in words; empty: none that is known of.
std::string lostWords(const RequirementsAnswer& answer);

/// The same as a sentence.
std::string lostSentence(const RequirementsAnswer& answer);

/// The same as a line below the result; empty if there is nothing to warn of.
std::string lostWarning(const RequirementsAnswer& answer);

/// How badly the plan's short run knows its light, and what that may make wrong; empty: well.
std::string rareSentence(const RequirementsAnswer& answer);

}  // namespace halfdisk
