#include "app/overlay.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/imgui_compat.h"

namespace halfdisk {
namespace {

constexpr float kMostWidth = 680, kMostHeight = 460;  // design pixels, at most

/// Darkens all that lies below, and catches its clicks.
void beginShade(const Ui& ui, const char* window) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize(screen);
    // Only once: it would cancel what is asked of the field.
    const ImGuiWindow* front = ImGui::GetCurrentContext()->NavWindow;
    if (front == nullptr || front->RootWindow->Name != std::string_view(window)) ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(window, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse |
                     ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    ImGui::GetWindowDrawList()->AddRectFilled({0, 0}, screen, withOpacity(ui.palette.ink, 0.35f));
}

/// Up, Down, Page Up, Page Down.
std::size_t moved(std::size_t selected, std::size_t count, std::size_t page) {
    if (count == 0) return 0;
    selected = std::min(selected, count - 1);
    if (keyPressed(Key::down)) selected = selected + 1 < count ? selected + 1 : 0;
    if (keyPressed(Key::up)) selected = selected > 0 ? selected - 1 : count - 1;
    if (keyPressed(Key::pageDown)) selected = std::min(selected + page, count - 1);
    if (keyPressed(Key::pageUp)) selected -= std::min(selected, page);
    return selected;
}

}  // namespace

ListOverlay beginListOverlay(const Ui& ui, const ListRequest& request) {
    ListOverlay overlay;
    overlay.count = request.count;
    overlay.note = request.note;
    beginShade(ui, request.window);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    // Whole rows only.
    const float line = ImGui::GetFrameHeight();
    const float footer = request.note.empty() ? 0.0f : ImGui::GetTextLineHeightWithSpacing();
    const float around = 2 * ImGui::GetStyle().WindowPadding.y + ImGui::GetFrameHeightWithSpacing() + footer;
    const float most = std::min(0.9f * screen.y, kMostHeight * ui.scale);
    const ImVec2 size{std::floor(std::min(0.94f * screen.x, kMostWidth * ui.scale)),
                      around + line * std::max(std::floor((most - around) / line), 1.0f)};
    const ImVec2 corner{std::floor((screen.x - size.x) / 2), std::floor((screen.y - size.y) / 3)};
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.palette.panel);
    beginChild("box", size, true);
    ImGui::PopStyleColor();
    // The first press may still be the one that opened it: what is active then is not ours.
    const bool outside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsMouseHoveringRect(corner, {corner.x + size.x, corner.y + size.y}, false);
    overlay.closed = outside || keyPressed(Key::escape, false);
    overlay.entered = keyPressed(Key::enter, false) || keyPressed(Key::keypadEnter, false);
    overlay.completed = keyPressed(Key::tab, false);

    if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    std::string typed = request.text;
    if (inputTextAtEnd(ui.widgets, "##field", typed) && typed != request.text && !overlay.closed)
        overlay.typed = typed;
    if (request.text.empty() && typed.empty()) {
        const ImVec2 at = ImGui::GetItemRectMin(), padding = ImGui::GetStyle().FramePadding;
        ImGui::GetWindowDrawList()->AddText({at.x + padding.x, at.y + padding.y}, ui.palette.inkSoft,
                                            request.hint.data(), request.hint.data() + request.hint.size());
    }

    beginChild("list", {0, -footer}, false);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const float height = ImGui::GetWindowHeight();
    overlay.selected =
        moved(request.selected, request.count, static_cast<std::size_t>(std::max(height / line - 1, 1.0f)));
    // The wheel may lead away from the selected row; a key leads back to it.
    if (overlay.selected != request.selected || overlay.typed) {
        const float top = line * static_cast<float>(overlay.typed ? 0 : overlay.selected);
        const float scroll = ImGui::GetScrollY();
        if (top < scroll || overlay.typed) ImGui::SetScrollY(top);
        if (top + line > scroll + height) ImGui::SetScrollY(top + line - height);
    }
    overlay.width = ImGui::GetContentRegionAvail().x;
    const auto rows = static_cast<float>(request.count);
    overlay.first = static_cast<std::size_t>(std::clamp(ImGui::GetScrollY() / line, 0.0f, rows));
    overlay.last = static_cast<std::size_t>(
        std::clamp(std::ceil((ImGui::GetScrollY() + height) / line) + 1.0f, 0.0f, rows));
    const float start = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(start + rows * line);
    ImGui::Dummy({1, 0});  // so that all rows have their place
    ImGui::SetCursorPosY(start + static_cast<float>(overlay.first) * line);
    return overlay;
}

void refillField() {
    ImGui::ClearActiveID();
}

bool listRow(const Ui& ui, std::string_view name, bool selected, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), size{width, ImGui::GetFrameHeight()};
    ImGui::PushID(name.data(), name.data() + name.size());
    const bool clicked = ImGui::InvisibleButton("row", size);
    ImGui::PopID();
    if (selected || ImGui::IsItemHovered())
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y},
                                                  selected ? ui.palette.currentLine : ui.palette.grid);
    markItem(ui.widgets, std::string("##") + std::string(name), WidgetKind::option);
    return clicked;
}

void endListOverlay(const Ui& ui, const ListOverlay& overlay) {
    ImGui::PopStyleVar();
    ImGui::EndChild();
    if (!overlay.note.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
        const float width = ImGui::GetContentRegionAvail().x;
        text(ui.widgets, firstThatFits({overlay.note}, width));
        ImGui::PopStyleColor();
    }
    ImGui::EndChild();
    ImGui::End();
}

}  // namespace halfdisk
