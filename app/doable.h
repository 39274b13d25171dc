// What can be done now? Everything that a key, a button or a switch of the present state would do, by name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/commands.h"

namespace halfdisk {

struct Doable {
    std::string name;
    std::string_view key;  ///< that does the same; empty: none
    Command command;
};

/// What one does most comes first. What the step or the class rules lock is not among them.
std::vector<Doable> doables(const AppState& state);

/// Those that a query finds, the best first; all of them, in their order, for an empty one.
std::vector<Doable> found(std::vector<Doable> all, std::string_view query);

}  // namespace halfdisk
