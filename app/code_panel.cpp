// Which line of castRay runs now? Its source with the published listing's line numbers, the current line lit,
// and the keys of the recorder: back, step, play.
#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/panels.h"
#include "app/step_text.h"

namespace halfdisk {
namespace {

void transport(const Ui& ui) {
    const AppState& state = ui.state;
    const Playback& playback = state.playback;
    const std::size_t count = state.eventCount();
    if (button(ui.widgets, "Start")) ui.commands.push_back(SetEvent{0});
    tooltip("to the first step (Home)");
    sameLineIfFits("Back");
    if (button(ui.widgets, "Back")) ui.commands.push_back(StepEvents{-1});
    tooltip("one step back (left arrow)");
    sameLineIfFits("Step");
    if (button(ui.widgets, "Step")) ui.commands.push_back(StepEvents{+1});
    tooltip("one step on (right arrow)");
    sameLineIfFits("Pause");
    if (button(ui.widgets, playback.playing ? "Pause" : "Play")) ui.commands.push_back(TogglePlay{});
    tooltip("step by step by itself (space)");
    sameLineIfFits("End");
    if (button(ui.widgets, "End")) ui.commands.push_back(SetEvent{count});
    tooltip("to the last step (End)");
    const std::string position =
        playback.stepping ? fmt::format("{} / {}", std::min(playback.event, count), count) : "whole run";
    sameLineIfFits(position);
    ImGui::AlignTextToFramePadding();
    text(ui.widgets, position);
}

/// Two lines of words and one of numbers; always as high, so that the code below stays where it is.
void stepWords(const Ui& ui) {
    const StepText words = describeStep(ui.state);
    const float line = ImGui::GetFontSize() + 2 * ui.scale;
    beginChild("words", {0, 2 * line + ui.fonts.code->FontSize}, false,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 2 * ui.scale});
    if (words.where.empty()) {
        textWrapped(ui.widgets, "Press Step to walk through this run.");
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
        const bool printed = ui.state.settings.defects != DefectSet{};
        textWrapped(ui.widgets, printed ? "core/as_printed.h, as compiled" : "core/cast_ray.h, as compiled");
        ImGui::PopStyleColor();
    } else {
        textWrapped(ui.widgets, words.where + ": " + words.what);
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.accent);
        ImGui::PushFont(ui.fonts.code);
        textWrapped(ui.widgets, words.values);
        ImGui::PopFont();
        ImGui::PopStyleColor();
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

/// Whether the step's own `listing` asks for this line to be marked.
bool isMarked(const AppState& state, int number) {
    const Step* step = state.currentStep();
    return step && number > 0 &&
           std::find(step->listing.begin(), step->listing.end(), number) != step->listing.end();
}

/// A source line in pieces that fit, the later ones indented further.
std::vector<std::string> piecesOf(const std::string& text, std::size_t most) {
    std::vector<std::string> pieces;
    std::string rest = text;
    const std::size_t indent = std::min(text.find_first_not_of(' '), most / 2);
    while (rest.size() > most) {
        const std::size_t space = rest.rfind(' ', most);
        const bool breakable = space != std::string::npos && rest.find_first_not_of(' ') < space;
        const std::size_t end = breakable ? space : most;
        pieces.push_back(rest.substr(0, end));
        rest = std::string(std::min(indent + 4, most / 2), ' ') + rest.substr(breakable ? end + 1 : end);
    }
    pieces.push_back(rest);
    return pieces;
}

void codeLine(const Ui& ui, const ListingLine& line, bool lit, bool marked) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImFont* font = ui.fonts.code;
    const float width = ImGui::GetContentRegionAvail().x, letter = textSize("0", font).x, gutter = 4 * letter;
    const auto most = static_cast<std::size_t>(std::max(8.0f, (width - gutter) / letter));
    const std::vector<std::string> pieces = piecesOf(line.text, most);
    const float row = font->FontSize + 2 * ui.scale, height = row * static_cast<float>(pieces.size());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{origin.x + width, origin.y + height};
    if (lit)
        list.AddRectFilled(origin, end, ui.palette.currentLine);
    else if (marked)
        list.AddRectFilled(origin, end, withOpacity(ui.palette.halfDisk, 0.28f));
    if (line.number > 0) {
        const std::string name = fmt::format("{:03}", line.number);
        if (ImGui::InvisibleButton(fmt::format("line{}##{}", line.number, origin.y).c_str(), {width, height}))
            ui.commands.push_back(JumpToLine{line.number});
        markItem(ui.widgets, "line " + name);
        tooltip("line of the published listing; click: on to the next step there");
        drawText(ui, {origin.x, origin.y + ui.scale}, ui.palette.inkSoft, name, Align::left, font);
    } else {
        ImGui::Dummy({width, height});
    }
    const ImU32 color = line.comment ? ui.palette.normal : ui.palette.ink;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        drawText(ui, {origin.x + gutter, origin.y + ui.scale + row * static_cast<float>(i)}, color, pieces[i],
                 Align::left, font);
}

/// Once, when the line becomes the current one: after that the reader may scroll away.
void scrollHere() {
    const float top = ImGui::GetCursorPosY(), page = ImGui::GetWindowHeight(), scroll = ImGui::GetScrollY();
    const float margin = 3 * ImGui::GetFontSize();
    if (top < scroll + margin || top > scroll + page - 2 * margin)
        ImGui::SetScrollY(std::max(0.0f, top - page / 3));
}

}  // namespace

void codePanel(const Ui& ui, ImVec2 size) {
    const AppState& state = ui.state;
    beginChild("code", size, false);
    transport(ui);
    stepWords(ui);

    const bool printed = state.settings.defects != DefectSet{};
    const Listing& listing = printed ? ui.listings.asPrinted : ui.listings.corrected;
    const Event* event = currentEvent(state);
    const int lit = event ? listingLine(event->kind) : 0;

    beginChild("source", {0, 0}, true);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    int wanted = lit;  // the line to keep in sight: the current one, else the step's first marked one
    for (const ListingLine& line : listing)
        if (wanted == 0 && isMarked(state, line.number)) wanted = line.number;
    for (const ListingLine& line : listing) {
        if (line.number == wanted && wanted > 0 && wanted != state.litLine) {
            scrollHere();
            ui.commands.push_back(ScrolledTo{wanted});
        }
        codeLine(ui, line, line.number == lit && lit > 0, isMarked(state, line.number));
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace halfdisk
