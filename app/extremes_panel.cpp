// What happens to this scene at an extreme? A dial that moves it there, and counters of what goes wrong in a
// tracer of your choice, beside Halfdisk's own.
#include <fmt/format.h>

#include <algorithm>

#include "app/choose.h"
#include "app/draw_text.h"
#include "app/instrument_words.h"
#include "app/language.h"
#include "app/lost_mark.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/plot_words.h"

namespace halfdisk {
namespace {

/// How much one pixel of dragging turns: the whole range in some 400.
DragRange<double> logRange(double least, double most, const char* format) {
    return {least, most, static_cast<float>(most / 400.0), format, true};
}

void dialControls(const Ui& ui) {
    InstrumentSettings settings = ui.state.instruments;
    DialSetting& dial = settings.dial;
    const float labels = textSize("precision").x + 2 * ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - labels);
    dragNumber<double>(ui.widgets, "scale", dial.scale, logRange(kLeastScale, kMostScale, "%.3g"));
    tooltip("the whole scene so many times as large");
    dragNumber<double>(ui.widgets, "offset", dial.offset, logRange(0.0, kMostOffset, "%.3g"));
    tooltip("so many sizes of the scene away from the origin");
    dragNumber<double>(ui.widgets, "gap", dial.gap, logRange(0.0, kMostGap, "%.3g"));
    tooltip(
        "two walls that face each other so many sizes of the scene apart are put into its middle; 0: none");
    choose(ui, "precision", kPrecisions, dial.precision);
    choose(ui, "epsilon", kEpsilonPolicies, dial.policy);
    if (dial.policy == EpsilonPolicy::fixed) {
        dragNumber<double>(ui.widgets, "nearer", dial.fixedEpsilon,
                           logRange(kLeastEpsilon, kMostEpsilon, "%.3g m"));
        tooltip("hits nearer than this do not count");
    }
    ImGui::PopItemWidth();
    if (!(settings == ui.state.instruments)) ui.commands.push_back(SetInstruments{settings});
}

/// Of the marks before the names, pixels.
float markWidth(const Ui& ui) {
    return 16 * ui.scale;
}

/// Where the columns of the counters stand, and how wide they are together (pixels).
struct Columns {
    float chosen = 0.0f, product = 0.0f, width = 0.0f;
};

Columns columnsOf(const Ui& ui, const std::vector<DialLine>& lines) {
    const float gap = 14 * ui.scale;
    float names = 0.0f, chosen = textSize(tr("this one")).x, product = textSize("Halfdisk").x;
    for (const DialLine& one : lines) {
        names = std::max(names, markWidth(ui) + textSize(one.name).x);
        chosen = std::max(chosen, textSize(one.chosen, ui.fonts.strong).x);
        product = std::max(product, textSize(one.product).x);
    }
    const float second = names + gap + chosen + gap;
    return {names + gap, second, second + product + gap};
}

/// Names on the left, the chosen tracer's counts and the product's in two columns; in lines where these do
/// not fit.
void counters(const Ui& ui, const std::vector<DialLine>& lines, const Columns& columns) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, line = 1.35f * ImGui::GetFontSize();
    if (columns.width > width) {
        for (const DialLine& one : lines)
            textWrapped(ui.widgets,
                        fmt::format("{}: {}; {} {}", one.name, one.chosen, "Halfdisk", one.product));
        return;
    }
    const float first = origin.x + columns.chosen, second = origin.x + columns.product;
    drawText(ui, {first, origin.y}, ui.palette.inkSoft, "this one");
    drawText(ui, {second, origin.y}, ui.palette.inkSoft, "Halfdisk");
    float y = origin.y + line;
    for (const DialLine& one : lines) {
        const float middle = y + 0.55f * ImGui::GetFontSize();
        if (one.how)
            drawLostMark(penOf(ui), ui.palette, *one.how, {origin.x + 5 * ui.scale, middle}, 3.5f * ui.scale);
        drawText(ui, {origin.x + markWidth(ui), y}, ui.palette.ink, one.name);
        drawText(ui, {first, y}, one.wrong ? ui.palette.error : ui.palette.ink, one.chosen, Align::left,
                 one.wrong ? ui.fonts.strong : nullptr);
        drawText(ui, {second, y}, ui.palette.ink, one.product);
        ImGui::SetCursorScreenPos({origin.x, y});
        ImGui::InvisibleButton(one.name.c_str(), {width, ImGui::GetFontSize()});
        tooltip(one.meaning);
        y += line;
    }
    ImGui::SetCursorScreenPos({origin.x, y});
    ImGui::Dummy({width, 0.0f});
}

}  // namespace

void extremesPanel(const Ui& ui, ImVec2 size) {
    ImGui::BeginChild("extremes", size);
    ImGui::PushFont(ui.fonts.strong);
    textWrapped(ui.widgets, drawingTitle(ui.state, "extremes"));
    ImGui::PopFont();
    const auto& answer = ui.state.answer ? ui.state.answer->instruments.dial : nullptr;
    const bool counted = answer && answer->refusal.empty() && answer->chosen.rays > 0;
    const std::vector<DialLine> lines = counted ? dialLines(*answer) : std::vector<DialLine>{};
    const Columns columns = columnsOf(ui, lines);
    const float room = ImGui::GetContentRegionAvail().x, gap = 16 * ui.scale;
    const float left = std::max(0.36f * room, 200 * ui.scale);
    const bool beside = left + gap + columns.width <= room;
    ImGui::BeginChild("dial",
                      {beside ? left : 0.0f, beside ? 0.0f : 6.6f * ImGui::GetFrameHeightWithSpacing()});
    dialControls(ui);
    ImGui::EndChild();
    if (beside) ImGui::SameLine(0.0f, gap);
    const float rows = (2.0f + 1.35f * 7.0f) * ImGui::GetFontSize();
    ImGui::BeginChild("counters", {0.0f, beside ? 0.0f : rows});
    if (answer) {
        textWrapped(ui.widgets, dialVerdict(*answer));
        const OnSheet drawing(ui, "extremes", ImGui::GetContentRegionAvail());
        if (counted) counters(ui, lines, columns);
    } else {
        text(ui.widgets, "being counted");
    }
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace halfdisk
