// How is one entry of a table chosen? By a list of their names, with the chosen one's meaning on hover.
#pragma once

#include <array>

#include "app/panels.h"
#include "core/settings.h"

namespace halfdisk {

/// True when changed.
template <class Enum, std::size_t Count>
bool choose(const Ui& ui, const char* label, const std::array<Named<Enum>, Count>& table, Enum& value) {
    std::array<std::string_view, Count> names;
    int index = 0;
    for (std::size_t i = 0; i < Count; ++i) {
        names[i] = table[i].name;
        if (table[i].value == value) index = static_cast<int>(i);
    }
    const bool changed = combo(ui.widgets, label, index, names);
    tooltip(table[static_cast<std::size_t>(index)].meaning);
    if (changed) value = table[static_cast<std::size_t>(index)].value;
    return changed;
}

}  // namespace halfdisk
