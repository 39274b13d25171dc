// Which numbers stand beside the picture, in words? The same as in the panel of numbers, with what they mean.
#pragma once

#include <string>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

struct NumberWords {
    std::string name, value;
};

/// Those that the state shows and that are known.
std::vector<NumberWords> numberWords(const AppState& state);

}  // namespace halfdisk
