// What does the scene's eye see? A strip of pixels below the canvas, the leftmost on the left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/light_progress.h"
#include "app/message_words.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/picture_stages.h"
#include "app/plot_words.h"
#include "app/shown_pictures.h"
#include "app/strip_difference.h"

namespace halfdisk {
namespace {

constexpr float kStripHeight = 36, kDifferenceHeight = 14;  // design pixels

/// Why there is no strip yet, or never.
std::string whyEmpty(const AppState& state, const LightPicture* picture) {
    if (!state.scene->scene.eye) return "this scene has no eye";
    return picture && !picture->refusal.empty() ? trMessage(picture->refusal) : "being computed";
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
    const LightPicture* picture = state.answer ? state.answer->pictures.eye.get() : nullptr;
    if (!state.makers.second)
        return {{picture, state.makers.first ? makerTitle(first, nullptr) : "", "", "eye strip"}};
    const Maker& second = *state.makers.second;
    const auto named = [](Side side, const std::string& words) {
        return words.empty() ? "" : fmt::format("{}: {}", nameOf(kSides, side), words);
    };
    return {{picture, named(Side::first, makerTitle(first, &second)),
             named(Side::first, differenceOf(first, second)), "eye strip"},
            {state.answer ? state.answer->against.eye.get() : nullptr,
             named(Side::second, makerTitle(second, &first)),
             named(Side::second, differenceOf(second, first)), "eye strip B"}};
}

/// The exact strip is shown as well, where the scene has one.
bool hasExactRow(const AppState& state) {
    return state.shows(View::difference) && state.scene->scene.eye && state.scene->visibility;
}

float rowHeight(const Ui& ui, bool withDifference) {
    return ImGui::GetFontSize() + (kStripHeight + 4 + (withDifference ? kDifferenceHeight : 0)) * ui.scale;
}

/// Where the strip of a row lies: below its words.
struct Place {
    ImVec2 min, max;
};

Place stripPlace(const Ui& ui, ImVec2 origin, float width) {
    const float top = origin.y + ImGui::GetFontSize() + 4 * ui.scale;
    return {{origin.x, top}, {origin.x + width, top + kStripHeight * ui.scale}};
}

/// `own`: the pinned pixel is of this strip; else it is only framed.
void drawColors(const Ui& ui, const std::vector<std::uint32_t>& colors, ImVec2 min, ImVec2 max, bool own) {
    const Pen list = penOf(ui);
    const auto count = static_cast<float>(colors.size());
    const auto edge = [&](std::size_t pixel) {
        return std::round(min.x + (max.x - min.x) * static_cast<float>(pixel) / count);
    };
    // To the sheet as a picture one pixel high.
    if (list.drawing) list.drawing->cells(min, max, colors, static_cast<std::uint32_t>(colors.size()), 1.0f);
    for (std::size_t i = 0; i < colors.size(); ++i)
        list.screen.AddRectFilled({edge(i), min.y}, {edge(i + 1), max.y}, colors[i]);
    if (const auto pinned = ui.state.pinnedPixel; pinned && *pinned < colors.size()) {
        const float left = edge(*pinned) - 2 * ui.scale, right = edge(*pinned + 1) + 2 * ui.scale;
        const float middle = (left + right) / 2, head = 6 * ui.scale;
        list.AddRect({left - ui.scale, min.y}, {right + ui.scale, max.y}, ui.palette.panel, 0.0f,
                     ImDrawFlags_None, 4 * ui.scale);
        list.AddRect({left, min.y}, {right, max.y}, ui.palette.point, 0.0f, ImDrawFlags_None, 2 * ui.scale);
        if (own)
            list.AddTriangleFilled({middle - head, min.y - head}, {middle + head, min.y - head},
                                   {middle, min.y + head}, ui.palette.point);
    }
    if (!ui.state.eyePixel || *ui.state.eyePixel >= colors.size()) return;
    list.AddRect({edge(*ui.state.eyePixel) - 2 * ui.scale, min.y},
                 {edge(*ui.state.eyePixel + 1) + 2 * ui.scale, max.y}, ui.palette.accent, 0.0f,
                 ImDrawFlags_None, 2 * ui.scale);
}

Side sideOf(std::size_t row) {
    return row == 0 ? Side::first : Side::second;
}

bool isPinned(const AppState& state, std::uint32_t pixel, std::size_t row) {
    return state.pinnedPixel == pixel && state.pinnedSide == sideOf(row);
}

/// The pixel under the pointer, which tells its value.
std::optional<std::uint32_t> pointed(const Ui& ui, const LightPicture* picture, std::size_t side,
                                     Place place) {
    if (!picture || !ImGui::IsItemHovered()) return std::nullopt;
    const auto count = static_cast<float>(picture->colors.size());
    const float share = (ImGui::GetIO().MousePos.x - place.min.x) / (place.max.x - place.min.x);
    const auto pixel = static_cast<std::uint32_t>(std::clamp(share * count, 0.0f, count - 1.0f));
    const Statistics& value = picture->film.pixels[pixel];
    std::string words = say("pixel {}: L = {} \u00b1 {:.1g} W/(m rad)\n{} passes", pixel, shown(value.mean),
                            gray(value.standardError()), picture->film.passes);
    const auto& exact = ui.state.answer->exactPictures[side].eye;
    if (exact && pixel < exact->size()) words += say("\nexactly {} W/(m rad)", shown((*exact)[pixel]));
    words += fmt::format(
        "\n{}", tr(isPinned(ui.state, pixel, side) ? "click: back to P" : "click: every path of this pixel"));
    tooltip(words);
    return pixel;
}

/// With the words on its left and, if there is room, on its right.
void drawTitle(const Ui& ui, ImVec2 origin, float width, const std::string& left, const std::string& right) {
    const ImVec2 title = drawText(ui, origin, ui.palette.inkSoft, left);
    if (title.x + textSize(right).x + 12 * ui.scale < width)
        drawText(ui, {origin.x + width, origin.y}, ui.palette.inkSoft, right, Align::right);
}

std::optional<std::uint32_t> drawRow(const Ui& ui, const Row& row, std::size_t side,
                                     const StripDifferences& exact, bool withDifference, float width) {
    const LightPicture* picture = row.picture && !row.picture->colors.empty() ? row.picture : nullptr;
    const ImVec2 origin = ImGui::GetCursorScreenPos(), size{width, rowHeight(ui, withDifference)};
    const bool clicked = ImGui::InvisibleButton(row.name, size);
    mark(ui.widgets, row.name, origin, {origin.x + size.x, origin.y + size.y});
    const Place place = stripPlace(ui, origin, width);
    const std::optional<std::uint32_t> pixel = pointed(ui, picture, side, place);
    if (clicked && pixel)
        ui.commands.push_back(
            PinPixel{isPinned(ui.state, *pixel, side) ? std::nullopt : pixel, sideOf(side)});

    const std::string what = drawingTitle(ui.state, "eye");
    const std::string words =
        row.maker.empty()
            ? what
            : firstThatFits({fmt::format("{}{} {}", tr(what), ui.state.makers.second ? "," : ":", row.maker),
                             row.maker, row.difference.empty() ? row.maker : row.difference},
                            width);
    std::string white;
    if (picture)
        white = picture->white > 0.0 ? say("white: \u2265 {} W/(m rad)", shown(picture->white)) : "all black";
    drawTitle(ui, origin, width, words, white);
    const Pen list = penOf(ui);
    if (picture) {
        drawColors(ui, picture->colors, place.min, place.max, sideOf(side) == ui.state.pinnedSide);
    } else {
        list.AddRectFilled(place.min, place.max, ui.palette.panel);
        drawText(ui,
                 {(place.min.x + place.max.x) / 2, (place.min.y + place.max.y - ImGui::GetFontSize()) / 2},
                 ui.palette.inkSoft, whyEmpty(ui.state, row.picture), Align::middle);
    }
    if (withDifference && picture && !exact.difference[side].empty())
        drawColors(ui, exact.difference[side], {place.min.x, place.max.y}, {place.max.x, origin.y + size.y},
                   false);
    list.AddLine({place.min.x, place.max.y}, place.max, ui.palette.wallBack);
    list.AddRect(place.min, {place.max.x, origin.y + size.y}, ui.palette.wallBack);
    return pixel;
}

void drawExactRow(const Ui& ui, const StripDifferences& exact, float width) {
    const ImVec2 origin = ImGui::GetCursorScreenPos(), size{width, rowHeight(ui, false)};
    ImGui::InvisibleButton("eye strip exact", size);
    mark(ui.widgets, "eye strip exact", origin, {origin.x + size.x, origin.y + size.y});
    tooltip(
        "Without noise, by quadrature. Below each strip stands how far it is from this one: orange where it "
        "is "
        "too bright, blue where it is too dark, paper where it is right.");
    const Place place = stripPlace(ui, origin, width);
    const std::string range =
        exact.exact.empty() || exact.share == 0.0 ? "" : say("\u00b1 {:g} % of white", 100.0 * exact.share);
    drawTitle(ui, origin, width,
              range.empty()
                  ? std::string(tr("exactly"))
                  : firstThatFits({say("exactly; differences, orange too bright, blue too dark: {}", range),
                                   say("exactly; differences {}", range), std::string(tr("exactly"))},
                                  width),
              "");
    const Pen list = penOf(ui);
    if (exact.exact.empty()) {
        list.AddRectFilled(place.min, place.max, ui.palette.panel);
        drawText(ui,
                 {(place.min.x + place.max.x) / 2, (place.min.y + place.max.y - ImGui::GetFontSize()) / 2},
                 ui.palette.inkSoft,
                 lightIsComplete(ui.state) ? "no exact strip of this scene at this depth" : "being computed",
                 Align::middle);
    } else {
        drawColors(ui, exact.exact, place.min, place.max, false);
    }
    list.AddRect(place.min, place.max, ui.palette.wallBack);
}

float heightOf(const Ui& ui, bool withExact) {
    const float gap = ImGui::GetStyle().ItemSpacing.y, row = rowHeight(ui, withExact);
    const float rows = ui.state.makers.second ? 2 * row + gap : row;
    return withExact ? rows + gap + rowHeight(ui, false) : rows;
}

}  // namespace

float eyeStripHeight(const Ui& ui, float room) {
    const bool withExact = hasExactRow(ui.state) && heightOf(ui, true) <= 0.5f * room;
    return heightOf(ui, withExact);
}

void eyeStrip(const Ui& ui, ImVec2 size) {
    std::optional<std::uint32_t> pixel;
    const OnSheet drawing(ui, "eye", size);
    const bool withExact = hasExactRow(ui.state) && size.y >= heightOf(ui, true);
    const StripDifferences exact = withExact ? stripDifferences(ui.state) : StripDifferences{};
    const std::vector<Row> rows = rowsOf(ui.state);
    for (std::size_t side = 0; side < rows.size(); ++side)
        if (const auto under = drawRow(ui, rows[side], side, exact, withExact, size.x)) pixel = under;
    if (withExact) drawExactRow(ui, exact, size.x);
    // It lights up on the canvas.
    if (pixel != ui.state.eyePixel) ui.commands.push_back(LookAlong{pixel});
}

}  // namespace halfdisk
