// What can be changed? The settings of castRay: all are shown, the step's one control is unlocked.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/choose.h"
#include "app/draw_text.h"
#include "app/share_text.h"

namespace halfdisk {
namespace {

void whileUnlocked(const Ui& ui, Control control, const auto& draw) {
    ImGui::BeginDisabled(!ui.state.isUnlocked(control));
    draw();
    ImGui::EndDisabled();
}

/// What the defect alone does to E, as a bar to the left (less) or right (more) of the exact value. Nothing
/// if not measured.
void damageBar(const Ui& ui, const Damage& damage, bool on, ImVec2 min, ImVec2 max) {
    const Palette& palette = ui.palette;
    const float numberWidth = textSize("+1000 %").x;
    const float middle = (min.x + max.x - numberWidth) / 2, half = (max.x - numberWidth - min.x) / 2;
    const bool none = std::abs(damage.relative) < 4.0 * damage.error + 5e-4;
    const float reach = none ? 0.0f : half * static_cast<float>(std::clamp(damage.relative, -1.0, 1.0));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float inset = (max.y - min.y) / 4;
    list.AddRectFilled({std::min(middle, middle + reach), min.y + inset},
                       {std::max(middle, middle + reach), max.y - inset},
                       on ? palette.estimate : palette.rayDark);
    list.AddLine({middle, min.y}, {middle, max.y}, palette.exact, 2 * ui.scale);
    const std::string words = none ? "none" : fmt::format("{:+.0f} %", 100.0 * damage.relative);
    drawText(ui, {max.x, min.y + (max.y - min.y - ImGui::GetFontSize()) / 2},
             on ? palette.ink : palette.inkSoft, words, Align::right);
}

void defectSwitches(const Ui& ui, Settings& settings) {
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4 * ui.scale, 2 * ui.scale});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 3 * ui.scale});
    bool all = settings.defects == DefectSet::all();
    if (checkbox(ui.widgets, "as printed", all)) settings.defects = all ? DefectSet::all() : DefectSet{};
    tooltip("run the published listing with all of its switchable defects");
    const bool damages = ui.state.shows(View::damage);
    if (damages)
        drawText(ui,
                 {ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x,
                  ImGui::GetItemRectMin().y + 2 * ui.scale},
                 ui.palette.inkSoft, "E, each alone", Align::right);
    const float left = ImGui::GetFrameHeight() + textSize("lightsign").x + 16 * ui.scale;
    for (const Named<Defect>& defect : kDefects) {
        const ImVec2 origin = ImGui::GetCursorScreenPos();
        const float right = origin.x + ImGui::GetContentRegionAvail().x;
        bool on = settings.defects.has(defect.value);
        const std::string name(defect.name);
        if (checkbox(ui.widgets, name.c_str(), on)) settings.defects.set(defect.value, on);
        tooltip(defect.meaning);
        if (!damages || !ui.state.answer) continue;
        for (const Damage& damage : ui.state.answer->damage)
            if (damage.defect == defect.value)
                damageBar(ui, damage, on, {origin.x + left, origin.y},
                          {right, origin.y + ImGui::GetFrameHeight()});
    }
    ImGui::PopStyleVar(2);
}

/// On the steps that have one of them, and wherever everything is unlocked.
void pictureSwitches(const Ui& ui) {
    const Step* step = ui.state.currentStep();
    const bool ofStep = step && (step->show & kPictureSet) != ViewSet{};
    if (step && !ofStep && !ui.state.unlockAll) return;
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    const auto choice = [&](const char* label, View view, const char* meaning) {
        bool on = ui.state.shows(view);
        if (toggle(ui.widgets, label, on, {width, 0})) ui.commands.push_back(SetView{view, on});
        tooltip(meaning);
    };
    choice("Eye", View::eye, "the strip that the scene's eye sees (V)");
    sameLineIfFits("Field", width);
    choice("Field", View::field, "the picture of the room: the light that passes every place (Shift V)");
    choice("Profile", View::profile, "the light that arrives along P's wall");
    sameLineIfFits("Paths", width);
    choice("Paths", View::paths,
           "ways that light takes: orange straight from a light, blue once a wall has scattered it");
    if (!ui.state.shows(View::strategies) && !ui.state.unlockAll &&
        !(step && step->show.has(View::strategies)))
        return;
    choice("Strategies", View::strategies,
           "every strategy (s, t) of paths from both ends, with its share of the light");
}

/// On the steps that have one of them, and wherever everything is unlocked.
void instrumentSwitches(const Ui& ui) {
    const Step* step = ui.state.currentStep();
    const bool ofStep = step && (step->show & kInstrumentSet) != ViewSet{};
    if (step && !ofStep && !ui.state.unlockAll) return;
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    for (const auto& [label, view] : {std::pair{"Trade", View::trade}, std::pair{"Extremes", View::extremes},
                                      std::pair{"Requirements", View::requirements}}) {
        sameLineIfFits(label, width);
        bool on = ui.state.shows(view);
        if (toggle(ui.widgets, label, on, {width, 0})) ui.commands.push_back(SetView{view, on});
        for (const Named<View>& entry : kViews)
            if (entry.value == view) tooltip(entry.meaning);
    }
}

}  // namespace

void controlsPanel(const Ui& ui) {
    const AppState& state = ui.state;
    Settings settings = state.settings;
    const float labels = textSize("maxDepth").x + 2 * ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x - labels);
    whileUnlocked(ui, Control::samples, [&] {
        dragNumber<std::uint32_t>(ui.widgets, "N", settings.samples,
                                  {1, kMostLessonSamples, 5.0f, "%u", true});
        tooltip(kSamplesInfo.meaning);
    });
    whileUnlocked(ui, Control::depth, [&] {
        dragNumber<std::uint32_t>(ui.widgets, "maxDepth", settings.maxDepth,
                                  {0, kMostLessonDepth, 0.03f, "%u", false});
        tooltip(kMaxDepthInfo.meaning);
    });
    whileUnlocked(ui, Control::seed, [&] {
        dragNumber<std::uint64_t>(ui.widgets, "seed", settings.seed,
                                  {0, kSeedInfo.most, 0.2f, nullptr, false});
        tooltip(kSeedInfo.meaning);
    });
    whileUnlocked(ui, Control::sampler, [&] { choose(ui, "sampler", kSamplers, settings.sampler); });
    whileUnlocked(ui, Control::emitters, [&] { choose(ui, "emitters", kEmitters, settings.emitters); });
    ImGui::PopItemWidth();

    const Step* step = state.currentStep();
    const bool aboutDefects = settings.defects != DefectSet{} || (step && step->unlock == Control::defects);
    if (aboutDefects || state.unlockAll || !step)
        whileUnlocked(ui, Control::defects, [&] { defectSwitches(ui, settings); });
    if (!(settings == state.settings)) ui.commands.push_back(SetSettings{settings});

    if (!state.rules.kiosk) {
        pictureSwitches(ui);
        instrumentSwitches(ui);
    }
    if (!step) return;
    if (state.rules.kiosk) {
        if (button(ui.widgets, "Reset", {-1, 0})) ui.commands.push_back(ResetStep{});
        tooltip("everything as the step began (R)");
        return;
    }
    bool unlockAll = state.unlockAll;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float half = (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x) / 2;
    const float width = std::max(half, textSize("Unlock all").x + 2 * style.FramePadding.x);
    if (toggle(ui.widgets, "Unlock all", unlockAll, {width, 0})) ui.commands.push_back(UnlockAll{unlockAll});
    tooltip("Each step unlocks one control. This unlocks all of them; Reset returns to the step.");
    sameLineIfFits("Reset", width);
    if (button(ui.widgets, "Reset", {width, 0})) ui.commands.push_back(ResetStep{});
    tooltip("everything as the step began (R)");
    const float copy = std::max(half, textSize("Copy state").x + 2 * style.FramePadding.x);
    if (button(ui.widgets, "Copy state", {copy, 0})) ImGui::SetClipboardText(shareText(state).c_str());
    tooltip(
        "all that is seen here as one text, to be pasted into another Halfdisk (Ctrl C, Ctrl V) or started "
        "with: "
        "halfdisk --state TEXT");
    sameLineIfFits("Export", copy);
    if (button(ui.widgets, "Export", {copy, 0})) ui.commands.push_back(ExportSeen{});
    tooltip(
        "all that is seen here to files in a new folder: PNG, SVG, CSV, JSON and words (Ctrl E). It waits "
        "until the light is complete.");
}

}  // namespace halfdisk
