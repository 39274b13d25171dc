// What just happened in the run of an estimator that follows paths, in words and numbers? step_text.h says
// the same of castRay's.
#pragma once

#include "app/step_text.h"

namespace halfdisk {

/// The step passed last; null before the first, when the whole run is shown, and for castRay's run.
const PathEvent* currentPathEvent(const AppState& state);

/// Of `event`, a step of the run that the state shows.
StepText describePathEvent(const AppState& state, const PathEvent& event);

}  // namespace halfdisk
