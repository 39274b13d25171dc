#include "app/frame.h"

#include <algorithm>
#include <cmath>

#include "app/imgui_compat.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Left column, canvas, right column; pixels.
struct Layout {
    float left, right, width, height;
};

Layout layOut(float scale) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    return {std::floor(std::min(330 * scale, 0.34f * screen.x)),
            std::floor(std::min(310 * scale, 0.33f * screen.x)), screen.x, screen.y};
}

void beginColumn(const char* name, float x, float width, float height, ImGuiWindowFlags more = 0) {
    ImGui::SetNextWindowPos({x, 0.0f});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin(name, nullptr, kFixed | more);
}

void middleColumn(const Ui& ui) {
    const AppState& state = ui.state;
    const ImVec2 all = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const bool code = state.shows(View::code), integrand = state.shows(View::integrand);
    if (!code && !integrand) return canvasPanel(ui, all);
    const float below = std::floor(code ? 0.46f * all.y : std::min(0.4f * all.y, 300 * ui.scale));
    canvasPanel(ui, {all.x, all.y - below - gap});
    if (code)
        codePanel(ui, {all.x, below});
    else
        integrandPlot(ui, {all.x, below});
}

void rightColumn(const Ui& ui) {
    const AppState& state = ui.state;
    controlsPanel(ui);
    ImGui::Separator();
    numbersPanel(ui);
    std::vector<void (*)(const Ui&, ImVec2)> plots;
    if (state.shows(View::code) && state.shows(View::integrand)) plots.push_back(integrandPlot);
    if (state.shows(View::error)) plots.push_back(errorPlot);
    if (state.shows(View::histogram)) plots.push_back(histogramPlot);
    if (plots.empty()) return;
    ImGui::Separator();
    const ImVec2 left = ImGui::GetContentRegionAvail();
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float count = static_cast<float>(plots.size());
    const float height = std::clamp((left.y - spacing * (count - 1)) / count, 170 * ui.scale, 260 * ui.scale);
    for (const auto plot : plots) plot(ui, {left.x, std::floor(height)});
}

/// Play: four steps a second.
void advance(AppState& state) {
    Playback& playback = state.playback;
    if (!playback.playing) return;
    constexpr float kSecondsPerStep = 0.25f;
    playback.sinceLast += ImGui::GetIO().DeltaTime;
    if (playback.sinceLast < kSecondsPerStep) return;
    playback.sinceLast = 0.0f;
    if (playback.event < state.eventCount())
        ++playback.event;
    else
        playback.playing = false;
}

}  // namespace

void askLight(Session& session) {
    AppState& state = session.state;
    if (session.asked == state.questionId) return;
    session.asked = state.questionId;
    session.light.ask({state.questionId, state.scene, state.at, state.settings, state.shows(View::damage)});
}

void frame(Session& session, const Fonts& fonts, float uiScale) {
    AppState& state = session.state;
    session.widgets.beginFrame();
    const auto latest = session.light.latest();
    if (latest && latest->asked.scene == state.scene) state.answer = latest;
    if (state.answer && state.answer->asked.scene != state.scene) state.answer.reset();
    advance(state);

    Commands commands;
    const Ui ui{state, fonts, session.palette, session.listings, session.widgets, commands, uiScale};
    const Layout layout = layOut(uiScale);
    const float middle = layout.width - layout.left - layout.right;
    beginColumn("Lesson", 0.0f, layout.left, layout.height);
    lessonPanel(ui);
    ImGui::End();
    beginColumn("Stage", layout.left, middle, layout.height,
                ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    middleColumn(ui);
    ImGui::End();
    beginColumn("Controls", layout.left + middle, layout.right, layout.height);
    rightColumn(ui);
    ImGui::End();
    if (!state.banner.empty()) bannerBar(ui);
    if (state.helpShown) helpOverlay(ui);
    keyboard(ui);

    state.fitCamera = false;
    for (const Command& command : commands) apply(state, command);
    askLight(session);
}

}  // namespace halfdisk
