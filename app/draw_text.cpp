#include "app/draw_text.h"

#include <fmt/format.h>

#include <cmath>

#include "app/language.h"
#include "app/pen.h"

namespace halfdisk {

ImVec2 textSize(std::string_view english, ImFont* font) {
    const std::string_view words = tr(english);
    ImFont* used = font ? font : ImGui::GetFont();
    return used->CalcTextSizeA(used->FontSize, FLT_MAX, 0.0f, words.data(), words.data() + words.size());
}

ImVec2 drawText(const Ui& ui, ImVec2 at, ImU32 color, std::string_view english, Align align, ImFont* font) {
    const std::string_view words = tr(english);
    ImFont* used = font ? font : ImGui::GetFont();
    const ImVec2 size = textSize(words, used);
    if (align == Align::middle) at.x -= size.x / 2;
    if (align == Align::right) at.x -= size.x;
    at = {std::floor(at.x), std::floor(at.y)};
    ImGui::GetWindowDrawList()->AddText(used, used->FontSize, at, color, words.data(),
                                        words.data() + words.size());
    if (SvgDrawing* drawing = penOf(ui).drawing) {
        const TypeFace face = faceOf(ui.fonts, used);
        drawing->text({at.x, at.y + face.ascent}, size.x, color, words, face);
    }
    mark(ui.widgets, words, at, {at.x + size.x, at.y + size.y}, WidgetKind::text);
    return size;
}

std::string shown(double value) {
    if (value == 0.0) return "0";
    return local(fmt::format("{:.4g}", value));
}

void sameLineIfFits(std::string_view label, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float needed = width > 0.0f ? width : textSize(label).x + 2 * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + needed <= right + 0.5f) ImGui::SameLine();
}

float partOfRow(int count) {
    const float all = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
    return (all - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
}

bool isGray(const Rgb& value) {
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
    return same(value.x, value.y) && same(value.x, value.z);
}

std::string shown(const Rgb& value) {
    if (isGray(value)) return shown(value.x);
    return local(fmt::format("{:.3g}, {:.3g}, {:.3g}", value.x, value.y, value.z));
}

std::string firstThatFits(std::initializer_list<std::string_view> words, float width, ImFont* font) {
    for (const std::string_view candidate : words)
        if (textSize(candidate, font).x <= width) return std::string(tr(candidate));
    std::string shorter(words.size() > 0 ? tr(*(words.end() - 1)) : std::string_view());
    while (!shorter.empty() && textSize(shorter + "\u2026", font).x > width) {
        do shorter.pop_back();
        while (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0xC0u) == 0x80u);
        if (!shorter.empty() && static_cast<unsigned char>(shorter.back()) >= 0xC0u) shorter.pop_back();
    }
    return shorter.empty() ? shorter : shorter + "\u2026";
}

}  // namespace halfdisk
