// What does each key do? Everything that the mouse can do to the lesson; the list for the reader is in
// help_overlay.cpp.
#include <algorithm>

#include "app/imgui_compat.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

void lessonKeys(const Ui& ui) {
    if (keyPressed(Key::pageDown) || keyPressed(Key::n, false)) ui.commands.push_back(NextStep{});
    if (keyPressed(Key::pageUp) || keyPressed(Key::b, false)) ui.commands.push_back(PreviousStep{});
    if (keyPressed(Key::r, false)) ui.commands.push_back(ResetStep{});
    if (keyPressed(Key::a, false)) ui.commands.push_back(RevealAnswer{});
    if (keyPressed(Key::u, false)) ui.commands.push_back(UnlockAll{!ui.state.unlockAll});
}

void playbackKeys(const Ui& ui) {
    const int by = ImGui::GetIO().KeyShift ? 10 : 1;
    if (keyPressed(Key::right)) ui.commands.push_back(StepEvents{by});
    if (keyPressed(Key::left)) ui.commands.push_back(StepEvents{-by});
    if (keyPressed(Key::home, false)) ui.commands.push_back(SetEvent{0});
    if (keyPressed(Key::end, false)) ui.commands.push_back(SetEvent{ui.state.eventCount()});
    if (keyPressed(Key::space, false)) ui.commands.push_back(TogglePlay{});
    if (keyPressed(Key::w, false)) ui.commands.push_back(ShowWholeRun{});
}

void settingKeys(const Ui& ui) {
    const AppState& state = ui.state;
    Settings settings = state.settings;
    if (state.isUnlocked(Control::samples)) {
        if (keyPressed(Key::up))
            settings.samples = std::min<std::uint32_t>(settings.samples * 2, kMostLessonSamples);
        if (keyPressed(Key::down)) settings.samples = std::max(settings.samples / 2, 1u);
    }
    if (state.isUnlocked(Control::depth) && keyPressed(Key::d)) {
        if (ImGui::GetIO().KeyShift)
            settings.maxDepth -= settings.maxDepth > 0 ? 1 : 0;
        else
            settings.maxDepth = std::min<std::uint32_t>(settings.maxDepth + 1, kMostLessonDepth);
    }
    if (state.isUnlocked(Control::seed) && keyPressed(Key::s)) ++settings.seed;
    if (!(settings == state.settings)) ui.commands.push_back(SetSettings{settings});
    if (state.isUnlocked(Control::point)) {
        constexpr double kStep = 0.01;
        const double by =
            (keyPressed(Key::rightBracket) ? kStep : 0.0) - (keyPressed(Key::leftBracket) ? kStep : 0.0);
        if (by != 0.0)
            ui.commands.push_back(MovePoint{{state.at.segment, std::clamp(state.at.t + by, 0.0, 1.0)}});
    }
}

void viewKeys(const Ui& ui) {
    if (keyPressed(Key::f, false)) ui.commands.push_back(FitCamera{});
    if (keyPressed(Key::g, false)) ui.commands.push_back(SetView{View::grid, !ui.state.shows(View::grid)});
    if (characterTyped('?') || keyPressed(Key::f1, false)) ui.commands.push_back(ToggleHelp{});
    if (keyPressed(Key::escape, false)) {
        if (ui.state.helpShown) ui.commands.push_back(ToggleHelp{});
        if (!ui.state.banner.empty()) ui.commands.push_back(DismissBanner{});
    }
}

}  // namespace

void keyboard(const Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || ImGui::IsAnyItemActive()) return;
    if (io.KeyCtrl) {
        if (keyPressed(Key::equal)) ui.commands.push_back(SetUiScale{ui.state.uiScale * 1.25f});
        if (keyPressed(Key::minus)) ui.commands.push_back(SetUiScale{ui.state.uiScale / 1.25f});
        if (keyPressed(Key::digit0)) ui.commands.push_back(SetUiScale{1.0f});
        return;
    }
    lessonKeys(ui);
    playbackKeys(ui);
    settingKeys(ui);
    viewKeys(ui);
}

}  // namespace halfdisk
