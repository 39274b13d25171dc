// Which widgets are on screen, and where?
#include "app/widgets.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/input_events.h"
#include "app/language.h"
#include "app/line_breaks.h"
#include "lessons/utf8.h"

namespace halfdisk {

namespace {

std::string_view visibleLabel(std::string_view label) {
    const std::size_t mark = label.find("##");
    if (mark == std::string_view::npos) return label;
    return mark > 0 ? label.substr(0, mark) : label.substr(label.find_first_not_of('#'));
}

/// What ImGui is given: the label in the window's language. A widget's identity stays the English one.
std::string spoken(std::string_view label) {
    const std::string_view words = label.substr(0, label.find("##"));
    const std::string_view translated = tr(words);
    if (translated == words) return std::string(label);
    return fmt::format("{}###{}", translated, label);
}

/// A field that is entered anew must not undo what was typed when other words stood in it: Dear ImGui 1.86
/// keeps that history, and its assertions end the program.
void forgetFormerText(const char* label) {
    const ImGuiID id = ImGui::GetID(label);
    ImGuiInputTextState* state = ImGui::GetInputTextState(id);
    if (state && ImGui::GetActiveID() != id) state->ID = 0;
}

/// What a field can hold: Dear ImGui 1.86 counts bytes of what is not UTF-8, or beyond 16 bits, wrongly, and
/// its assertions end the program when they are deleted. Such characters become U+FFFD.
std::string editable(std::string_view text) {
    std::string held;
    for (text = text.substr(0, text.find('\0')); !text.empty();) {
        constexpr std::size_t kMostBytes = 3;
        const std::size_t length = characterLength(text);
        held += length == 0 || length > kMostBytes ? std::string_view("\uFFFD") : text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return held;
}

Rect toRect(ImVec2 min, ImVec2 max) {
    return {min.x, min.y, max.x, max.y};
}

std::string_view currentWindow() {
    return visibleLabel(ImGui::GetCurrentWindowRead()->RootWindow->Name);
}

void note(WidgetRegistry& registry, std::string_view window, std::string_view label, const Rect& rect,
          const Rect& target, WidgetKind kind) {
    const ImRect& clip = ImGui::GetCurrentWindowRead()->ClipRect;
    Widget widget;
    widget.window = window;
    widget.name = widget.window + "/" + std::string(visibleLabel(label));
    widget.kind = kind;
    widget.rect = rect;
    widget.target = intersection(target, toRect(clip.Min, clip.Max));
    widget.enabled = (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) == 0;
    registry.rects[widget.name] = widget.target;
    registry.widgets.push_back(std::move(widget));
}

void noteItem(WidgetRegistry& registry, std::string_view window, std::string_view label, WidgetKind kind) {
    const Rect rect = toRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    note(registry, window, label, rect, rect, kind);
}

/// For items with a frame of `width` that reacts, and a label on its right that does not.
void noteFramed(WidgetRegistry& registry, std::string_view label, float width, WidgetKind kind) {
    const Rect rect = toRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    Rect target = rect;
    target.right = std::min(rect.right, rect.left + width);
    note(registry, currentWindow(), label, rect, target, kind);
}

ImGuiSliderFlags sliderFlags(bool logarithmic) {
    return ImGuiSliderFlags_AlwaysClamp |
           (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
}

}  // namespace

Rect intersection(const Rect& a, const Rect& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

bool overlap(const Rect& a, const Rect& b) {
    const Rect both = intersection(a, b);
    return both.width() > 0 && both.height() > 0;
}

void WidgetRegistry::beginFrame() {
    widgets.clear();
    rects.clear();
}

const Widget* WidgetRegistry::find(std::string_view name) const {
    const auto last =
        std::find_if(widgets.rbegin(), widgets.rend(), [&](const Widget& w) { return w.name == name; });
    return last == widgets.rend() ? nullptr : &*last;
}

void mark(WidgetRegistry& registry, std::string_view label, ImVec2 min, ImVec2 max, WidgetKind kind) {
    note(registry, currentWindow(), label, toRect(min, max), toRect(min, max), kind);
}

void markItem(WidgetRegistry& registry, std::string_view label, WidgetKind kind) {
    noteItem(registry, currentWindow(), label, kind);
}

void text(WidgetRegistry& registry, std::string_view words) {
    const std::string_view shown = tr(words);
    ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
    markItem(registry, words, WidgetKind::text);
}

void textWrapped(WidgetRegistry& registry, std::string_view words) {
    const std::string lines = brokenInto(tr(words), ImGui::GetContentRegionAvail().x);
    ImGui::PushTextWrapPos(0.0f);  // for a word that is wider than all of it
    ImGui::TextUnformatted(lines.data(), lines.data() + lines.size());
    ImGui::PopTextWrapPos();
    markItem(registry, words, WidgetKind::text);
}

bool button(WidgetRegistry& registry, const char* label, ImVec2 size) {
    const bool clicked = ImGui::Button(spoken(label).c_str(), size);
    markItem(registry, label, WidgetKind::button);
    return clicked;
}

bool checkbox(WidgetRegistry& registry, const char* label, bool& value) {
    const bool changed = ImGui::Checkbox(spoken(label).c_str(), &value);
    markItem(registry, label, WidgetKind::checkbox);
    return changed;
}

bool toggle(WidgetRegistry& registry, const char* label, bool& value, ImVec2 size) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleColor(ImGuiCol_Button, style.Colors[value ? ImGuiCol_ButtonActive : ImGuiCol_FrameBg]);
    const bool clicked = ImGui::Button(spoken(label).c_str(), size);
    ImGui::PopStyleColor();
    markItem(registry, label, WidgetKind::toggle);
    if (clicked) value = !value;
    return clicked;
}

bool combo(WidgetRegistry& registry, const char* label, int& index, std::span<const std::string_view> names) {
    const bool valid = index >= 0 && static_cast<std::size_t>(index) < names.size();
    const std::string preview(valid ? tr(names[static_cast<std::size_t>(index)]) : std::string_view{});
    const std::string window(currentWindow());
    const float width = ImGui::CalcItemWidth();
    const bool open =
        ImGui::BeginCombo(spoken(label).c_str(), preview.c_str(), ImGuiComboFlags_HeightLargest);
    if (!open) {
        noteFramed(registry, label, width, WidgetKind::combo);
        return false;
    }
    bool changed = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool selected = static_cast<std::size_t>(index) == i;
        const std::string option(names[i]);
        if (ImGui::Selectable(spoken(option).c_str(), selected) && !selected) {
            index = static_cast<int>(i);
            changed = true;
        }
        noteItem(registry, window, std::string(visibleLabel(label)) + "/" + option, WidgetKind::option);
        if (selected) ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
    noteFramed(registry, label, width, WidgetKind::combo);
    return changed;
}

bool sliderInt(WidgetRegistry& registry, const char* label, int& value, int least, int most, bool logarithmic,
               const char* format) {
    const float width = ImGui::CalcItemWidth();
    bool changed;
    {
        const CtrlHeld typing(ImGui::GetIO(), ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
        changed =
            ImGui::SliderInt(spoken(label).c_str(), &value, least, most, format, sliderFlags(logarithmic));
    }
    noteFramed(registry, label, width, WidgetKind::slider);
    return changed;
}

bool dragScalar(WidgetRegistry& registry, const char* label, ImGuiDataType type, void* value,
                const void* least, const void* most, float speed, const char* format, bool logarithmic) {
    const float width = ImGui::CalcItemWidth();
    const std::string name = spoken(label);
    forgetFormerText(name.c_str());
    const bool changed =
        ImGui::DragScalar(name.c_str(), type, value, speed, least, most, format, sliderFlags(logarithmic));
    noteFramed(registry, label, width, WidgetKind::number);
    return changed;
}

bool inputText(WidgetRegistry& registry, const char* label, std::string& value) {
    const float width = ImGui::CalcItemWidth();
    const std::string name = spoken(label);
    forgetFormerText(name.c_str());
    std::string held = editable(value);
    const bool changed = ImGui::InputText(name.c_str(), &held);
    if (changed) value = held;
    noteFramed(registry, label, width, WidgetKind::input);
    return changed;
}

bool inputTextAtEnd(WidgetRegistry& registry, const char* label, std::string& value) {
    const float width = ImGui::CalcItemWidth();
    bool entering = !ImGui::IsAnyItemActive();
    forgetFormerText(label);
    const auto toEnd = [](ImGuiInputTextCallbackData* data) {
        if (!*static_cast<const bool*>(data->UserData)) return 0;
        data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
        return 0;
    };
    std::string held = editable(value);
    const bool changed = ImGui::InputText(label, &held, ImGuiInputTextFlags_CallbackAlways, toEnd, &entering);
    if (changed) value = held;
    noteFramed(registry, label, width, WidgetKind::input);
    return changed;
}

bool inputTextEntered(WidgetRegistry& registry, const char* label, std::string& value) {
    const float width = ImGui::CalcItemWidth();
    forgetFormerText(label);
    std::string held = editable(value);
    const bool entered = ImGui::InputText(label, &held, ImGuiInputTextFlags_EnterReturnsTrue);
    if (held != editable(value)) value = held;
    noteFramed(registry, label, width, WidgetKind::input);
    return entered;
}

void tooltipWords(std::string_view words, float ems) {
    const float width = ems * ImGui::GetFontSize();
    const std::string lines = brokenInto(words, width);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(lines.data(), lines.data() + lines.size());
    ImGui::PopTextWrapPos();
}

void tooltip(std::string_view words) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    tooltipWords(tr(words), 24.0f);
    ImGui::EndTooltip();
}

}  // namespace halfdisk
