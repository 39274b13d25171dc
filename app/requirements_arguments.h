// What is to be required in any case, and what is still good enough? `--force` and `--tolerance`, read by the
// table of requirements.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/estimator_arguments.h"
#include "core/requirements/costs.h"

namespace halfdisk {

/// `mis=off`, `bounces=3` ... Throws InputError for unknown names, facts that can't be switched, wrong
/// values, and a name given twice.
std::vector<Forced> forcedArguments(const std::vector<std::string>& texts);

/// A share of the light.
double toleranceArgument(const std::string& text);

/// What `--estimator` says where the program shall choose.
inline constexpr std::string_view kAutomatic = kAutomaticEstimator;

/// As typed, of commands that measure light.
struct PlanTexts {
    std::optional<std::string> tolerance;
    std::vector<std::string> force;
    bool explain = false;
    bool depthGiven = false, specularGiven = false;  ///< then they are not the plan's to choose
};

struct PlanRequest {
    bool automatic = false;  ///< do what the plan says
    bool explain = false;    ///< tell it
    double tolerance = kInitialTolerance;
    std::vector<Forced> forced;

    bool asks() const { return automatic || explain; }
    /// By which the walls are to be found.
    IndexMethod indexMethod() const;
};

/// `--tolerance`, `--force`, `--explain`.
void addPlanOptions(CLI::App& command, PlanTexts& texts);

/// Throws InputError, also for what only `--estimator auto` can do.
PlanRequest planRequest(const PlanTexts& texts, std::string_view estimator,
                        const std::vector<std::string>& params, std::uint32_t depth, std::uint32_t specular);

/// A line `  name  what it asks` for each that can be forced, for help.
std::string describedSwitches();

/// findRequirements with a progress bar; what it can't do becomes an InputError. False: Ctrl-C ended it, and
/// what was found until then is in `answer`.
bool askRequirements(RequirementsQuestion question, RequirementsAnswer& answer);
/// costsOf with a progress bar, as far as it came before Ctrl-C: see Costs::complete.
Costs costsAsked(RequirementsQuestion question, const RequirementsAnswer& answer, const CostLimits& limits);
/// Empty: Ctrl-C ended it.
std::optional<RequirementsAnswer> requirementsAsked(const PlanRequest& request, const SegmentIndex& index,
                                                    const Sensor& sensor, std::uint64_t seed);

}  // namespace halfdisk
