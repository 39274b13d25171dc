// What does each drawing show, in words? Ranges, where the most is, and a coarse reading from left to right.
#pragma once

#include <string>
#include <string_view>

#include "app/app_state.h"

namespace halfdisk {

/// Of the drawing of that name: canvas, integrand, error, histogram, profile, eye, or field (which is part of
/// the canvas). Lines, without the light that is not known yet.
std::string drawingWords(const AppState& state, std::string_view name);

/// What a drawing is called on the screen.
std::string drawingTitle(const AppState& state, std::string_view name);

}  // namespace halfdisk
