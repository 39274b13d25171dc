// What is to be required in any case, and what is still good enough? `--force` and `--tolerance`, read by the
// table of requirements.
#pragma once

#include <string>
#include <vector>

#include "core/requirements/requirements.h"

namespace halfdisk {

/// `mis=off`, `bounces=3` ... Throws InputError for unknown names, facts that can't be switched, wrong
/// values, and a name given twice.
std::vector<Forced> forcedArguments(const std::vector<std::string>& texts);

/// A share of the light.
double toleranceArgument(const std::string& text);

/// A line `  name  what it asks` for each that can be forced, for help.
std::string describedSwitches();

/// requirementsOf; what it can't do becomes an InputError.
RequirementsAnswer requirementsAsked(const RequirementsQuestion& question);

}  // namespace halfdisk
