// Has the reader reached the step's goal?
#pragma once

#include <optional>

#include "app/app_state.h"

namespace halfdisk {

/// What the goal looks at, as far as the light is known now.
std::optional<double> valueOf(const Goal& goal, const AppState& state);

bool isReached(const Goal& goal, double value);

}  // namespace halfdisk
