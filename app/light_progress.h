// How far is the light that is seen? For those who wait for it.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

/// Whether all that is asked for now is known.
bool lightIsComplete(const AppState& state);

/// 0 ... 1: P counts as much as each picture.
double lightShare(const AppState& state);

/// `P done, eye 30 %, field 55 %`
std::string lightParts(const AppState& state);

/// `42 %: P done, eye 30 %, field 55 %`
std::string lightProgress(const AppState& state);

}  // namespace halfdisk
