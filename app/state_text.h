// What is seen, in words? All of a step for those who cannot see the canvas: read aloud, or as plain text.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

/// Lesson, step and its prose, what is shown, settings, the scene, P, the numbers, what each drawing shows,
/// the recorded run, the goal and the question. At most 100 columns wide; the same state gives the same text.
std::string stateText(const AppState& state);

}  // namespace halfdisk
