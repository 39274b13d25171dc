// What do the instruments show, in words and in tables? For those who cannot see them, and for files.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

/// A line of the dial's table: what is counted, by the tracer that was chosen and by the program itself.
struct DialLine {
    std::string name;  ///< in the window's language
    std::string chosen, product;
    bool wrong = false;  ///< the chosen tracer fails here
    std::string_view meaning;
    std::optional<LostRay::How> how{};  ///< whose mark it has on the canvas; none: it has no place there
};
std::vector<DialLine> dialLines(const DialAnswer& answer);

/// `In float, with hits nearer than 0.0001 m ignored, 12 % of the rays go wrong; of Halfdisk's own none.`
std::string dialVerdict(const DialAnswer& answer);

std::string extremesWords(const AppState& state);
/// CSV: see plot_tables.h.
std::string extremesTable(const AppState& state);

}  // namespace halfdisk
