// Which of the allowed names did the writer mean?
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfdisk {

/// Edit distance in bytes (insertions, deletions, substitutions, swaps of neighbours), ASCII case ignored.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate closest to `name` if it is close enough to be a slip of the pen, else empty.
std::string_view nearestName(std::string_view name, const std::vector<std::string_view>& candidates);

/// `expected one of "a", "b" or "c"`, with `; did you mean "b"?` if one is close. Long lists are cut.
std::string expectedOneOf(std::string_view name, const std::vector<std::string_view>& candidates);

/// The names of a table of Named<Enum>.
template <class Table>
std::vector<std::string_view> namesOf(const Table& table) {
    std::vector<std::string_view> names;
    for (const auto& entry : table) names.push_back(entry.name);
    return names;
}

}  // namespace halfdisk
