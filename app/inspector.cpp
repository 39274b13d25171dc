// What is it that is selected, and what are its values? One thing, what several have in common, or the sky.
#include <fmt/format.h>

#include <utility>

#include "app/edit_commands.h"
#include "app/key_editor.h"
#include "app/language.h"
#include "app/panels.h"
#include "lessons/sky_edit.h"

namespace halfdisk {
namespace {

/// Changes that follow each other while one control is held are one.
void change(const Ui& ui, SceneDescription scene) {
    const Editing& editing = ui.state.editing;
    const bool continues = editing.start && editing.changing;
    if (!editing.start) ui.commands.push_back(BeginGesture{Vec2(0.0), std::nullopt});
    ui.commands.push_back(EditScene{std::move(scene), editing.selected, continues});
}

void actButtons(const Ui& ui) {
    const float width = partOfRow(3);
    int column = 0;
    for (const Named<EditAct>& act : kEditActs) {
        if (!serves(act.value, ui.state.editing.selected)) continue;
        if (column++ % 3 != 0) sameLineIfFits(act.name, width);
        if (button(ui.widgets, std::string(act.name).c_str(), {width, 0}))
            ui.commands.push_back(ActOnSelected{act.value});
        tooltip(act.meaning);
    }
}

/// A material of the scene, which several shapes may share; and new ones, for what is selected.
bool editMaterial(const Ui& ui, SceneDescription& scene, const std::string& name) {
    bool changed = false;
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
    if (combo(ui.widgets, "new", chosen, types) && chosen > 0)
        ui.commands.push_back(AddMaterial{static_cast<std::size_t>(chosen - 1)});
    return changed;
}

/// What lies where no wall is: seen while nothing is selected.
void skyInspector(const Ui& ui) {
    const SceneDescription& now = ui.state.scene->description;
    ImGui::PushFont(ui.fonts.strong);
    text(ui.widgets, "The sky");
    ImGui::PopFont();
    const std::vector<std::string_view> names = namesOf(kSkyKinds);
    const SkyKind kind = kindOf(now.environment);
    int index = static_cast<int>(kind);
    SceneDescription scene = now;
    Sky& sky = scene.environment;
    const bool chosen = combo(ui.widgets, "kind", index, names);
    tooltip(kSkyKinds[static_cast<std::size_t>(kind)].meaning);
    if (chosen) {
        const auto wanted = static_cast<SkyKind>(index);
        if (wanted == SkyKind::image) return ui.commands.push_back(ChooseSkyImage{"sky.png"});
        setKind(sky, wanted);
        return ui.commands.push_back(EditScene{std::move(scene), {}, false});
    }
    KeyEditor keys{ui, now};
    keysOf(keys, sky);
    if (sky.image != now.environment.image) {
        ui.commands.push_back(ChooseSkyImage{sky.image});
    } else if (keys.changed) {
        change(ui, std::move(scene));
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
    textWrapped(ui.widgets, kind == SkyKind::strip || kind == SkyKind::image
                                ? "radiance in W/(m rad); the angles' colours are factors of it"
                                : "radiance in W/(m rad)");
    ImGui::PopStyleColor();
}

/// Several at once: what shapes have in common.
void commonInspector(const Ui& ui) {
    const Selection& selected = ui.state.editing.selected;
    const SceneDescription& now = ui.state.scene->description;
    std::vector<Thing> shapes;
    for (const Thing thing : selected.things)
        if (thing.kind == ThingKind::shape) shapes.push_back(thing);
    if (shapes.empty()) return;
    SceneDescription scene = now;
    Shape common = scene.shapes[shapes.back().index];
    const Shape before = common;
    const auto differs = [&](const auto& field) {
        for (const Thing thing : shapes)
            if (!(scene.shapes[thing.index].*field == before.*field)) return true;
        return false;
    };
    KeyEditor keys{ui, now};
    keys.optional("material", common.material, std::string(), NameRule{});
    const bool materials = differs(&Shape::material), emissions = differs(&Shape::emission),
               sides = differs(&Shape::twoSided);
    keys.optional("emission", common.emission, Rgb(0.0), kLightRule);
    keys.optional("twoSided", common.twoSided, false, FlagRule{});
    std::string unlike;
    for (const auto& [differ, key] :
         {std::pair{materials, "material"}, std::pair{emissions, "emission"}, std::pair{sides, "twoSided"}})
        if (differ) unlike += (unlike.empty() ? "" : ", ") + std::string(key);
    if (!unlike.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.palette.inkSoft);
        textWrapped(ui.widgets, say("They differ in {}; a change sets all.", unlike));
        ImGui::PopStyleColor();
    }
    bool changed = keys.changed;
    for (const Thing thing : shapes) {
        Shape& shape = scene.shapes[thing.index];
        if (!(common.material == before.material)) shape.material = common.material;
        if (!(common.emission == before.emission)) shape.emission = common.emission;
        if (common.twoSided != before.twoSided) shape.twoSided = common.twoSided;
    }
    if (!materials) changed = editMaterial(ui, scene, before.material) || changed;
    if (changed) change(ui, std::move(scene));
}

/// Which things are selected: one by its name, or how many.
void selectedCombo(const Ui& ui) {
    const SceneDescription& scene = ui.state.scene->description;
    const Selection& selected = ui.state.editing.selected;
    const std::vector<Thing> things = thingsOf(scene);
    std::vector<std::string> names = namesOf(scene);
    names.insert(names.begin(), "nothing");
    names.push_back("all");
    int index = 0;
    for (std::size_t i = 0; i < things.size(); ++i)
        if (selected.single() == things[i]) index = static_cast<int>(i) + 1;
    if (selected.size() > 1) {
        index = static_cast<int>(names.size());
        names.push_back(say("{} things", selected.size()));
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    if (!combo(ui.widgets, "selected", index, views)) return;
    const auto chosen = static_cast<std::size_t>(index);
    ui.commands.push_back(SelectThings{chosen == 0               ? Selection()
                                       : chosen <= things.size() ? Selection(things[chosen - 1])
                                                                 : everything(scene)});
}

}  // namespace

void inspector(const Ui& ui) {
    const AppState& state = ui.state;
    selectedCombo(ui);
    const Selection& selected = state.editing.selected;
    if (selected.empty()) return skyInspector(ui);
    if (existing(state.scene->description, selected).size() != selected.size()) return;
    actButtons(ui);
    if (selected.size() > 1) return commonInspector(ui);
    const Thing thing = *selected.primary();
    SceneDescription scene = state.scene->description;
    KeyEditor keys{ui, state.scene->description};
    bool changed = false;
    switch (thing.kind) {
        case ThingKind::shape: {
            Shape& shape = scene.shapes[thing.index];
            keysOf(keys, shape);
            changed = editMaterial(ui, scene, std::string(shape.material));
            break;
        }
        case ThingKind::light:
            std::visit([&](auto& light) { keysOf(keys, light); }, scene.lights[thing.index]);
            break;
        case ThingKind::eye:
            keysOf(keys, *scene.eye);
            break;
    }
    if (keys.changed || changed) change(ui, std::move(scene));
}

}  // namespace halfdisk
