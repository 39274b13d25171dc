// Has the reader reached the step's goal?
#pragma once

#include <optional>

#include "app/app_state.h"

namespace halfdisk {

/// What the goal looks at, as far as the light is known now.
std::optional<double> valueOf(const Goal& goal, const AppState& state);

/// Bins of the curve that a reader draws, over theta from 0 to pi.
inline constexpr std::size_t kDrawnBins = 180;

/// Whether the step asks for a curve; what is exact stays hidden until it is drawn, and the pointer let go.
bool asksForCurve(const AppState& state);
bool isDrawn(const AppState& state);

bool isReached(const Goal& goal, double value);

}  // namespace halfdisk
