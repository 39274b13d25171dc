// What does the scene's eye see? A strip of pixels below the canvas, the leftmost on the left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

constexpr float kStripHeight = 36;  // design pixels
constexpr const char* kTitle = "What the eye sees";

/// Why there is no strip yet, or never.
std::string whyEmpty(const AppState& state) {
    if (!state.scene->scene.eye) return "this scene has no eye";
    const auto& picture = state.answer ? state.answer->eye : nullptr;
    return picture && !picture->refusal.empty() ? picture->refusal : "being computed";
}

void drawStrip(const Ui& ui, const LightPicture& picture, ImVec2 min, ImVec2 max) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto count = static_cast<float>(picture.colors.size());
    const auto edge = [&](std::size_t pixel) {
        return std::round(min.x + (max.x - min.x) * static_cast<float>(pixel) / count);
    };
    for (std::size_t i = 0; i < picture.colors.size(); ++i)
        list.AddRectFilled({edge(i), min.y}, {edge(i + 1), max.y}, picture.colors[i]);
    if (!ui.state.eyePixel || *ui.state.eyePixel >= picture.colors.size()) return;
    list.AddRect({edge(*ui.state.eyePixel) - 2 * ui.scale, min.y},
                 {edge(*ui.state.eyePixel + 1) + 2 * ui.scale, max.y}, ui.palette.accent, 0.0f,
                 ImDrawFlags_None, 2 * ui.scale);
}

/// The pixel under the pointer lights up on the canvas, and tells its value.
void point(const Ui& ui, const LightPicture* picture, ImVec2 min, ImVec2 max) {
    std::optional<std::uint32_t> pixel;
    if (picture && ImGui::IsItemHovered()) {
        const auto count = static_cast<float>(picture->colors.size());
        const float share = (ImGui::GetIO().MousePos.x - min.x) / (max.x - min.x);
        pixel = static_cast<std::uint32_t>(std::clamp(share * count, 0.0f, count - 1.0f));
        const Statistics& value = picture->film.pixels[*pixel];
        tooltip(fmt::format("L = {} \u00b1 {:.1g} W/(m rad)\n{} passes", shown(value.mean),
                            gray(value.standardError()), picture->film.passes));
    }
    if (pixel != ui.state.eyePixel) ui.commands.push_back(LookAlong{pixel});
}

}  // namespace

float eyeStripHeight(const Ui& ui) {
    return ImGui::GetFontSize() + (kStripHeight + 4) * ui.scale;
}

void eyeStrip(const Ui& ui, float width) {
    const AppState& state = ui.state;
    const LightPicture* picture = state.answer ? state.answer->eye.get() : nullptr;
    if (picture && picture->colors.empty()) picture = nullptr;
    const ImVec2 origin = ImGui::GetCursorScreenPos(), size{width, eyeStripHeight(ui)};
    ImGui::InvisibleButton("eye strip", size);
    mark(ui.widgets, "eye strip", origin, {origin.x + size.x, origin.y + size.y});
    const ImVec2 min{origin.x, origin.y + ImGui::GetFontSize() + 4 * ui.scale},
        max{origin.x + size.x, origin.y + size.y};
    point(ui, picture, min, max);

    const ImVec2 title = drawText(ui, origin, ui.palette.inkSoft, kTitle);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (picture) {
        const std::string white = fmt::format("white: \u2265 {} W/(m rad)", shown(picture->white));
        if (title.x + textSize(white).x + 12 * ui.scale < width)
            drawText(ui, {max.x, origin.y}, ui.palette.inkSoft, white, Align::right);
        drawStrip(ui, *picture, min, max);
    } else {
        list.AddRectFilled(min, max, ui.palette.panel);
        drawText(ui, {(min.x + max.x) / 2, (min.y + max.y - ImGui::GetFontSize()) / 2}, ui.palette.inkSoft,
                 whyEmpty(state), Align::middle);
    }
    list.AddRect(min, max, ui.palette.wallBack);
}

}  // namespace halfdisk
