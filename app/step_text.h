// What just happened, in words and numbers? One event of the recorded run as a reader would say it.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

/// The event passed last: "step 2: rotate by the frame" and its numbers. "" before the first.
struct StepText {
    std::string where;   ///< "depth 1, sample 2 of 4"
    std::string what;    ///< in words
    std::string values;  ///< in numbers
};
StepText describeStep(const AppState& state);

/// The event passed last; null before the first, when the whole run is shown, and for another run than
/// castRay's.
const Event* currentEvent(const AppState& state);

}  // namespace halfdisk
