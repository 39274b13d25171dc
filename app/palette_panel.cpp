// How does one find what can be done by typing a part of its name? The list over everything, Ctrl K.
#include <algorithm>

#include "app/doable.h"
#include "app/draw_text.h"
#include "app/fuzzy.h"
#include "app/key_words.h"
#include "app/overlay.h"
#include "app/panels.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

/// A line of words in which some letters are marked; what is too wide is cut.
void markedText(const Ui& ui, ImVec2 at, const std::string& words, const std::vector<std::size_t>& places) {
    drawText(ui, at, ui.palette.ink, words);
    for (const std::size_t place : places) {
        if (place >= words.size()) break;
        const std::size_t length =
            std::max<std::size_t>(characterLength(std::string_view(words).substr(place)), 1);
        const float left = textSize(std::string_view(words).substr(0, place)).x;
        const float width = textSize(std::string_view(words).substr(place, length)).x;
        const float below = at.y + ImGui::GetFontSize() + ui.scale;
        ImGui::GetWindowDrawList()->AddLine({at.x + left, below}, {at.x + left + width, below},
                                            ui.palette.estimate, 2 * ui.scale);
    }
}

void row(const Ui& ui, const Doable& entry, std::size_t index, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool chosen = listRow(ui, entry.name, index == ui.state.palette.selected, width);
    if (chosen) {
        ui.commands.push_back(ShowPalette{false});
        ui.commands.push_back(entry.command);
    }
    const float padding = ImGui::GetStyle().FramePadding.x, top = at.y + ImGui::GetStyle().FramePadding.y;
    const std::string key = keyWords(entry.key);
    const float keyWidth = key.empty() ? 0.0f : textSize(key, ui.fonts.strong).x + 3 * padding;
    const std::string name = firstThatFits({entry.name}, width - 2 * padding - keyWidth);
    markedText(ui, {at.x + padding, top}, name, fuzzyPlaces(ui.state.palette.query, entry.name));
    if (!key.empty())
        drawText(ui, {at.x + width - padding, top}, ui.palette.inkSoft, key, Align::right, ui.fonts.strong);
}

}  // namespace

void paletteOverlay(const Ui& ui) {
    const PaletteState& palette = ui.state.palette;
    const std::vector<Doable> entries = found(doables(ui.state), palette.query);
    const ListOverlay overlay = beginListOverlay(
        ui, {"Commands", "what do you want to do?", palette.query, palette.selected, entries.size()});
    if (overlay.typed) ui.commands.push_back(SetQuery{*overlay.typed});
    if (overlay.selected != palette.selected) ui.commands.push_back(SelectEntry{overlay.selected});
    for (std::size_t i = overlay.first; i < overlay.last; ++i) row(ui, entries[i], i, overlay.width);
    if (entries.empty()) text(ui.widgets, "nothing of that name can be done here");
    endListOverlay(ui, overlay);
    if (overlay.closed || overlay.entered) ui.commands.push_back(ShowPalette{false});
    if (overlay.entered && overlay.selected < entries.size())
        ui.commands.push_back(entries[overlay.selected].command);
}

}  // namespace halfdisk
