// Why is this way of carrying light taken? A sentence for each thing that ways do or don't.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

std::string lightSamplingReason(const RequirementsAnswer& answer);
std::string misReason(const RequirementsAnswer& answer);
std::string lightPassReason(const RequirementsQuestion& question, const RequirementsAnswer& answer);
std::string photonReason(const RequirementsQuestion& question, const RequirementsAnswer& answer);
std::string rouletteReason(const RequirementsAnswer& answer);

}  // namespace halfdisk
