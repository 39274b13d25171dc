// What is the reader to reach by trying? A number that is on the screen anyway, and how far it must go.
#pragma once

#include <string>
#include <vector>

#include "lessons/claim.h"

namespace halfdisk {

/// What a goal looks at, at the present P and settings.
enum class GoalQuantity : std::uint8_t {
    irradiance,
    profile,
    relativeError,
    standardError,
    rays,
    line,
    drawn
};

inline constexpr std::array<Named<GoalQuantity>, 7> kGoalQuantities{{
    {GoalQuantity::irradiance, "irradiance",
     "E at P: the exact one where it is known, else of many runs, W/m"},
    {GoalQuantity::profile, "profile", "E of the profile's bin at P, W/m"},
    {GoalQuantity::relativeError, "relativeError", "typical error of a run of N samples, as a share of E"},
    {GoalQuantity::standardError, "standardError", "typical error of a run of N samples, W/m"},
    {GoalQuantity::rays, "rays", "rays of one run"},
    {GoalQuantity::line, "line", "a line of the listing, chosen by a click"},
    {GoalQuantity::drawn, "drawn",
     "how well the curve of light that was drawn agrees with the exact one, 0 to 1"},
}};

struct Goal {
    std::string says;  ///< what to do
    GoalQuantity quantity = GoalQuantity::irradiance;
    Relation relation = Relation::atLeast;  ///< not `equals`
    double number = 0.0;
    std::vector<int> lines{};  ///< of the published listing, of GoalQuantity::line: any of them is right
    bool operator==(const Goal&) const = default;
};

}  // namespace halfdisk
