// What did each sample bring? The whole run as a list, of P or of one pixel of the eye's strip: a row under
// the pointer lights up on the canvas, a click goes to its step, and a click on a bar of the histogram leaves
// only the samples in it.
#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/sample_words.h"

namespace halfdisk {
namespace {

/// Those within the range that is asked for, in the order that is asked for.
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
    if (state.largestFirst)
        std::stable_sort(rows.begin(), rows.end(), [](const SampleRow* a, const SampleRow* b) {
            return gray(a->adds) > gray(b->adds);
        });
    return rows;
}

void order(const Ui& ui) {
    bool largest = ui.state.largestFirst;
    sameLineIfFits("Largest first");
    if (toggle(ui.widgets, "Largest first", largest)) ui.commands.push_back(SortSamples{largest});
    tooltip("what brings most on top, or all as they came");
}

/// How wide a button with these words is, and the gap before it.
float buttonWidth(std::string_view words) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return textSize(tr(words)).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
}

/// What the pixel's value is made of, and the way back.
void headOfPixel(const Ui& ui) {
    const LightAnswer& answer = *ui.state.answer;
    const float room =
        ImGui::GetContentRegionAvail().x - buttonWidth("Back to P") - buttonWidth("Largest first");
    if (const std::string whose = whosePixel(answer); !whose.empty()) {
        text(ui.widgets, firstThatFits({whose}, ImGui::GetContentRegionAvail().x));
        tooltip(whose);
        ImGui::AlignTextToFramePadding();
    }
    std::string words = pixelSumWords(answer);
    for (const bool unit : {true, false})
        if (textSize(words).x > room) words = shortPixelSumWords(answer, unit);
    text(ui.widgets, words);
    tooltip(pixelSumMeaning(answer));
    order(ui);
    sameLineIfFits("Back to P");
    if (button(ui.widgets, "Back to P")) ui.commands.push_back(PinPixel{});
    tooltip("the samples at P again (Escape)");
}

void head(const Ui& ui, std::size_t shownCount) {
    const AppState& state = ui.state;
    const std::size_t all = state.answer && state.answer->rows ? state.answer->rows->size() : 0;
    ImGui::AlignTextToFramePadding();
    if (state.answer && pixelOf(*state.answer)) return headOfPixel(ui);
    text(ui.widgets, state.sampleRange ? say("{} of {} samples: those of one bar", shownCount, all)
                                       : say("What {} samples bring", all));
    order(ui);
    if (!state.sampleRange) return;
    sameLineIfFits("Show all");
    if (button(ui.widgets, "Show all")) ui.commands.push_back(FilterSamples{});
}

void sampleLine(const Ui& ui, const SampleRow& row, double most, float nameWidth) {
    const LightAnswer& answer = *ui.state.answer;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetFontSize() + 2 * ui.scale;
    const std::string value = sampleNumber(answer, row, most);
    if (ImGui::InvisibleButton(fmt::format("sample{}", row.event).c_str(), {width, line}))
        ui.commands.push_back(SetEvent{row.event});
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ui.commands.push_back(ShowSample{row.event});
    markItem(ui.widgets, fmt::format("sample at {}", row.event));
    tooltip(sampleMeaning(answer, row));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float share = most > 0.0 ? static_cast<float>(std::clamp(gray(row.adds) / most, 0.0, 1.0)) : 0.0f;
    const float bar = 0.18f * width, left = origin.x + width - bar, top = origin.y + ui.scale;
    const std::size_t passed = ui.state.playback.event;
    const bool current = ui.state.playback.stepping && passed > 0 && isOfRow(answer, row, passed - 1);
    if (hovered || current)
        list.AddRectFilled(origin, {origin.x + width, origin.y + line}, ui.palette.currentLine);
    list.AddRectFilled({left, origin.y + 2 * ui.scale}, {left + share * bar, origin.y + line - 2 * ui.scale},
                       withOpacity(ui.palette.light, 0.75f));
    const bool dark = gray(row.adds) == 0.0;
    const float room = width - bar - textSize(value).x - 16 * ui.scale;
    const ImU32 ink = dark && row.kind == SampleRow::Kind::path ? ui.palette.inkSoft : ui.palette.ink;
    drawText(ui, {origin.x + 2 * ui.scale, top}, ink, firstThatFits({sampleName(answer, row)}, room));
    const float rest = room - nameWidth;
    if (!row.word.empty() && rest > 0.0f)
        drawText(ui, {origin.x + nameWidth, top}, dark ? ui.palette.inkSoft : ui.palette.exact,
                 firstThatFits({row.word}, rest));
    drawText(ui, {left - 6 * ui.scale, top}, dark ? ui.palette.inkSoft : ui.palette.estimate, value,
             Align::right);
}

/// Where the words of the paths begin, so that they stand below each other.
float widthOfNames(const Ui& ui, const std::vector<const SampleRow*>& rows) {
    if (rows.empty() || rows.back()->kind != SampleRow::Kind::path) return 0.0f;
    const LightAnswer& answer = *ui.state.answer;
    const float last = textSize(sampleName(answer, *rows.back())).x;
    return std::max(last, rows.front()->word.empty() ? 0.0f : textSize(sampleName(answer, *rows.front())).x) +
           14 * ui.scale;
}

}  // namespace

void samplesPanel(const Ui& ui, ImVec2 size) {
    beginChild("samples", size, false);
    const std::vector<const SampleRow*> rows = shownRows(ui.state);
    head(ui, rows.size());
    double most = 0.0;
    for (const SampleRow* row : rows) most = std::max(most, gray(row->adds));
    const float names = widthOfNames(ui, rows);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {4 * ui.scale, 2 * ui.scale});
    beginChild("list", {0, 0}, true);
    ImGui::PopStyleVar();
    if (ui.state.answer && ui.state.answer->pathRun && !ui.state.answer->pathRun->refusal.empty())
        textWrapped(ui.widgets, ui.state.answer->pathRun->refusal);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), ImGui::GetFontSize() + 2 * ui.scale);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            sampleLine(ui, *rows[static_cast<std::size_t>(i)], most, names);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace halfdisk
