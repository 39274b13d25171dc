// Which line of castRay runs now? Its source with the published listing's line numbers, the current line lit,
// and the keys of the recorder: back, step, play.
#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <optional>

#include "app/choose.h"
#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/run_text.h"

namespace halfdisk {
namespace {

/// Which estimator's run it is: where the step, or nobody, says so it can be chosen.
void chooseRun(const Ui& ui) {
    const AppState& state = ui.state;
    const bool free = state.isUnlocked(Control::step);
    if (!free && state.shownRun() == Run::castRay) return;
    ImGui::PushItemWidth(textSize("bidirectional").x + 1.5f * ImGui::GetFrameHeight());
    ImGui::BeginDisabled(!free);
    Run run = state.shownRun();
    if (choose(ui, "##run", kRuns, run)) ui.commands.push_back(SetRun{run});
    ImGui::EndDisabled();
    ImGui::PopItemWidth();
    ImGui::SameLine();
}

/// How fast it plays.
void chooseSpeed(const Ui& ui) {
    const float width = textSize("500 / s").x + 1.3f * ImGui::GetFrameHeight();
    sameLineIfFits("", width);
    ImGui::PushItemWidth(width);
    PlaySpeed speed = ui.state.speed;
    if (choose(ui, "##speed", kPlaySpeeds, speed)) ui.commands.push_back(SetSpeed{speed});
    ImGui::PopItemWidth();
}

/// To any step at once.
void scrub(const Ui& ui, std::size_t count) {
    const Playback& playback = ui.state.playback;
    constexpr std::size_t kMost = 1'000'000'000;
    const int most = static_cast<int>(std::min(count, kMost));
    const std::string position =
        playback.stepping ? fmt::format("%d / {}", count) : std::string(tr("whole run"));
    int event = playback.stepping ? static_cast<int>(std::min({playback.event, count, kMost})) : most;
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::BeginDisabled(count == 0);
    if (sliderInt(ui.widgets, "##scrub", event, 0, std::max(most, 1), false, position.c_str()))
        ui.commands.push_back(SetEvent{static_cast<std::size_t>(std::clamp(event, 0, most))});
    ImGui::EndDisabled();
    ImGui::PopItemWidth();
    tooltip("drag to any step of the run; double click to type its number");
}

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
    chooseSpeed(ui);
    sameLineIfFits("End");
    if (button(ui.widgets, "End")) ui.commands.push_back(SetEvent{count});
    tooltip("to the last step (End)");
    chooseRun(ui);
    scrub(ui, count);
}

/// Two lines of words and one of numbers; always as high, so that the code below stays where it is.
void stepWords(const Ui& ui) {
    const AppState& state = ui.state;
    const StepText words = describeStep(state);
    const float line = ImGui::GetFontSize() + 2 * ui.scale;
    beginChild("words", {0, 2 * line + ui.fonts.code->FontSize}, false,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 2 * ui.scale});
    const bool refused = state.answer && state.answer->pathRun && !state.answer->pathRun->refusal.empty();
    if (refused) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.error);
        textWrapped(ui.widgets, trMessage(state.answer->pathRun->refusal));
        ImGui::PopStyleColor();
    } else if (words.where.empty()) {
        textWrapped(ui.widgets, "Press Step to walk through this run.");
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
        const bool printed = ui.state.settings.defects != DefectSet{};
        textWrapped(ui.widgets, ui.state.shownRun() != Run::castRay ? "its source, as compiled"
                                : printed                           ? "core/as_printed.h, as compiled"
                                                                    : "core/cast_ray.h, as compiled");
        ImGui::PopStyleColor();
    } else {
        textWrapped(ui.widgets, fmt::format("{}: {}", words.where, words.what));
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.accent);
        ImGui::PushFont(ui.fonts.code);
        textWrapped(ui.widgets, words.values);
        ImGui::PopFont();
        ImGui::PopStyleColor();
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

/// Whether the step's own `listing`, or a term that is looked up, asks for this line to be marked.
bool isMarked(const AppState& state, int number) {
    const TopicRow* topic = rowOf(state.topic);
    if (topic && number > 0 && std::count(topic->listing.begin(), topic->listing.end(), number) > 0)
        return true;
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

/// What the reader clicks on: the number of the published listing, or of the source file.
struct LineName {
    std::string text;             ///< empty: a line of neither
    std::optional<Command> jump;  ///< none: a line that does nothing
};

LineName nameOf(const Listing& listing, std::size_t i) {
    const ListingLine& line = listing[i];
    if (line.number > 0) return {fmt::format("{:03}", line.number), JumpToLine{line.number}};
    if (line.source == 0) {  // one that the published listing lacks belongs to the next that it has
        for (std::size_t k = i; k < listing.size() && !line.comment && !line.text.empty(); ++k)
            if (listing[k].number > 0) return {{}, JumpToLine{listing[k].number}};
        return {};
    }
    if (line.text.empty()) return {};
    const bool last = i + 1 == listing.size() || listing[i + 1].file != line.file;
    const int to = last ? INT_MAX : listing[i + 1].source;
    return {fmt::format("{:3}", line.source), JumpToSource{{line.file, line.source}, {line.file, to}}};
}

void codeLine(const Ui& ui, const Listing& listing, std::size_t i, bool lit, bool marked) {
    const ListingLine& line = listing[i];
    const LineName name = nameOf(listing, i);
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
    if (name.jump) {
        if (ImGui::InvisibleButton(fmt::format("line{}##{}", name.text, i).c_str(), {width, height}))
            ui.commands.push_back(*name.jump);
        if (!name.text.empty()) markItem(ui.widgets, fmt::format("line {}", name.text));
        tooltip(line.source == 0 ? "line of the published listing; click: on to the next step there"
                                 : "line of the source file; click: on to the next step there");
        if (!name.text.empty())
            drawText(ui, {origin.x, origin.y + ui.scale}, ui.palette.inkSoft, name.text, Align::left, font);
    } else {
        ImGui::Dummy({width, height});
    }
    const ImU32 color = line.comment ? ui.palette.normal : ui.palette.ink;
    for (std::size_t k = 0; k < pieces.size(); ++k)
        drawText(ui, {origin.x + gutter, origin.y + ui.scale + row * static_cast<float>(k)}, color, pieces[k],
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

namespace {

/// What runs: castRay, its printed twin, or another estimator.
const Listing& listingOf(const Ui& ui) {
    const AppState& state = ui.state;
    if (const Run run = state.shownRun(); run != Run::castRay)
        return ui.listings.runs[static_cast<std::size_t>(run)];
    return state.settings.defects != DefectSet{} ? ui.listings.asPrinted : ui.listings.corrected;
}

/// Row of the line that runs now, or -1.
int litLine(const AppState& state, const Listing& listing) {
    if (const PathEvent* event = currentPathEvent(state)) return lineOf(listing, event->where);
    const Event* event = currentEvent(state);
    if (!event || state.shownRun() != Run::castRay) return -1;
    const int number = listingLine(event->kind);
    const auto found = std::find_if(listing.begin(), listing.end(),
                                    [&](const ListingLine& line) { return line.number == number; });
    return found == listing.end() ? -1 : static_cast<int>(found - listing.begin());
}

}  // namespace

void codePanel(const Ui& ui, ImVec2 size) {
    const AppState& state = ui.state;
    beginChild("code", size, false);
    transport(ui);
    stepWords(ui);

    const Listing& listing = listingOf(ui);
    const int lit = litLine(state, listing);

    beginChild("source", {0, 0}, true);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    int wanted = lit;  // the line to keep in sight: the current one, else the step's first marked one
    for (std::size_t i = 0; i < listing.size() && wanted < 0; ++i)
        if (isMarked(state, listing[i].number)) wanted = static_cast<int>(i);
    for (std::size_t i = 0; i < listing.size(); ++i) {
        const int row = static_cast<int>(i);
        if (row == wanted && row + 1 != state.litLine) {
            scrollHere();
            ui.commands.push_back(ScrolledTo{row + 1});
        }
        codeLine(ui, listing, i, row == lit, isMarked(state, listing[i].number));
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::EndChild();
}

}  // namespace halfdisk
