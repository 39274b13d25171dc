// What can be done to the scene, and to what is selected in it?
#include <fmt/format.h>

#include "app/key_help.h"
#include "app/language.h"
#include "app/offer.h"
#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostThings = 200;  // of a scene, by name

}  // namespace

void offerEditing(Offer& offer) {
    const AppState& state = offer.state;
    const Editing& editing = state.editing;
    offer.add(editing.on ? "Done with changing the scene" : "Edit the scene", keyOf(KeyRow::edit),
              SetEditing{!editing.on});
    offer.add("Open a file ...", keyOf(KeyRow::files, 1), ShowFiles{true});
    if (!editing.on) return;
    offer.addIf(!editing.history.past.empty(), "Undo", keyOf(KeyRow::history), Undo{});
    offer.addIf(!editing.history.future.empty(), "Redo", keyOf(KeyRow::history, 1), Redo{});
    offer.add(say("Save the scene as {}", editing.path), keyOf(KeyRow::files), SaveScene{editing.path});
    for (const Named<EditAct>& act : kEditActs) {
        const std::string_view key = act.value == EditAct::copy     ? keyOf(KeyRow::selected)
                                     : act.value == EditAct::remove ? keyOf(KeyRow::selected, 1)
                                                                    : std::string_view();
        offer.addIf(serves(act.value, editing.selected), say("{} what is selected", tr(act.name)), key,
                    ActOnSelected{act.value});
    }
    for (const Named<Tool>& tool : kTools)
        offer.addIf(editing.tool != tool.value, say("Tool: {}", tr(tool.name)), {}, SetTool{tool.value});
    // Without a pointer: in the middle of what is seen.
    const Vec2 middle = state.camera.center;
    const double half = 60.0 / state.camera.pixelsPerMeter;
    for (const Named<Tool>& tool : kTools) {
        const Vec2 way(half, tool.value == Tool::box ? half : 0.0);
        offer.addIf(tool.value != Tool::select, say("Add in the middle: {}", tr(tool.name)), {},
                    AddNew{tool.value, middle - way, middle + way});
    }
    offer.add(editing.snap ? "Do not snap" : "Snap to ends and grid", {}, SetSnap{!editing.snap});
    const SceneDescription& scene = state.scene->description;
    const Selection things = everything(scene);
    offer.addIf(things.size() > editing.selected.size(), "Select all", keyOf(KeyRow::choosing),
                SelectThings{things});
    offer.addIf(!editing.selected.empty(), "Select nothing", state.banner.empty() ? "Escape" : "",
                SelectThings{});
    if (things.size() <= kMostThings) {
        const std::vector<std::string> names = namesOf(scene);
        for (std::size_t i = 0; i < things.size(); ++i)
            offer.addIf(editing.selected.single() != things.things[i], say("Select {}", names[i]), {},
                        SelectThings{things.things[i]});
    }
    if (!serves(EditAct::flip, editing.selected)) return;  // no shape
    offer.add("Material: default", {}, SetMaterial{});
    for (const NamedMaterial& material : scene.materials)
        if (material.name != kDefaultMaterial)
            offer.add(say("Material: {}", material.name), {}, SetMaterial{material.name});
    for (const Named<std::size_t>& type : kMaterialTypes)
        offer.add(say("New material: {}", tr(type.name)), {}, AddMaterial{type.value});
}

}  // namespace halfdisk
