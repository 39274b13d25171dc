// What does the lesson say at this step, and how does one go on?
#include <fmt/format.h>

#include <cmath>

#include "app/draw_text.h"
#include "app/goal_check.h"
#include "app/imgui_compat.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/rich_text.h"

namespace halfdisk {
namespace {

void chooser(const Ui& ui) {
    const AppState& state = ui.state;
    std::vector<std::string> titles;
    int current = -1;
    for (const LessonEntry& entry : state.lessons) {
        if (state.lesson && entry.slug == state.lesson->slug) current = static_cast<int>(titles.size());
        titles.push_back(fmt::format("{}  {}", entry.number,
                                     entry.error.empty() ? entry.title : say("{} (broken)", entry.slug)));
    }
    if (state.rules.kiosk) {
        if (state.lesson) textWrapped(ui.widgets, state.lesson->title);
        return;
    }
    const std::vector<std::string_view> names(titles.begin(), titles.end());
    ImGui::SetNextItemWidth(-1);
    if (!combo(ui.widgets, "##Lessons", current, names)) return;
    const LessonEntry& chosen = state.lessons[static_cast<std::size_t>(current)];
    ui.commands.push_back(GoTo{chosen.slug, 0});
}

std::string progressOf(const AppState& state, const Goal& goal, const std::optional<double>& value) {
    if (goal.quantity == GoalQuantity::line) {
        if (!value) return std::string(tr("Click on a line of the code."));
        return *value >= 1.0 ? say("line {}: yes", state.chosenLine)
                             : say("line {}: no, another one", state.chosenLine);
    }
    if (goal.quantity == GoalQuantity::drawn && !value)
        return std::string(tr("Drag over the plot, from its left to its right end."));
    const bool percent = goal.quantity == GoalQuantity::relativeError || goal.quantity == GoalQuantity::drawn;
    const auto number = [&](double x) {
        return percent ? fmt::format("{} %", shown(std::round(1e4 * x) / 100.0)) : shown(x);
    };
    return say("now {}, wanted {} {}", value ? number(*value) : "\u2026",
               goal.relation == Relation::atMost ? "\u2264" : "\u2265", number(goal.number));
}

/// What to do, and how far it is.
void goalBox(const Ui& ui, const Goal& goal) {
    const std::optional<double> value = valueOf(goal, ui.state);
    const bool reached = value && isReached(goal, *value);
    ImGui::Separator();
    ImGui::PushFont(ui.fonts.strong);
    ImGui::PushStyleColor(ImGuiCol_Text, reached ? ui.palette.normal : ui.palette.estimate);
    text(ui.widgets, reached ? "Reached!" : "Try");
    ImGui::PopStyleColor();
    ImGui::PopFont();
    textWrapped(ui.widgets, goal.says);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
    textWrapped(ui.widgets, progressOf(ui.state, goal, value));
    ImGui::PopStyleColor();
    tooltip(kGoalQuantities[static_cast<std::size_t>(goal.quantity)].meaning);
}

void question(const Ui& ui, const Question& asked, const std::vector<Term>& terms) {
    ImGui::Separator();
    ImGui::PushFont(ui.fonts.strong);
    text(ui.widgets, "Question");
    ImGui::PopFont();
    richText(ui, asked.ask, terms);
    if (ui.state.answerShown)
        richText(ui, asked.answer, terms);
    else if (button(ui.widgets, "Show the answer"))
        ui.commands.push_back(RevealAnswer{});
}

void navigation(const Ui& ui) {
    const AppState& state = ui.state;
    const std::size_t steps = state.lesson ? state.lesson->steps.size() : 0;
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    ImGui::BeginDisabled(state.step == 0);
    if (button(ui.widgets, "Previous", {width, 0})) ui.commands.push_back(PreviousStep{});
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(state.step + 1 >= steps);
    if (button(ui.widgets, "Next", {width, 0})) ui.commands.push_back(NextStep{});
    ImGui::EndDisabled();
}

}  // namespace

void lessonPanel(const Ui& ui) {
    const AppState& state = ui.state;
    chooser(ui);
    if (!state.lesson) {
        textWrapped(ui.widgets,
                    state.scene->scene.title.empty() ? "A scene without a lesson" : state.scene->scene.title);
        textWrapped(ui.widgets, "Drag P along the walls; change anything on the right.");
        return;
    }
    const Step& step = *state.currentStep();
    const std::vector<Term>& terms = state.lesson->terms;
    const float footer = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    beginChild("text", {0, -footer}, false);
    ImGui::PushFont(ui.fonts.title);
    textWrapped(ui.widgets, step.title);
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
    text(ui.widgets, say("Step {} of {}", state.step + 1, state.lesson->steps.size()));
    ImGui::PopStyleColor();
    tooltip("This lesson teaches, of the published one: " + state.lesson->section);
    richText(ui, step.prose, terms);
    if (step.goal) goalBox(ui, *step.goal);
    if (step.question) question(ui, *step.question, terms);
    ImGui::EndChild();
    navigation(ui);
}

}  // namespace halfdisk
