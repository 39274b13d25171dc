// What does it cost to skip a part, or to add one? The plan beside plans with one thing changed, measured on
// the scene: what light is missing then, how many rays the same noise takes, and how long a ray takes.
#pragma once

#include "core/requirements/requirements.h"

namespace halfdisk {

/// What one plan brings beside another one.
struct LightChange {
    double share = 0.0;          ///< of the mean light: (this - other) / other
    double standardError = 0.0;  ///< of it
    /// Root mean square of the change of each pixel, in parts of the light's, less what noise makes: light
    /// that is missing here and too much there shows as well. 0 where noise hides it.
    double ofPixels = 0.0;
};

/// A plan beside another one, which it would replace.
struct PlanCost {
    Plan plan;
    Pilot pilot;
    /// None: no run met any light, or none of that which the change adds or takes away.
    std::optional<LightChange> change;
    std::optional<double> raysFactor;  ///< rays to the same noise; none: no run of the other met any light
    double timePerRayFactor = 1.0;     ///< as measured here and now: no two machines agree
    std::optional<double> timeFactor() const {
        return raysFactor ? std::optional(*raysFactor * timePerRayFactor) : std::nullopt;
    }
};

struct RequirementCost {
    RequirementId id;
    std::uint32_t from = 0, to = 0;  ///< 0 off, 1 on; of Switch::number how many
    std::string impossible;          ///< empty, or why there is no such plan
    PlanCost cost;                   ///< if there is one
    std::string words;               ///< one sentence
};

struct Costs {
    Pilot plan;                         ///< of the plan itself
    std::vector<RequirementCost> rows;  ///< in the order of kRequirements; of numbers fewer, then more
    PlanCost everything;                ///< nothing left out (everythingOn), beside the plan
    std::string everythingImpossible;   ///< empty, or why there is no such plan
    double seconds = 0.0;
    std::size_t pieces = 0, done = 0;  ///< the plan, each row and everything: of them measured
    bool complete() const { return pieces > 0 && done == pieces; }
};

struct CostLimits {
    std::uint64_t rays = 150'000;  ///< of each run
    int repeats = 2;               ///< runs in turns; the fastest tells the time per ray
};

/// `answer` is what requirementsOf said to the question. Throws Stopped if question.stop says so.
Costs costsOf(const RequirementsQuestion& question, const RequirementsAnswer& answer,
              const CostLimits& limits = {});

/// The same piece by piece, beginning with Costs{}. False: all was there. Throws Stopped likewise, and costs
/// stay as they were.
bool measureNextCost(const RequirementsQuestion& question, const RequirementsAnswer& answer,
                     const CostLimits& limits, Costs& costs);

/// One plan beside another.
PlanCost compareCost(const RequirementsQuestion& question, const Plan& plan, const Plan& other,
                     const CostLimits& limits, Pilot* otherPilot = nullptr);

}  // namespace halfdisk
