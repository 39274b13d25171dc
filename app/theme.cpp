// Which colours and spacings does the screen have?
#include "app/theme.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {

namespace {

double channel(ImU32 color, int shift) {
    return ((color >> shift) & 0xffu) / 255.0;
}

/// sRGB to relative luminance, as WCAG 2 defines it.
double luminance(ImU32 color) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(channel(color, IM_COL32_R_SHIFT)) +
           0.7152 * linear(channel(color, IM_COL32_G_SHIFT)) +
           0.0722 * linear(channel(color, IM_COL32_B_SHIFT));
}

void applyColors(ImGuiStyle& style, const Palette& palette) {
    ImGui::StyleColorsLight(&style);
    const auto set = [&style](ImGuiCol which, ImU32 color, float opacity = 1.0f) {
        style.Colors[which] = ImGui::ColorConvertU32ToFloat4(withOpacity(color, opacity));
    };
    set(ImGuiCol_Text, palette.ink);
    set(ImGuiCol_TextDisabled, palette.inkSoft);
    set(ImGuiCol_WindowBg, palette.background);
    set(ImGuiCol_PopupBg, palette.panel);
    set(ImGuiCol_MenuBarBg, palette.background);
    set(ImGuiCol_Border, palette.wallBack);
    set(ImGuiCol_FrameBg, palette.panel);
    set(ImGuiCol_FrameBgHovered, palette.halfDisk, 0.25f);
    set(ImGuiCol_FrameBgActive, palette.halfDisk, 0.40f);
    set(ImGuiCol_TitleBg, palette.background);
    set(ImGuiCol_TitleBgActive, palette.background);
    set(ImGuiCol_TitleBgCollapsed, palette.background);
    set(ImGuiCol_Button, palette.halfDisk, 0.28f);
    set(ImGuiCol_ButtonHovered, palette.halfDisk, 0.50f);
    set(ImGuiCol_ButtonActive, palette.halfDisk, 0.75f);
    set(ImGuiCol_Header, palette.halfDisk, 0.28f);
    set(ImGuiCol_HeaderHovered, palette.halfDisk, 0.50f);
    set(ImGuiCol_HeaderActive, palette.halfDisk, 0.75f);
    set(ImGuiCol_CheckMark, palette.accent);
    set(ImGuiCol_SliderGrab, palette.knob);
    set(ImGuiCol_SliderGrabActive, palette.knob);
    set(ImGuiCol_Separator, palette.wallBack);
    set(ImGuiCol_ScrollbarBg, palette.grid, 0.5f);
    set(ImGuiCol_ScrollbarGrab, palette.wallBack);
    set(ImGuiCol_TextSelectedBg, palette.halfDisk, 0.45f);
    set(ImGuiCol_NavHighlight, palette.accent);
    set(ImGuiCol_PlotLines, palette.sample);
    set(ImGuiCol_PlotHistogram, palette.estimate);
}

}  // namespace

ImU32 withOpacity(ImU32 color, float opacity) {
    const auto alpha = static_cast<ImU32>(std::lround(255.0f * std::clamp(opacity, 0.0f, 1.0f)));
    return (color & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

void applyTheme(ImGuiStyle& style, float uiScale, const Palette& palette) {
    style = ImGuiStyle();
    applyColors(style, palette);
    style.WindowPadding = ImVec2(14, 12);
    style.FramePadding = ImVec2(10, 7);
    style.ItemSpacing = ImVec2(10, 8);
    style.ItemInnerSpacing = ImVec2(8, 6);
    style.ScrollbarSize = 16;
    style.GrabMinSize = 18;
    style.WindowRounding = 0;
    style.FrameRounding = 5;
    style.GrabRounding = 5;
    style.PopupRounding = 5;
    style.ScrollbarRounding = 8;
    style.WindowBorderSize = 1;
    style.FrameBorderSize = 1;
    style.DisabledAlpha = 0.65f;
    style.ScaleAllSizes(uiScale);
}

}  // namespace halfdisk
