// How are words put at a place of one's own choice, so that a test still sees them?
#pragma once

#include <imgui.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "app/frame.h"

namespace halfdisk {

/// Where the given point lies in the text: its left end, middle or right end.
enum class Align : std::uint8_t { left, middle, right };

/// Words are given in English here and shown in the window's language.

/// One line in `font` (null: the current one), its top at `at`. Registered as a text. Returns its size.
ImVec2 drawText(const Ui& ui, ImVec2 at, ImU32 color, std::string_view words, Align align = Align::left,
                ImFont* font = nullptr);

/// The next button with this label goes beside the last item if there is room, else below it.
void sameLineIfFits(std::string_view label, float width = 0.0f);

/// The width of each of so many that share a row.
float partOfRow(int count);

ImVec2 textSize(std::string_view words, ImFont* font = nullptr);

/// The first of these words that are no wider than `width`; else the last, cut to as many as are.
std::string firstThatFits(std::initializer_list<std::string_view> words, float width, ImFont* font = nullptr);

/// A number as it is shown: four significant digits, no needless zeros.
std::string shown(double value);

/// Whether all channels agree.
bool isGray(const Rgb& value);

/// A colour as it is shown: one number if its channels agree, else three.
std::string shown(const Rgb& value);

}  // namespace halfdisk
