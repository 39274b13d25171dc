// What does accuracy cost in this scene? The front of all settings while they are measured, a dial that
// chooses one for an error or a time, and what then happens. A click on a setting shows its pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/choose.h"
#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/plot.h"
#include "app/plot_words.h"
#include "app/sheet.h"
#include "app/trade_drawing.h"
#include "app/trade_words.h"

namespace halfdisk {
namespace {

/// Narrower than this (design pixels), and the plot stands above the words.
constexpr float kBeside = 460;
constexpr float kLeastPlot = 300;

bool mayPick(const AppState& state) {
    return state.isUnlocked(Control::estimator);
}

/// Drags by this share of the range with each pixel.
DragRange<double> dialRange(double least, double most, const char* format) {
    return {least, most, static_cast<float>(most / 400.0), format, true};
}

/// In one row what is wished for and how much of it, below it the axis.
void dial(const Ui& ui) {
    InstrumentSettings settings = ui.state.instruments;
    const float room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float arrow = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;
    const float combo = std::max({0.4f * room, textSize("error").x + arrow, textSize("time").x + arrow});
    ImGui::PushItemWidth(std::floor(combo));
    if (choose(ui, "##wish", kWishes, settings.wish) && settings.wish == Wish::time)
        settings.tradeCost = TradeCost::seconds;
    ImGui::PopItemWidth();
    ImGui::SameLine(0.0f, gap);
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x);
    if (settings.wish == Wish::error) {
        constexpr double kInPercent = 100.0;
        double percent = kInPercent * settings.wishedError;
        const std::string format(tr("I want %.3g %%"));
        if (dragNumber<double>(
                ui.widgets, "##dial", percent,
                dialRange(kInPercent * kLeastWishedError, kInPercent * kMostWishedError, format.c_str())))
            settings.wishedError = std::clamp(percent / kInPercent, kLeastWishedError, kMostWishedError);
        tooltip("Drag: the error that is wished for, as a share of the light.");
    } else {
        const std::string format(tr("I have %.3g ms"));
        dragNumber<double>(ui.widgets, "##dial", settings.wishedMilliseconds,
                           dialRange(kLeastMilliseconds, kMostMilliseconds, format.c_str()));
        tooltip("Drag: the time that there is.");
    }
    ImGui::PopItemWidth();
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - textSize("axis").x - 2 * gap);
    choose(ui, "axis", kTradeCosts, settings.tradeCost);
    ImGui::PopItemWidth();
    if (!(settings == ui.state.instruments)) ui.commands.push_back(SetInstruments{settings});
}

/// Puts a setting on the stage or, if a click put it there, what was there before.
void pick(const Ui& ui, const TradeSoFar& trade, std::size_t cell) {
    const auto maker = makerOf(ui.state, trade, cell);
    if (!maker || !mayPick(ui.state)) return;
    if (cellOnStage(ui.state, trade) != cell)
        ui.commands.push_back(PickTrade{cell, *maker});
    else if (ui.state.pickedTrade == cell)
        ui.commands.push_back(PickTrade{});
}

/// The dial's choice, its reasons, and what then happened.
void words(const Ui& ui, const TradeSoFar* trade) {
    if (!trade) return text(ui.widgets, "being measured");
    if (const std::string progress = tradeProgress(*trade); !progress.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
        textWrapped(ui.widgets, progress);
        ImGui::PopStyleColor();
    }
    if (trade->report.cells.empty()) return;
    textWrapped(ui.widgets, choiceWords(ui.state, *trade));
    const std::optional<TradeChoice> choice = choiceOf(ui.state, *trade);
    if (!choice) return;
    tooltip(cellWords(trade->report, choice->cell));
    ImGui::PushStyleColor(ImGuiCol_Text, checkOf(*trade, *choice) ? ui.palette.error : ui.palette.inkSoft);
    textWrapped(ui.widgets, checkWords(ui.state, *trade));
    ImGui::PopStyleColor();
    tooltip("The same setting with other seeds: what was predicted beside what came. A red dot in the plot.");
    const bool can = makerOf(ui.state, *trade, choice->cell) && mayPick(ui.state);
    bool onStage = cellOnStage(ui.state, *trade) == choice->cell;
    ImGui::BeginDisabled(!can);
    if (toggle(ui.widgets, "Show its picture", onStage)) pick(ui, *trade, choice->cell);
    ImGui::EndDisabled();
    tooltip("this setting makes the pictures; again: what made them before");
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
    textWrapped(ui.widgets, truthWords(*trade));
    ImGui::PopStyleColor();
}

std::string hoverWords(const Ui& ui, const TradeSoFar& trade, std::size_t cell) {
    std::string about = cellWords(trade.report, cell);
    const auto maker = makerOf(ui.state, trade, cell);
    const std::string_view click = !maker               ? "The stage cannot show it: it needs other walls."
                                   : !mayPick(ui.state) ? "Who makes the pictures is locked here."
                                   : cellOnStage(ui.state, trade) != cell ? "Click: it makes the pictures."
                                   : ui.state.pickedTrade == cell ? "It makes the pictures. Click: as before."
                                                                  : "It makes the pictures.";
    return fmt::format("{}\n{}", about, tr(click));
}

void front(const Ui& ui, const TradeSoFar* trade, ImVec2 size) {
    const OnSheet drawing(ui, "trade", size);
    if (!trade || trade->report.cells.empty()) {
        beginPlot(ui, "front", drawingTitle(ui.state, "trade"), size, {}, {});
        return;
    }
    const TradeReport& report = trade->report;
    const TradeCost cost = ui.state.instruments.tradeCost;
    TradeMarks marks;
    marks.onStage = cellOnStage(ui.state, *trade);
    marks.choice = choiceOf(ui.state, *trade);
    marks.wish = wishOf(ui.state.instruments);
    if (const TradeCheck* check = marks.choice ? checkOf(*trade, *marks.choice) : nullptr)
        marks.outcome = check->outcome;
    const Plot plot = drawTradeFront(ui, report, cost, size, marks);
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!report.cells[i].measured()) continue;
        const ImVec2 dot = tradeDot(plot, report, i, cost);
        const float reach = 4 * ui.scale;
        if (plot.area.contains(dot))
            mark(ui.widgets, fmt::format("setting {}", report.cells[i].name), {dot.x - reach, dot.y - reach},
                 {dot.x + reach, dot.y + reach});
    }
    if (!plot.hovered()) return;
    const auto cell = tradeCellAt(plot, report, cost, ImGui::GetIO().MousePos, 14 * ui.scale);
    if (!cell) return;
    tooltip(hoverWords(ui, *trade, *cell));
    if (ImGui::IsMouseClicked(0)) pick(ui, *trade, *cell);
}

}  // namespace

void tradePanel(const Ui& ui, ImVec2 size) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    mark(ui.widgets, "trade", origin, {origin.x + size.x, origin.y + size.y});
    const TradeSoFar* trade = tradeOf(ui.state);
    beginChild("trade", size, false);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (room.x > kBeside * ui.scale) {
        const float gap = 12 * ui.scale, column = std::floor(0.38f * room.x);
        front(ui, trade, {room.x - column - gap, room.y});
        ImGui::SameLine(0.0f, gap);
        beginChild("words", {column, room.y}, false);
        dial(ui);
        words(ui, trade);
        ImGui::EndChild();
    } else {
        dial(ui);
        constexpr float kLinesBelow = 7;
        const float left =
            ImGui::GetContentRegionAvail().y - kLinesBelow * ImGui::GetTextLineHeightWithSpacing();
        front(ui, trade, {ImGui::GetContentRegionAvail().x, std::max(left, kLeastPlot * ui.scale)});
        words(ui, trade);
    }
    ImGui::EndChild();
}

}  // namespace halfdisk
