// How does the eye's strip differ from the exact one? Both as colours, on one scale for all strips that are
// shown.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

struct StripDifferences {
    std::vector<std::uint32_t> exact;  ///< colours of the exact strip, in the shade of the pictures; empty:
                                       ///< none is wanted, or none known
    std::array<std::vector<std::uint32_t>, 2> difference;  ///< of the first and the second maker's pixels
    double full = 0.0;   ///< W/(m rad): a difference of so much has the full colour
    double share = 0.0;  ///< the same, of what is shown as white; 0: all is black
};

/// Too bright is orange, too dark is blue, and paper is right.
StripDifferences stripDifferences(const AppState& state);

}  // namespace halfdisk
