// What can be changed? The settings of castRay: all are shown, the step's one control is unlocked.
#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

template <class Enum, std::size_t Count>
bool choose(const Ui& ui, const char* label, const std::array<Named<Enum>, Count>& table, Enum& value) {
    std::array<std::string_view, Count> names;
    int index = 0;
    std::string_view meaning;
    for (std::size_t i = 0; i < Count; ++i) {
        names[i] = table[i].name;
        if (table[i].value != value) continue;
        index = static_cast<int>(i);
        meaning = table[i].meaning;
    }
    const bool changed = combo(ui.widgets, label, index, names);
    tooltip(meaning);
    if (changed) value = table[static_cast<std::size_t>(index)].value;
    return changed;
}

void whileUnlocked(const Ui& ui, Control control, const auto& draw) {
    ImGui::BeginDisabled(!ui.state.isUnlocked(control));
    draw();
    ImGui::EndDisabled();
}

void defectSwitches(const Ui& ui, Settings& settings) {
    bool all = settings.defects == DefectSet::all();
    if (checkbox(ui.widgets, "as printed", all)) settings.defects = all ? DefectSet::all() : DefectSet{};
    tooltip("run the published listing with all of its switchable defects");
    const float column = ImGui::GetContentRegionAvail().x / 2;
    bool left = true;
    for (const Named<Defect>& defect : kDefects) {
        if (!left) ImGui::SameLine(column);
        bool on = settings.defects.has(defect.value);
        const std::string name(defect.name);
        if (checkbox(ui.widgets, name.c_str(), on)) settings.defects.set(defect.value, on);
        tooltip(defect.meaning);
        left = !left;
    }
    if (left) return;
    ImGui::SameLine(column);
    ImGui::Dummy({1, ImGui::GetFrameHeight()});
}

}  // namespace

void controlsPanel(const Ui& ui) {
    const AppState& state = ui.state;
    Settings settings = state.settings;
    ImGui::PushItemWidth(0.58f * ImGui::GetContentRegionAvail().x);
    whileUnlocked(ui, Control::samples, [&] {
        dragNumber<std::uint32_t>(ui.widgets, "N", settings.samples,
                                  {1, kMostLessonSamples, 1.0f, "%u", true});
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

    if (!step) return;
    bool unlockAll = state.unlockAll;
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
    if (toggle(ui.widgets, "Unlock all", unlockAll, {width, 0})) ui.commands.push_back(UnlockAll{unlockAll});
    tooltip("Each step unlocks one control. This unlocks all of them; Reset returns to the step.");
    ImGui::SameLine();
    if (button(ui.widgets, "Reset", {width, 0})) ui.commands.push_back(ResetStep{});
    tooltip("everything as the step began (R)");
}

}  // namespace halfdisk
