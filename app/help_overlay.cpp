// Which keys are there, and what went wrong? The help over everything, and the bar for messages.
#include <fmt/format.h>

#include <array>
#include <string_view>

#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/light_progress.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

struct KeyHelp {
    std::string_view keys, meaning;
};

constexpr std::array kKeys{
    KeyHelp{"Page Down, N", "next step of the lesson"},
    KeyHelp{"Page Up, B", "previous step of the lesson"},
    KeyHelp{"L", "next lesson"},
    KeyHelp{"R", "reset to how the step began"},
    KeyHelp{"\u2192  \u2190", "step forward / back through castRay"},
    KeyHelp{"Shift \u2192  \u2190", "ten steps at once"},
    KeyHelp{"Space", "play or pause"},
    KeyHelp{"Home  End", "first / last step of the run"},
    KeyHelp{"W", "show the whole run at once"},
    KeyHelp{"\u2191  \u2193", "double / halve N, when unlocked"},
    KeyHelp{"[  ]", "move P along its wall, when unlocked"},
    KeyHelp{"D  Shift D", "one scattering more / fewer, when unlocked"},
    KeyHelp{"S", "next seed, when unlocked"},
    KeyHelp{"M  E", "next sampler / emitters, when unlocked"},
    KeyHelp{"1 ... 7  0", "switch one defect / all of them, when unlocked"},
    KeyHelp{"A", "show the answer to the question"},
    KeyHelp{"U", "unlock all controls, or lock them again"},
    KeyHelp{"F", "fit the scene into the canvas"},
    KeyHelp{"+  -  Ctrl arrows", "magnify, shrink or move the picture"},
    KeyHelp{"P  C", "on small screens: the next pane / code or canvas"},
    KeyHelp{"G", "grid on / off"},
    KeyHelp{"X", "change the scene, or be done with it"},
    KeyHelp{"Ctrl Z  Ctrl Y", "undo / redo a change of the scene"},
    KeyHelp{"Ctrl D  Delete", "copy / delete what is selected"},
    KeyHelp{"Ctrl S", "save the scene"},
    KeyHelp{"Ctrl C  Ctrl V", "copy all that is seen as a text / see what such a text says"},
    KeyHelp{"Ctrl E", "export what is seen: pictures, tables, the run, its words"},
    KeyHelp{"V  Shift V", "what the eye sees / the field of light on / off"},
    KeyHelp{"Ctrl +  Ctrl -", "everything larger / smaller"},
    KeyHelp{"? or F1", "this help"},
    KeyHelp{"Mouse", "drag P; drag the canvas to pan; wheel to zoom"},
    KeyHelp{"Double click", "on a number: type it exactly"},
};

/// Each in its own words.
void languageButtons(const Ui& ui) {
    const auto choice = [&](const char* name, const std::string& code) {
        bool spoken = ui.state.language == code;
        if (toggle(ui.widgets, name, spoken) && spoken) ui.commands.push_back(SetLanguage{code});
        ImGui::SameLine();
    };
    choice("English", "");
    for (const Language& language : ui.languages) choice(language.name.c_str(), language.code);
    ImGui::NewLine();
}

}  // namespace

void helpOverlay(const Ui& ui) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {0.95f * screen.x, 0.95f * screen.y});
    ImGui::SetNextWindowFocus();
    ImGui::Begin("Keys", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2 * ui.scale});
    for (const KeyHelp& key : kKeys) {
        ImGui::PushFont(ui.fonts.strong);
        text(ui.widgets, key.keys);
        ImGui::PopFont();
        ImGui::SameLine(9.5f * ImGui::GetFontSize());
        text(ui.widgets, key.meaning);
    }
    ImGui::PopStyleVar();
    languageButtons(ui);
    if (button(ui.widgets, "Close")) ui.commands.push_back(ToggleHelp{});
    ImGui::End();
}

namespace {

/// A bar at the lower edge. True when its button is pressed.
bool messageBar(const Ui& ui, ImU32 ground, std::string_view words, const char* label) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, screen.y}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSizeConstraints({screen.x, 0.0f}, {screen.x, 0.4f * screen.y});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ground);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.panel);
    // Over the help. Else it must not take the focus: what is pressed elsewhere would be let go.
    if (ui.state.helpShown) ImGui::SetNextWindowFocus();
    ImGui::Begin("Message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    textWrapped(ui.widgets, words);
    ImGui::PopStyleColor();
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.ink);
    ImGui::PushStyleColor(ImGuiCol_Button, ui.palette.panel);
    const bool pressed = button(ui.widgets, label);
    ImGui::PopStyleColor(2);
    ImGui::End();
    ImGui::PopStyleColor();
    return pressed;
}

}  // namespace

void bannerBar(const Ui& ui) {
    if (messageBar(ui, ui.palette.error, ui.state.banner, "Dismiss")) ui.commands.push_back(DismissBanner{});
}

void noticeBar(const Ui& ui) {
    const bool waiting = ui.state.exportWished;
    const std::string words = waiting
                                  ? fmt::format("The export waits for the light. {}", lightProgress(ui.state))
                                  : ui.state.notice;
    if (messageBar(ui, ui.palette.accent, words, waiting ? "Cancel" : "Dismiss"))
        ui.commands.push_back(DismissNotice{});
}

}  // namespace halfdisk
