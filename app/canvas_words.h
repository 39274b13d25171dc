// What does the canvas show, in words? Its layers, where the rays go, and what they bring.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

std::string canvasWords(const AppState& state);

}  // namespace halfdisk
