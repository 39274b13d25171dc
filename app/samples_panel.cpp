// What did each sample bring? The whole run as a list: a row under the pointer lights up on the canvas, a
// click goes to its step, and a click on a bar of the histogram leaves only the samples in it.
#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/pen.h"

namespace halfdisk {
namespace {

std::string nameOf(const AppState& state, const SampleRow& row) {
    const std::string wall =
        row.segment == kNoSegment ? std::string(tr("the sky")) : state.scene->scene.segmentNames[row.segment];
    switch (row.kind) {
        case SampleRow::Kind::path:
            if (state.run == Run::light)
                return row.number == 0 ? std::string(tr("straight from the lights"))
                                       : say("path {}", row.number);
            return state.run == Run::bidirectional ? say("pair {}", row.number + 1)
                                                   : say("path {}", row.number + 1);
        case SampleRow::Kind::light:
            return row.segment == kNoSegment ? std::string(tr("shadow ray to a light"))
                                             : say("shadow ray to {}", wall);
        case SampleRow::Kind::halfDisk:
            break;
    }
    constexpr double kDegrees = 180.0 / kPi;
    return say("n = {}: {:.0f}\u00b0, {}", row.number, 90.0 - row.theta * kDegrees, wall);
}

/// Those within the range that is asked for.
std::vector<const SampleRow*> shownRows(const AppState& state) {
    std::vector<const SampleRow*> rows;
    if (!state.answer || !state.answer->rows) return rows;
    const auto& range = state.sampleRange;
    const double N = state.answer->asked.settings.samples;
    for (const SampleRow& row : *state.answer->rows) {
        const double value = gray(row.adds) * (row.kind == SampleRow::Kind::halfDisk ? N : 1.0);
        const bool within = !range || (row.kind == SampleRow::Kind::halfDisk && value >= range->first &&
                                       value <= range->second);
        if (within) rows.push_back(&row);
    }
    return rows;
}

void head(const Ui& ui, std::size_t shownCount) {
    const AppState& state = ui.state;
    const std::size_t all = state.answer && state.answer->rows ? state.answer->rows->size() : 0;
    ImGui::AlignTextToFramePadding();
    if (!state.sampleRange) return text(ui.widgets, say("What {} samples bring", all));
    text(ui.widgets, say("{} of {} samples: those of one bar", shownCount, all));
    sameLineIfFits("Show all");
    if (button(ui.widgets, "Show all")) ui.commands.push_back(FilterSamples{});
}

void sampleLine(const Ui& ui, const SampleRow& row, double most) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetFontSize() + 4 * ui.scale;
    const std::string value = shown(row.adds);
    if (ImGui::InvisibleButton(fmt::format("sample{}", row.event).c_str(), {width, line}))
        ui.commands.push_back(SetEvent{row.event});
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ui.commands.push_back(ShowSample{row.event});
    markItem(ui.widgets, fmt::format("sample at {}", row.event));
    tooltip(row.kind == SampleRow::Kind::halfDisk
                ? say("brings {} W/(m rad), adds {} W/m to E; click: to its step", shown(row.brings), value)
                : say("adds {} W/m to E; click: to its step", value));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float share = most > 0.0 ? static_cast<float>(std::clamp(gray(row.adds) / most, 0.0, 1.0)) : 0.0f;
    const float bar = 0.18f * width, left = origin.x + width - bar;
    if (hovered) list.AddRectFilled(origin, {origin.x + width, origin.y + line}, ui.palette.currentLine);
    list.AddRectFilled({left, origin.y + 2 * ui.scale}, {left + share * bar, origin.y + line - 2 * ui.scale},
                       withOpacity(ui.palette.light, 0.75f));
    const float room = width - bar - textSize(value).x - 16 * ui.scale;
    drawText(ui, {origin.x + 2 * ui.scale, origin.y + 2 * ui.scale}, ui.palette.ink,
             firstThatFits({nameOf(ui.state, row)}, room));
    drawText(ui, {left - 6 * ui.scale, origin.y + 2 * ui.scale}, ui.palette.estimate, value, Align::right);
}

}  // namespace

void samplesPanel(const Ui& ui, ImVec2 size) {
    beginChild("samples", size, false);
    const std::vector<const SampleRow*> rows = shownRows(ui.state);
    head(ui, rows.size());
    double most = 0.0;
    for (const SampleRow* row : rows) most = std::max(most, gray(row->adds));
    beginChild("list", {0, 0}, true);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), ImGui::GetFontSize() + 4 * ui.scale);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            sampleLine(ui, *rows[static_cast<std::size_t>(i)], most);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace halfdisk
