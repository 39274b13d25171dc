// What does each key do? Everything that the mouse can do to the lesson; the list for the reader is in
// key_help.h.
#include <algorithm>
#include <array>
#include <utility>

#include "app/imgui_compat.h"
#include "app/panels.h"
#include "app/share_text.h"

namespace halfdisk {
namespace {

void lessonKeys(const Ui& ui) {
    if (keyPressed(Key::pageDown) || keyPressed(Key::n, false)) ui.commands.push_back(NextStep{});
    if (keyPressed(Key::pageUp) || keyPressed(Key::b, false)) ui.commands.push_back(PreviousStep{});
    if (keyPressed(Key::r, false)) ui.commands.push_back(ResetStep{});
    if (keyPressed(Key::a, false)) ui.commands.push_back(RevealAnswer{});
    if (keyPressed(Key::l, false) && !ui.state.lessons.empty()) {
        ui.commands.push_back(GoTo{ui.state.lessons[nextLessonIndex(ui.state)].slug, 0});
    }
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
    const auto speed = static_cast<std::size_t>(ui.state.speed);
    if (keyPressed(Key::k, false) && speed + 1 < kPlaySpeeds.size())
        ui.commands.push_back(SetSpeed{kPlaySpeeds[speed + 1].value});
    if (keyPressed(Key::j, false) && speed > 0) ui.commands.push_back(SetSpeed{kPlaySpeeds[speed - 1].value});
}

/// The entry after `value` in its table, round the end.
template <class Enum, std::size_t Count>
Enum nextIn(const std::array<Named<Enum>, Count>& table, Enum value) {
    for (std::size_t i = 0; i < Count; ++i)
        if (table[i].value == value) return table[(i + 1) % Count].value;
    return value;
}

void defectKeys(Settings& settings) {
    if (keyPressed(Key::digit0, false))
        settings.defects = settings.defects == DefectSet::all() ? DefectSet{} : DefectSet::all();
    for (std::size_t i = 0; i < kDefects.size(); ++i) {
        const Key key = static_cast<Key>(static_cast<std::size_t>(Key::digit1) + i);
        if (keyPressed(key, false))
            settings.defects.set(kDefects[i].value, !settings.defects.has(kDefects[i].value));
    }
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
    if (state.isUnlocked(Control::sampler) && keyPressed(Key::m, false))
        settings.sampler = nextIn(kSamplers, settings.sampler);
    if (state.isUnlocked(Control::emitters) && keyPressed(Key::e, false))
        settings.emitters = nextIn(kEmitters, settings.emitters);
    if (state.isUnlocked(Control::defects)) defectKeys(settings);
    if (!(settings == state.settings)) ui.commands.push_back(SetSettings{settings});
    if (state.isUnlocked(Control::point)) {
        constexpr double kStep = 0.01;
        const double by =
            (keyPressed(Key::rightBracket) ? kStep : 0.0) - (keyPressed(Key::leftBracket) ? kStep : 0.0);
        if (by != 0.0)
            ui.commands.push_back(MovePoint{{state.at.segment, std::clamp(state.at.t + by, 0.0, 1.0)}});
    }
}

/// About the middle of the canvas, within the same limits as by the wheel.
Camera magnified(const Camera& camera, double factor) {
    return zoomed(camera, CanvasRect{{0, 0}, {0, 0}}, {0, 0}, factor);
}

void cameraKeys(const Ui& ui) {
    const Camera& camera = ui.state.camera;
    constexpr double kZoom = 1.25;
    if (keyPressed(Key::equal)) ui.commands.push_back(SetCamera{magnified(camera, kZoom)});
    if (keyPressed(Key::minus)) ui.commands.push_back(SetCamera{magnified(camera, 1.0 / kZoom)});
}

/// With Ctrl held.
void panKeys(const Ui& ui) {
    const float step = 40 * ui.scale;
    const float x = (keyPressed(Key::left) ? step : 0.0f) - (keyPressed(Key::right) ? step : 0.0f);
    const float y = (keyPressed(Key::up) ? step : 0.0f) - (keyPressed(Key::down) ? step : 0.0f);
    if (x != 0.0f || y != 0.0f) ui.commands.push_back(SetCamera{panned(ui.state.camera, {x, y})});
}

/// The arrows move what is selected; then they mean nothing else.
bool nudgeKeys(const Ui& ui) {
    const Editing& editing = ui.state.editing;
    if (!editing.on || editing.selected.empty()) return false;
    constexpr std::array kWays{std::pair{Key::left, Vec2(-1, 0)}, std::pair{Key::right, Vec2(1, 0)},
                               std::pair{Key::down, Vec2(0, -1)}, std::pair{Key::up, Vec2(0, 1)}};
    const double pixels = (ImGui::GetIO().KeyShift ? 24.0 : 2.4) * static_cast<double>(ui.scale);
    const double step = roundStep(ui.state.camera, pixels);
    bool any = false;
    for (const auto& [key, way] : kWays) {
        any = any || keyDown(key);
        if (!keyPressed(key)) continue;
        // What is held down moves on in the same gesture.
        ui.commands.push_back(MoveSelected{step * way, !keyPressed(key, false)});
    }
    return any;
}

void nextThing(const Ui& ui, bool back) {
    const std::vector<Thing> things = thingsOf(ui.state.scene->description);
    if (things.empty()) return;
    const std::optional<Thing> now = ui.state.editing.selected.primary();
    const auto at = now ? std::find(things.begin(), things.end(), *now) : things.end();
    const auto count = things.size(), index = static_cast<std::size_t>(at - things.begin());
    const std::size_t next = at == things.end() ? (back ? count - 1 : 0)
                             : back             ? (index + count - 1) % count
                                                : (index + 1) % count;
    ui.commands.push_back(SelectThings{things[next]});
}

void editKeys(const Ui& ui) {
    if (keyPressed(Key::x, false)) ui.commands.push_back(SetEditing{!ui.state.editing.on});
    if (!ui.state.editing.on) return;
    if (keyPressed(Key::t)) nextThing(ui, ImGui::GetIO().KeyShift);
    if (keyPressed(Key::del, false) || keyPressed(Key::backspace, false))
        ui.commands.push_back(ActOnSelected{EditAct::remove});
}

/// With Ctrl held.
void shareKeys(const Ui& ui) {
    if (keyPressed(Key::c, false)) ui.commands.push_back(CopyState{});
    if (keyPressed(Key::e, false)) ui.commands.push_back(ExportSeen{});
    if (!keyPressed(Key::v, false)) return;
    const char* text = ImGui::GetClipboardText();
    if (text != nullptr && isShareText(text)) ui.commands.push_back(OpenShared{text});
}

/// With Ctrl held.
void historyKeys(const Ui& ui) {
    const Editing& editing = ui.state.editing;
    if (!editing.on) return;
    if (keyPressed(Key::z))
        ui.commands.push_back(ImGui::GetIO().KeyShift ? Command(Redo{}) : Command(Undo{}));
    if (keyPressed(Key::y)) ui.commands.push_back(Redo{});
    if (keyPressed(Key::s, false)) ui.commands.push_back(SaveScene{editing.path});
    if (keyPressed(Key::d, false)) ui.commands.push_back(ActOnSelected{EditAct::copy});
    if (keyPressed(Key::a, false))
        ui.commands.push_back(SelectThings{everything(ui.state.scene->description)});
}

/// With Ctrl held; also out of a text field.
void openKeys(const Ui& ui) {
    if (keyPressed(Key::k, false)) ui.commands.push_back(ShowPalette{true});
    if (keyPressed(Key::o, false)) ui.commands.push_back(ShowFiles{true});
}

void paneKeys(const Ui& ui) {
    if (keyPressed(Key::p, false)) {
        const Pane pane = ui.state.pane;
        ui.commands.push_back(ShowPane{pane == Pane::lesson  ? Pane::stage
                                       : pane == Pane::stage ? Pane::controls
                                                             : Pane::lesson});
    }
    if (keyPressed(Key::c, false)) ui.commands.push_back(HideCanvas{!ui.state.canvasHidden});
}

/// The pixel that is pinned, or else the one under the pointer or in the middle of the strip; then on from
/// it.
void pixelKeys(const Ui& ui) {
    const AppState& state = ui.state;
    const int step = ImGui::GetIO().KeyShift ? 10 : 1;
    const int by = (keyPressed(Key::period) ? step : 0) - (keyPressed(Key::comma) ? step : 0);
    if (by == 0) return;
    constexpr int kLast = static_cast<int>(kEyeStripPixels) - 1;
    const auto first = state.eyePixel.value_or(kEyeStripPixels / 2);
    const int pixel = state.pinnedPixel ? static_cast<int>(*state.pinnedPixel) + by : static_cast<int>(first);
    ui.commands.push_back(
        PinPixel{static_cast<std::uint32_t>(std::clamp(pixel, 0, kLast)), state.pinnedSide});
}

void viewKeys(const Ui& ui) {
    if (keyPressed(Key::f, false)) ui.commands.push_back(FitCamera{});
    if (keyPressed(Key::g, false)) ui.commands.push_back(SetView{View::grid, !ui.state.shows(View::grid)});
    if (keyPressed(Key::v, false)) {
        const View view = ImGui::GetIO().KeyShift ? View::field : View::eye;
        ui.commands.push_back(SetView{view, !ui.state.shows(view)});
    }
    if (characterTyped('?') || keyPressed(Key::f1, false)) ui.commands.push_back(ToggleHelp{});
    if (keyPressed(Key::escape, false)) {
        const bool telling = ui.state.exportWished || !ui.state.notice.empty();
        const bool covered = ui.state.helpShown || !ui.state.banner.empty();
        if (ui.state.helpShown) ui.commands.push_back(ToggleHelp{});
        if (!ui.state.banner.empty()) ui.commands.push_back(DismissBanner{});
        if (telling) ui.commands.push_back(DismissNotice{});
        if (!covered && ui.state.editing.on) ui.commands.push_back(SelectThings{});
        if (!covered && !telling && !ui.state.editing.on) ui.commands.push_back(PinPixel{});
    }
}

}  // namespace

void keyboard(const Ui& ui) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) openKeys(ui);
    if (io.WantTextInput || ImGui::IsAnyItemActive()) return;
    if (io.KeyCtrl) {
        if (keyPressed(Key::equal)) ui.commands.push_back(SetUiScale{ui.state.uiScale * 1.25f});
        if (keyPressed(Key::minus)) ui.commands.push_back(SetUiScale{ui.state.uiScale / 1.25f});
        if (keyPressed(Key::digit0)) ui.commands.push_back(SetUiScale{1.0f});
        panKeys(ui);
        historyKeys(ui);
        shareKeys(ui);
        return;
    }
    if (!nudgeKeys(ui)) {
        playbackKeys(ui);
        settingKeys(ui);
    }
    lessonKeys(ui);
    viewKeys(ui);
    pixelKeys(ui);
    cameraKeys(ui);
    paneKeys(ui);
    editKeys(ui);
}

}  // namespace halfdisk
