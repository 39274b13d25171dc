// How is one of many chosen by typing? A field and the list that it finds, over everything else.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/frame.h"

namespace halfdisk {

struct ListRequest {
    const char* window;     ///< its widgets are "window/field" and "window/ROW"
    std::string_view hint;  ///< in the empty field
    const std::string& text;
    std::size_t selected;
    std::size_t count;           ///< of rows
    std::string_view note = {};  ///< below the list
};

struct ListOverlay {
    std::optional<std::string> typed;  ///< the field's new text
    std::size_t selected = 0;          ///< after the arrow keys
    bool entered = false;              ///< the selected one is wanted
    bool completed = false;            ///< Tab: its name is wanted in the field
    bool closed = false;
    std::size_t first = 0, last = 0;  ///< rows in sight: draw these
    float width = 0.0f;               ///< of a row, pixels
    std::string_view note;
    std::size_t count = 0;
};

/// Draw the rows in sight with listRow after it, then call endListOverlay.
ListOverlay beginListOverlay(const Ui& ui, const ListRequest& request);
void endListOverlay(const Ui& ui, const ListOverlay& overlay);

/// The field shows the state's text again, which a command has changed, and not what it holds itself.
void refillField();

/// A row's ground, and what it is called. True if it is clicked. Its words are drawn by the caller.
bool listRow(const Ui& ui, std::string_view name, bool selected, float width);

}  // namespace halfdisk
