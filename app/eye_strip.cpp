// What does the scene's eye see? A strip of pixels below the canvas, the leftmost on the left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/picture_stages.h"
#include "app/plot_words.h"
#include "app/shown_pictures.h"

namespace halfdisk {
namespace {

constexpr float kStripHeight = 36;  // design pixels

/// Why there is no strip yet, or never.
std::string whyEmpty(const AppState& state, const LightPicture* picture) {
    if (!state.scene->scene.eye) return "this scene has no eye";
    return picture && !picture->refusal.empty() ? picture->refusal : "being computed";
}

struct Row {
    const LightPicture* picture;  ///< null: none yet
    std::string maker;            ///< empty: the usual one
    std::string difference;       ///< from the other one
    const char* name;             ///< of the widget
};

/// One strip, or two below each other.
std::vector<Row> rowsOf(const AppState& state) {
    const Maker first = state.makers.first.value_or(usualMaker(View::eye));
    const Maker* second = state.makers.second ? &*state.makers.second : nullptr;
    std::vector<Row> rows{{state.answer ? state.answer->pictures.eye.get() : nullptr,
                           state.makers.first ? makerTitle(first, second) : "",
                           second ? differenceOf(first, *second) : "", "eye strip"}};
    if (second)
        rows.push_back({state.answer ? state.answer->against.eye.get() : nullptr, makerTitle(*second, &first),
                        differenceOf(*second, first), "eye strip B"});
    return rows;
}

void drawStrip(const Ui& ui, const LightPicture& picture, ImVec2 min, ImVec2 max) {
    const Pen list = penOf(ui);
    const auto count = static_cast<float>(picture.colors.size());
    const auto edge = [&](std::size_t pixel) {
        return std::round(min.x + (max.x - min.x) * static_cast<float>(pixel) / count);
    };
    // To the sheet as a picture one pixel high.
    if (list.drawing)
        list.drawing->cells(min, max, picture.colors, static_cast<std::uint32_t>(picture.colors.size()),
                            1.0f);
    for (std::size_t i = 0; i < picture.colors.size(); ++i)
        list.screen.AddRectFilled({edge(i), min.y}, {edge(i + 1), max.y}, picture.colors[i]);
    if (const auto pinned = ui.state.pinnedPixel; pinned && *pinned < picture.colors.size()) {
        const float left = edge(*pinned) - 2 * ui.scale, right = edge(*pinned + 1) + 2 * ui.scale;
        const float middle = (left + right) / 2, head = 6 * ui.scale;
        list.AddRect({left - ui.scale, min.y}, {right + ui.scale, max.y}, ui.palette.panel, 0.0f,
                     ImDrawFlags_None, 4 * ui.scale);
        list.AddRect({left, min.y}, {right, max.y}, ui.palette.point, 0.0f, ImDrawFlags_None, 2 * ui.scale);
        list.AddTriangleFilled({middle - head, min.y - head}, {middle + head, min.y - head},
                               {middle, min.y + head}, ui.palette.point);
    }
    if (!ui.state.eyePixel || *ui.state.eyePixel >= picture.colors.size()) return;
    list.AddRect({edge(*ui.state.eyePixel) - 2 * ui.scale, min.y},
                 {edge(*ui.state.eyePixel + 1) + 2 * ui.scale, max.y}, ui.palette.accent, 0.0f,
                 ImDrawFlags_None, 2 * ui.scale);
}

/// The pixel under the pointer, which tells its value.
std::optional<std::uint32_t> pointed(const Ui& ui, const LightPicture* picture, ImVec2 min, ImVec2 max) {
    if (!picture || !ImGui::IsItemHovered()) return std::nullopt;
    const auto count = static_cast<float>(picture->colors.size());
    const float share = (ImGui::GetIO().MousePos.x - min.x) / (max.x - min.x);
    const auto pixel = static_cast<std::uint32_t>(std::clamp(share * count, 0.0f, count - 1.0f));
    const Statistics& value = picture->film.pixels[pixel];
    tooltip(say("pixel {}: L = {} \u00b1 {:.1g} W/(m rad)\n{} passes\n{}", pixel, shown(value.mean),
                gray(value.standardError()), picture->film.passes,
                tr(ui.state.pinnedPixel == pixel ? "click: back to P" : "click: every path of this pixel")));
    return pixel;
}

float rowHeight(const Ui& ui) {
    return ImGui::GetFontSize() + (kStripHeight + 4) * ui.scale;
}

std::optional<std::uint32_t> drawRow(const Ui& ui, const Row& row, float width) {
    const LightPicture* picture = row.picture && !row.picture->colors.empty() ? row.picture : nullptr;
    const ImVec2 origin = ImGui::GetCursorScreenPos(), size{width, rowHeight(ui)};
    const bool clicked = ImGui::InvisibleButton(row.name, size);
    mark(ui.widgets, row.name, origin, {origin.x + size.x, origin.y + size.y});
    const ImVec2 min{origin.x, origin.y + ImGui::GetFontSize() + 4 * ui.scale},
        max{origin.x + size.x, origin.y + size.y};
    const std::optional<std::uint32_t> pixel = pointed(ui, picture, min, max);
    if (clicked && pixel)
        ui.commands.push_back(PinPixel{pixel == ui.state.pinnedPixel ? std::nullopt : pixel});

    const std::string what = drawingTitle(ui.state, "eye");
    const std::string words = row.maker.empty()
                                  ? what
                                  : firstThatFits({fmt::format("{}: {}", tr(what), row.maker), row.maker,
                                                   row.difference.empty() ? row.maker : row.difference},
                                                  width);
    const ImVec2 title = drawText(ui, origin, ui.palette.inkSoft, words);
    const Pen list = penOf(ui);
    if (picture) {
        const std::string white =
            picture->white > 0.0 ? say("white: \u2265 {} W/(m rad)", shown(picture->white)) : "all black";
        if (title.x + textSize(white).x + 12 * ui.scale < width)
            drawText(ui, {max.x, origin.y}, ui.palette.inkSoft, white, Align::right);
        drawStrip(ui, *picture, min, max);
    } else {
        list.AddRectFilled(min, max, ui.palette.panel);
        drawText(ui, {(min.x + max.x) / 2, (min.y + max.y - ImGui::GetFontSize()) / 2}, ui.palette.inkSoft,
                 whyEmpty(ui.state, row.picture), Align::middle);
    }
    list.AddRect(min, max, ui.palette.wallBack);
    return pixel;
}

}  // namespace

float eyeStripHeight(const Ui& ui) {
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    return ui.state.makers.second ? 2 * rowHeight(ui) + gap : rowHeight(ui);
}

void eyeStrip(const Ui& ui, float width) {
    std::optional<std::uint32_t> pixel;
    const OnSheet drawing(ui, "eye", {width, eyeStripHeight(ui)});
    for (const Row& row : rowsOf(ui.state))
        if (const auto under = drawRow(ui, row, width)) pixel = under;
    // It lights up on the canvas.
    if (pixel != ui.state.eyePixel) ui.commands.push_back(LookAlong{pixel});
}

}  // namespace halfdisk
