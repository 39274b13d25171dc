// How far is the light along P's wall, as each maker says it, from the exact one? In percent, bin by bin.
#pragma once

#include <array>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

struct ProfileDifference {
    std::vector<double>
        percent;  ///< of each bin: (estimate - exact) / mean of all exact bins; empty: not known
    std::vector<double> error;  ///< its standard error; 0 where one pass alone has none
};

/// Of the first and the second maker.
std::array<ProfileDifference, 2> profileDifferences(const AppState& state);

/// Percent, a round number: nearly all differences are smaller, and not all of them much.
double reachOf(const std::array<ProfileDifference, 2>& differences);

/// Whether differences are to be seen, and there is or will be an exact profile.
bool plotsDifference(const AppState& state);

}  // namespace halfdisk
