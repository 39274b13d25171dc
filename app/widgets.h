// Which widgets are on screen, and where? Thin wrappers over Dear ImGui that note it, so that a test can
// click and drag by name and check that no texts overlap.
//
// A widget's name is "window/label": the window is the root window's title (a child's widgets count for its
// root), the label is what is seen of it, or what follows "##" if nothing is seen. "Controls/N",
// "Lesson/Next".
#pragma once

#include <imgui.h>

#include <concepts>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace halfdisk {

/// Pixels, from the left upper corner of the screen.
struct Rect {
    float left = 0, top = 0, right = 0, bottom = 0;

    float centerX() const { return (left + right) / 2; }
    float centerY() const { return (top + bottom) / 2; }
    float width() const { return right - left; }
    float height() const { return bottom - top; }
    bool operator==(const Rect&) const = default;
};

/// What both cover; of no extent (right <= left or bottom <= top) if they are apart.
Rect intersection(const Rect& a, const Rect& b);
/// Whether they share more than their borders.
bool overlap(const Rect& a, const Rect& b);

enum class WidgetKind : std::uint8_t {
    text,
    button,
    checkbox,
    toggle,
    combo,
    option,
    number,
    slider,
    input,
    area
};

struct Widget {
    std::string name;    ///< "window/label"
    std::string window;  ///< title of the root window
    WidgetKind kind = WidgetKind::area;
    Rect rect;            ///< as laid out, label included
    Rect target;          ///< the part of `rect` that reacts to the pointer and that its window does not clip
    bool enabled = true;  ///< false within ImGui::BeginDisabled
};

/// What the last frame showed. The frame function clears it first and passes it to every widget.
struct WidgetRegistry {
    std::vector<Widget> widgets;        ///< in drawing order; several texts may have the same name
    std::map<std::string, Rect> rects;  ///< Widget::target by name; the last one drawn under it

    void beginFrame();
    /// Null if the last frame did not show it.
    const Widget* find(std::string_view name) const;
};

/// Notes an item that something else drew, such as a canvas. `kind` text takes part in the check for
/// overlaps.
void mark(WidgetRegistry& registry, std::string_view label, ImVec2 min, ImVec2 max,
          WidgetKind kind = WidgetKind::area);
/// The same for the item that ImGui added last.
void markItem(WidgetRegistry& registry, std::string_view label, WidgetKind kind = WidgetKind::area);

void text(WidgetRegistry& registry, std::string_view words);
void textWrapped(WidgetRegistry& registry, std::string_view words);

/// True in the frame in which it is clicked. Size 0: as large as its label needs.
bool button(WidgetRegistry& registry, const char* label, ImVec2 size = {0, 0});
/// True when changed, as all below.
bool checkbox(WidgetRegistry& registry, const char* label, bool& value);
/// A button that stays down.
bool toggle(WidgetRegistry& registry, const char* label, bool& value, ImVec2 size = {0, 0});
/// `index` counts in `names`. While open, its options are named "window/label/option", all under the combo's
/// own window.
bool combo(WidgetRegistry& registry, const char* label, int& index, std::span<const std::string_view> names);
/// Dragged; typed exactly after Ctrl+click or a double click. Stays within [least, most].
bool sliderInt(WidgetRegistry& registry, const char* label, int& value, int least, int most,
               bool logarithmic = false, const char* format = "%d");
/// One line. True with each change.
bool inputText(WidgetRegistry& registry, const char* label, std::string& value);

/// The same, with the cursor behind the last letter whenever the field is entered.
bool inputTextAtEnd(WidgetRegistry& registry, const char* label, std::string& value);
/// The same; true only with Enter.
bool inputTextEntered(WidgetRegistry& registry, const char* label, std::string& value);

template <class Number>
struct DragRange {
    Number least, most;
    float speed = 1.0f;  ///< change per pixel; where logarithmic, of the whole range as if it were linear
    const char* format = nullptr;  ///< as for printf; null: ImGui's for the type
    bool logarithmic = false;
};

bool dragScalar(WidgetRegistry& registry, const char* label, ImGuiDataType type, void* value,
                const void* least, const void* most, float speed, const char* format, bool logarithmic);

/// Dragged sideways; typed exactly after Ctrl+click or a double click. Stays within the range, also when
/// typed. Number: int32, uint32, int64, uint64, float or double.
template <class Number>
requires std::floating_point<Number> ||
    (std::integral<Number> && sizeof(Number) >= 4) bool dragNumber(WidgetRegistry& registry,
                                                                   const char* label, Number& value,
                                                                   const DragRange<Number>& range) {
    constexpr ImGuiDataType type = std::is_same_v<Number, float>    ? ImGuiDataType_Float
                                   : std::is_same_v<Number, double> ? ImGuiDataType_Double
                                   : sizeof(Number) == 8
                                       ? (std::is_signed_v<Number> ? ImGuiDataType_S64 : ImGuiDataType_U64)
                                       : (std::is_signed_v<Number> ? ImGuiDataType_S32 : ImGuiDataType_U32);
    return dragScalar(registry, label, type, &value, &range.least, &range.most, range.speed, range.format,
                      range.logarithmic);
}

/// Words across so many ems of the current font, in a tooltip that has begun.
void tooltipWords(std::string_view words, float ems);

/// Explains the item added last while the pointer rests on it, also if it is disabled.
void tooltip(std::string_view words);

}  // namespace halfdisk
