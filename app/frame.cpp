#include "app/frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/imgui_compat.h"
#include "app/panels.h"
#include "app/profile_difference.h"

namespace halfdisk {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// How many columns fit side by side. Design pixels: those of scale 1.
constexpr float kThreeColumns = 1140, kTwoColumns = 560;
/// A lower stage shows the canvas or what is below it, not both.
constexpr float kLowStage = 460;

void beginColumn(const char* name, float x, float width, float top, ImGuiWindowFlags more = 0) {
    ImGui::SetNextWindowPos({x, top});
    ImGui::SetNextWindowSize({width, ImGui::GetIO().DisplaySize.y - top});
    ImGui::Begin(name, nullptr, kFixed | more);
}

/// The canvas and, below it, what the eye sees.
void scenePanels(const Ui& ui, ImVec2 size) {
    if (!ui.state.shows(View::eye)) return canvasPanel(ui, size);
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float strips = eyeStripHeight(ui, size.y);
    canvasPanel(ui, {size.x, size.y - strips - gap});
    eyeStrip(ui, {size.x, strips});
}

/// What stands below the canvas, the first one that is shown; the others go to the controls.
struct LowerPanel {
    View view;
    void (*draw)(const Ui& ui, ImVec2 size);
    float share;        ///< of the stage's height
    float most = 1e9f;  ///< design pixels
    float rows = 0.0f;  ///< design pixels that it needs among the controls
};

constexpr std::array kLowerPanels{
    LowerPanel{View::code, codePanel, 0.46f},
    LowerPanel{View::trade, tradePanel, 0.55f, 1e9f, 540.0f},
    LowerPanel{View::extremes, extremesPanel, 0.5f, 1e9f, 300.0f},
    LowerPanel{View::requirements, requirementsPanel, 0.55f, 1e9f, 360.0f},
    LowerPanel{View::strategies, strategiesPanel, 0.5f, 1e9f, 360.0f},
    LowerPanel{View::samples, samplesPanel, 0.46f},
    LowerPanel{View::profile, profilePlot, 0.4f, 300.0f},
    LowerPanel{View::integrand, integrandPlot, 0.4f, 300.0f},
};

const LowerPanel* lowerPanel(const AppState& state) {
    const auto shown = std::find_if(kLowerPanels.begin(), kLowerPanels.end(),
                                    [&](const LowerPanel& panel) { return state.shows(panel.view); });
    return shown == kLowerPanels.end() ? nullptr : &*shown;
}

void stage(const Ui& ui) {
    const AppState& state = ui.state;
    const LowerPanel* lower = lowerPanel(state);
    const bool low = ImGui::GetContentRegionAvail().y < kLowStage * ui.scale;
    if (low && lower) {
        bool hidden = state.canvasHidden;
        if (toggle(ui.widgets, lower->view == View::code ? "Code" : "Plot", hidden))
            ui.commands.push_back(HideCanvas{hidden});
        tooltip("what belongs below the canvas, in its place");
    }
    const ImVec2 all = ImGui::GetContentRegionAvail();
    if (!lower || (low && !state.canvasHidden)) return scenePanels(ui, all);
    const bool two = lower->view == View::profile && plotsDifference(state);  // plots below each other
    const float below = std::floor(two ? std::min(0.6f * all.y, 460 * ui.scale)
                                       : std::min(lower->share * all.y, lower->most * ui.scale));
    if (!low) scenePanels(ui, {all.x, all.y - below - ImGui::GetStyle().ItemSpacing.y});
    lower->draw(ui, {all.x, low ? all.y : below});
}

void controls(const Ui& ui) {
    const AppState& state = ui.state;
    if (state.editing.on) return editPanel(ui);
    controlsPanel(ui);
    if ((state.show & kPictureSet) != ViewSet{}) {
        ImGui::Separator();
        makersPanel(ui);
    }
    if (state.shows(View::numbers) || state.shows(View::exact)) {
        ImGui::Separator();
        numbersPanel(ui);
    }
    std::vector<LowerPanel> plots;
    const LowerPanel* lower = lowerPanel(state);
    for (const LowerPanel& panel : kLowerPanels)
        if (state.shows(panel.view) && &panel != lower) plots.push_back(panel);
    if (state.shows(View::error)) plots.push_back({View::error, errorPlot, 0.0f});
    if (state.shows(View::histogram)) plots.push_back({View::histogram, histogramPlot, 0.0f});
    if (plots.empty()) return;
    ImGui::Separator();
    const ImVec2 left = ImGui::GetContentRegionAvail();
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float count = static_cast<float>(plots.size());
    const float height = std::clamp((left.y - spacing * (count - 1)) / count, 170 * ui.scale, 260 * ui.scale);
    for (const LowerPanel& plot : plots)
        plot.draw(ui, {left.x, std::floor(std::max(height, plot.rows * ui.scale))});
}

void column(const Ui& ui, Pane pane, float x, float width, float top) {
    switch (pane) {
        case Pane::lesson:
            beginColumn("Lesson", x, width, top);
            lessonPanel(ui);
            break;
        case Pane::stage:
            beginColumn("Stage", x, width, top,
                        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
            stage(ui);
            break;
        case Pane::controls:
            beginColumn("Controls", x, width, top);
            controls(ui);
            break;
    }
    ImGui::End();
}

/// The bar by which a small screen chooses its column. Returns its height.
float paneBar(const Ui& ui, float width, Pane shown, bool stageToo) {
    const float height = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("Panes", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    const float count = stageToo ? 3.0f : 2.0f, spacing = ImGui::GetStyle().ItemSpacing.x;
    const float each = (ImGui::GetContentRegionAvail().x - (count - 1) * spacing) / count;
    const auto choice = [&](const char* label, Pane pane) {
        bool on = shown == pane;
        if (toggle(ui.widgets, label, on, {each, 0})) ui.commands.push_back(ShowPane{pane});
    };
    choice("Lesson", Pane::lesson);
    ImGui::SameLine();
    if (stageToo) {
        choice("Stage", Pane::stage);
        ImGui::SameLine();
    }
    choice("Controls", Pane::controls);
    ImGui::End();
    return height;
}

/// Of the lesson's column, where it stands beside the stage at all times; else 0.
float lessonWidth(const Ui& ui) {
    const float all = ImGui::GetIO().DisplaySize.x, design = all / ui.scale;
    if (ui.state.rules.withoutLesson || design < kTwoColumns) return 0.0f;
    const float width = std::floor(330 * ui.scale);
    const bool narrow = design < kThreeColumns && !ui.state.rules.withoutControls;
    return narrow ? std::floor(std::min(width, 0.5f * all)) : width;
}

void columns(const Ui& ui) {
    const float all = ImGui::GetIO().DisplaySize.x, design = all / ui.scale;
    const Pane pane = ui.state.pane;
    if (design < kTwoColumns) {
        column(ui, pane, 0.0f, all, paneBar(ui, all, pane, true));
        return;
    }
    const ClassRules& rules = ui.state.rules;
    const float left = rules.withoutLesson ? 0.0f : std::floor(330 * ui.scale),
                right = rules.withoutControls ? 0.0f : std::floor(310 * ui.scale);
    if (rules.withoutLesson || rules.withoutControls) {
        if (!rules.withoutLesson) column(ui, Pane::lesson, 0.0f, left, 0.0f);
        column(ui, Pane::stage, left, all - left - right, 0.0f);
        if (!rules.withoutControls) column(ui, Pane::controls, all - right, right, 0.0f);
        return;
    }
    if (design < kThreeColumns) {
        const Pane shown = pane == Pane::controls ? Pane::controls : Pane::lesson;
        const float side = std::floor(std::min(left, 0.5f * all));
        column(ui, shown, 0.0f, side, paneBar(ui, side, shown, false));
        column(ui, Pane::stage, side, all - side, 0.0f);
        return;
    }
    column(ui, Pane::lesson, 0.0f, left, 0.0f);
    column(ui, Pane::stage, left, all - left - right, 0.0f);
    column(ui, Pane::controls, all - right, right, 0.0f);
}

/// Play.
void advance(AppState& state) {
    Playback& playback = state.playback;
    if (!playback.playing) return;
    const float speed = kStepsPerSecond[static_cast<std::size_t>(state.speed)];
    constexpr float kLongestFrame = 0.25f;  // s: after a pause of the program it does not jump
    playback.sinceLast += std::min(ImGui::GetIO().DeltaTime, kLongestFrame);
    const float steps = std::floor(playback.sinceLast * speed);
    if (steps < 1.0f) return;
    playback.sinceLast -= steps / speed;
    const std::size_t count = state.eventCount();
    if (playback.event >= count) playback.playing = false;
    playback.event =
        std::min(playback.event + static_cast<std::size_t>(steps), std::max(count, playback.event));
}

/// An answer about another scene has walls that this one lacks.
void dropForeignAnswer(AppState& state) {
    if (state.answer && state.answer->asked.scene != state.scene) state.answer.reset();
}

}  // namespace

void askLight(Session& session) {
    AppState& state = session.state;
    if (session.asked == state.questionId) return;
    session.asked = state.questionId;
    session.light.ask({.id = state.questionId,
                       .scene = state.scene,
                       .at = state.at,
                       .settings = state.settings,
                       .wantsDamage = state.shows(View::damage),
                       .pictures = state.show & kPictureSet,
                       .instruments = state.show & kInstrumentSet,
                       .instrumentSettings = state.instruments,
                       .makers = state.makers,
                       .run = state.shownRun(),
                       .pixel = state.pinnedPixel,
                       .pixelOf = state.pinnedSide,
                       .wantsTree = state.shows(View::tree),
                       .effort = session.effort});
}

void frame(Session& session, const Fonts& fonts, float uiScale, Sheet* sheet) {
    AppState& state = session.state;
    session.widgets.beginFrame();
    speak(findLanguage(session.languages, state.language));
    const auto latest = session.light.latest();
    if (latest && latest->asked.scene == state.scene) {
        if (latest != state.answer && !latest->failure.empty()) state.banner = tr(latest->failure);
        state.answer = latest;
    }
    dropForeignAnswer(state);
    advance(state);

    Commands commands;
    const Ui ui{
        state,   fonts, session.palette, session.listings, session.widgets, commands, session.languages,
        uiScale, sheet};
    columns(ui);
    if (state.palette.shown) {
        paletteOverlay(ui);
    } else if (state.files.shown) {
        filesOverlay(ui);
    } else {
        if (!state.banner.empty())
            bannerBar(ui, lessonWidth(ui));
        else if (state.exportWished || !state.notice.empty())
            noticeBar(ui, lessonWidth(ui));
        if (state.helpShown) helpOverlay(ui);
        keyboard(ui);
    }

    state.topic = Topic::none;
    state.shownSample.reset();
    for (const Command& command : commands) apply(state, command);
    if (!state.toClipboard.empty()) ImGui::SetClipboardText(state.toClipboard.c_str());
    state.toClipboard.clear();
    dropForeignAnswer(state);
    askLight(session);
}

}  // namespace halfdisk
