// Which keys are there, and what went wrong? The help over everything, and the bar for messages.
#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/key_help.h"
#include "app/key_words.h"
#include "app/language.h"
#include "app/light_progress.h"
#include "app/message_words.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

/// Of the keys, pixels.
float widestKeys(const Ui& ui) {
    float width = 0.0f;
    for (const KeyHelp& key : kKeyHelp)
        width = std::max(width, textSize(keyWords(key.keys), ui.fonts.strong).x);
    return width;
}

/// Of the meanings in these rows, pixels.
float longest(std::size_t first, std::size_t last) {
    float width = 0.0f;
    for (std::size_t i = first; i < last; ++i) width = std::max(width, textSize(kKeyHelp[i].meaning).x);
    return width;
}

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
    languageButtons(ui);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2 * ui.scale});
    const std::size_t half = (kKeyHelp.size() + 1) / 2;
    const float gap = 1.5f * ImGui::GetFontSize(), indent = widestKeys(ui) + gap;
    const bool beside =
        indent + longest(0, half) + gap + indent + longest(half, kKeyHelp.size()) + gap < 0.95f * screen.x;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < kKeyHelp.size(); ++i) {
        if (beside && i == half) {
            ImGui::EndGroup();
            ImGui::SameLine(0.0f, gap);
            ImGui::BeginGroup();
        }
        ImGui::PushFont(ui.fonts.strong);
        text(ui.widgets, keyWords(kKeyHelp[i].keys));
        ImGui::PopFont();
        ImGui::SameLine(indent);
        text(ui.widgets, kKeyHelp[i].meaning);
    }
    ImGui::EndGroup();
    ImGui::PopStyleVar();
    if (button(ui.widgets, "Close")) ui.commands.push_back(ToggleHelp{});
    sameLineIfFits("Find by name ...");
    if (button(ui.widgets, "Find by name ...")) {
        ui.commands.push_back(ToggleHelp{});
        ui.commands.push_back(ShowPalette{true});
    }
    ImGui::End();
}

namespace {

/// A bar at the lower edge, from `left` on. True when its button is pressed.
bool messageBar(const Ui& ui, float left, ImU32 ground, std::string_view words, const char* label) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({left, screen.y}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSizeConstraints({screen.x - left, 0.0f}, {screen.x - left, 0.4f * screen.y});
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

void bannerBar(const Ui& ui, float left) {
    if (messageBar(ui, left, ui.palette.error, trMessage(ui.state.banner), "Dismiss"))
        ui.commands.push_back(DismissBanner{});
}

void noticeBar(const Ui& ui, float left) {
    const bool waiting = ui.state.exportWished;
    const std::string words =
        waiting ? say("The export waits for the light. {}", lightProgress(ui.state)) : ui.state.notice;
    if (messageBar(ui, left, ui.palette.accent, words, waiting ? "Cancel" : "Dismiss"))
        ui.commands.push_back(DismissNotice{});
}

}  // namespace halfdisk
