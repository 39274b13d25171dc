// With what is a scene changed? Tools, what the selected thing is, and where the scene goes.
#include <fmt/format.h>

#include <algorithm>

#include "app/edit_commands.h"
#include "app/key_editor.h"
#include "app/panels.h"

namespace halfdisk {
namespace {

float part(int count) {
    const float all = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
    return (all - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
}

void tools(const Ui& ui) {
    const float width = part(3);
    int column = 0;
    for (const Named<Tool>& tool : kTools) {
        if (column % 3 != 0) sameLineIfFits(tool.name, width);
        ++column;
        bool on = ui.state.editing.tool == tool.value;
        if (toggle(ui.widgets, std::string(tool.name).c_str(), on, {width, 0}))
            ui.commands.push_back(SetTool{tool.value});
        tooltip(tool.meaning);
    }
}

void historyButtons(const Ui& ui) {
    const History& history = ui.state.editing.history;
    const float width = part(3);
    const auto choice = [&](const char* label, bool there, const Command& command, const char* meaning) {
        ImGui::BeginDisabled(!there);
        if (button(ui.widgets, label, {width, 0})) ui.commands.push_back(command);
        tooltip(meaning);
        ImGui::EndDisabled();
    };
    choice("Undo", !history.past.empty(), Undo{}, "take the last change back (Ctrl Z)");
    sameLineIfFits("Redo", width);
    choice("Redo", !history.future.empty(), Redo{}, "and make it again (Ctrl Y)");
    sameLineIfFits("Snap", width);
    bool snap = ui.state.editing.snap;
    if (toggle(ui.widgets, "Snap", snap, {width, 0})) ui.commands.push_back(SetSnap{snap});
    tooltip("to the ends of things and to a grid; Alt: not now; Shift: angles of 15 degrees");
}

/// Changes that follow each other while one control is held are one.
void change(const Ui& ui, SceneDescription scene, std::optional<Thing> thing) {
    const Editing& editing = ui.state.editing;
    const bool continues = editing.start && editing.changing;
    if (!editing.start) ui.commands.push_back(BeginGesture{Vec2(0.0), std::nullopt});
    ui.commands.push_back(EditScene{std::move(scene), thing, continues});
}

void thingButtons(const Ui& ui, Thing thing) {
    const SceneDescription& scene = ui.state.scene->description;
    const float width = part(3);
    const auto act = [&](const char* label, const char* meaning, const auto& action) {
        if (button(ui.widgets, label, {width, 0})) {
            SceneDescription changed = scene;
            const std::optional<Thing> left = action(changed);
            ui.commands.push_back(EditScene{std::move(changed), left, false});
        }
        tooltip(meaning);
    };
    constexpr double kStep = 0.1, kDegrees = 15.0, kFactor = 1.1;
    act("Copy", "a second one beside it (Ctrl D)",
        [&](SceneDescription& s) { return std::optional(copyOf(s, thing, Vec2(kStep, kStep))); });
    sameLineIfFits("Delete", width);
    act("Delete", "take it away (Delete)", [&](SceneDescription& s) {
        remove(s, thing);
        return std::optional<Thing>();
    });
    sameLineIfFits("Turn", width);
    act("Turn", "by 15 degrees", [&](SceneDescription& s) {
        turnBy(s, thing, kDegrees);
        return std::optional(thing);
    });
    if (thing.kind != ThingKind::shape) return;
    act("Larger", "by a tenth", [&](SceneDescription& s) {
        scaleBy(s, thing, kFactor);
        return std::optional(thing);
    });
    sameLineIfFits("Smaller", width);
    act("Smaller", "by as much", [&](SceneDescription& s) {
        scaleBy(s, thing, 1.0 / kFactor);
        return std::optional(thing);
    });
    sameLineIfFits("Flip", width);
    act("Flip", "front and back change places", [&](SceneDescription& s) {
        flip(s, thing);
        return std::optional(thing);
    });
}

/// The material of the selected shape, which others may share; and new ones.
bool editMaterial(const Ui& ui, SceneDescription& scene, Shape& shape) {
    bool changed = false;
    const std::string& name = shape.material;
    for (NamedMaterial& named : scene.materials) {
        if (named.name != name) continue;
        text(ui.widgets, fmt::format("{}: {}", named.name, kMaterialTypes[named.material.index()].name));
        tooltip(kMaterialTypes[named.material.index()].meaning);
        KeyEditor keys{ui, ui.state.scene->description};
        std::visit([&](auto& material) { keysOf(keys, material); }, named.material);
        changed = keys.changed;
    }
    std::vector<std::string_view> types{"add one ..."};
    for (const auto& type : kMaterialTypes) types.push_back(type.name);
    int chosen = 0;
    if (!combo(ui.widgets, "new", chosen, types) || chosen == 0) return changed;
    shape.material = addMaterial(scene, static_cast<std::size_t>(chosen - 1));
    return true;
}

void inspector(const Ui& ui) {
    const AppState& state = ui.state;
    const std::vector<Thing> things = thingsOf(state.scene->description);
    std::vector<std::string> names = namesOf(state.scene->description);
    names.insert(names.begin(), "nothing");
    int index = 0;
    for (std::size_t i = 0; i < things.size(); ++i)
        if (state.editing.selected == things[i]) index = static_cast<int>(i) + 1;
    const std::vector<std::string_view> views(names.begin(), names.end());
    if (combo(ui.widgets, "selected", index, views))
        ui.commands.push_back(SelectThing{
            index == 0 ? std::nullopt : std::optional(things[static_cast<std::size_t>(index - 1)])});
    if (!state.editing.selected || !exists(state.scene->description, *state.editing.selected)) return;
    const Thing thing = *state.editing.selected;
    thingButtons(ui, thing);
    SceneDescription scene = state.scene->description;
    KeyEditor keys{ui, state.scene->description};
    bool changed = false;
    switch (thing.kind) {
        case ThingKind::shape: {
            Shape& shape = scene.shapes[thing.index];
            keysOf(keys, shape);
            changed = editMaterial(ui, scene, shape);
            break;
        }
        case ThingKind::light:
            std::visit([&](auto& light) { keysOf(keys, light); }, scene.lights[thing.index]);
            break;
        case ThingKind::eye:
            keysOf(keys, *scene.eye);
            break;
    }
    if (keys.changed || changed) change(ui, std::move(scene), thing);
}

void saving(const Ui& ui) {
    const Editing& editing = ui.state.editing;
    std::string path = editing.path;
    if (inputText(ui.widgets, "file", path)) ui.commands.push_back(SetScenePath{path});
    tooltip("where the scene is saved; a name that ends with .toml");
    if (button(ui.widgets, isEdited(ui.state) ? "Save*" : "Save", {part(2), 0}))
        ui.commands.push_back(SaveScene{editing.path});
    tooltip("write the scene file (Ctrl S)");
    sameLineIfFits("Close", part(1));
    if (button(ui.widgets, "Done", {part(1), 0})) ui.commands.push_back(SetEditing{false});
    tooltip("back to the lesson, in the changed scene; Reset brings the lesson's own back");
    if (!editing.message.empty()) textWrapped(ui.widgets, editing.message);
}

}  // namespace

void editPanel(const Ui& ui) {
    const Editing& editing = ui.state.editing;
    // What was held in the inspector is held no more.
    if (editing.start && ui.state.grip == Grip::none && !ImGui::IsAnyItemActive())
        ui.commands.push_back(SetGrip{Grip::none});
    tools(ui);
    historyButtons(ui);
    const float labels = textSize("thickness").x + 2 * ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::PushItemWidth(std::max(ImGui::GetContentRegionAvail().x - labels, 60 * ui.scale));
    ImGui::Separator();
    inspector(ui);
    ImGui::Separator();
    saving(ui);
    ImGui::PopItemWidth();
}

}  // namespace halfdisk
