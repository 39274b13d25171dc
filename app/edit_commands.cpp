#include "app/edit_commands.h"

#include <algorithm>
#include <utility>

#include "core/nearest_wall.h"
#include "lessons/sky_image.h"

namespace halfdisk {
namespace {

/// P on the wall of the same name, else on the nearest one.
WallPoint keptPoint(const PreparedScene& before, WallPoint at, const Scene& after) {
    if (at.segment >= before.scene.segments.size()) return {0, 0.5};
    if (const auto same = findSegment(after, before.scene.segmentNames[at.segment])) return {*same, at.t};
    const NearestWall nearest = nearestWall(after, positionOf(before.scene, at));
    return {nearest.segment, std::clamp(nearest.t, 0.0, 1.0)};
}

void show(AppState& state, std::shared_ptr<const PreparedScene> scene) {
    if (state.scene) state.at = keptPoint(*state.scene, state.at, scene->scene);
    state.scene = std::move(scene);
    Editing& editing = state.editing;
    editing.selected = existing(state.scene->description, editing.selected);
    state.eyePixel.reset();
    state.pinnedPixel.reset();
    state.pinnedSide = Side::first;
    state.editing.message.clear();
    ++state.questionId;
    state.playback = {};
}

/// The newest are kept, and always one.
void forgetOld(std::vector<std::shared_ptr<const PreparedScene>>& scenes) {
    std::size_t bytes = 0, kept = 0;
    for (auto scene = scenes.rbegin(); scene != scenes.rend(); ++scene, ++kept) {
        bytes += bytesOf(**scene);
        if (bytes > kUndoBytes && kept > 0) break;
    }
    scenes.erase(scenes.begin(), scenes.end() - static_cast<std::ptrdiff_t>(kept));
}

/// Shows the last scene of `from`; the one that it takes the place of goes to `to`.
void stepBack(AppState& state, std::vector<std::shared_ptr<const PreparedScene>>& from,
              std::vector<std::shared_ptr<const PreparedScene>>& to) {
    if (from.empty()) return;
    Editing& editing = state.editing;
    if (!editing.clean) editing.clean = state.scene;
    to.push_back(state.scene);
    auto scene = std::move(from.back());
    from.pop_back();
    if (scene == editing.aside) editing.aside.reset();
    show(state, std::move(scene));
    editing.start.reset();  // a gesture that is under way goes on from nothing
}

}  // namespace

bool isEdited(const AppState& state) {
    const Editing& editing = state.editing;
    return editing.neverSaved || (editing.clean && !(state.scene->description == editing.clean->description));
}

std::shared_ptr<const PreparedScene> unsavedScene(const AppState& state) {
    return isEdited(state) ? state.scene : state.editing.aside;
}

void replaceScene(AppState& state, std::shared_ptr<const PreparedScene> scene) {
    Editing& editing = state.editing;
    std::string message;
    // Also one that was saved, for it is not what was opened.
    if (state.scene && (editing.clean || editing.neverSaved)) {
        if (isEdited(state)) {
            editing.aside = state.scene;
            message = "Unsaved changes of the last scene were put aside: Undo brings them back.";
        }
        editing.history.past.push_back(state.scene);
        forgetOld(editing.history.past);
    }
    editing.history.future.clear();
    editing.neverSaved = false;
    editing.clean.reset();
    editing.selected = {};
    editing.start.reset();
    editing.message = std::move(message);
    state.scene = std::move(scene);
    state.pinnedPixel.reset();
    state.pinnedSide = Side::first;
}

void editScene(AppState& state, const EditScene& edit) {
    Editing& editing = state.editing;
    editing.message = faultOf(edit.scene);
    if (editing.message.empty() && edit.scene.shapes.empty())
        editing.message = "the last wall must stay: P stands on it";
    if (!editing.message.empty()) return;
    auto changed = std::make_shared<const PreparedScene>(edit.scene);
    if (!editing.clean) editing.clean = state.scene;
    if (!edit.continues) {
        editing.history.past.push_back(state.scene);
        forgetOld(editing.history.past);
    }
    editing.history.future.clear();
    editing.changing = editing.start != nullptr;
    editing.selected = edit.selected;
    show(state, std::move(changed));
}

void beginGesture(AppState& state, const BeginGesture& gesture) {
    Editing& editing = state.editing;
    editing.start = state.scene;
    editing.grabbed = gesture.place;
    editing.handle = gesture.handle;
    editing.before = editing.selected;
    editing.changing = false;
}

void actOnSelected(AppState& state, EditAct act) {
    if (!serves(act, state.editing.selected)) return;
    EditScene edit{state.scene->description, {}, false};
    edit.selected = perform(act, edit.scene, state.editing.selected);
    editScene(state, edit);
}

void addNew(AppState& state, const AddNew& add) {
    EditScene edit{state.scene->description, {}, false};
    edit.selected = addThing(edit.scene, add.tool, add.from, add.to);
    if (!edit.selected.empty()) editScene(state, edit);
}

void moveSelected(AppState& state, const MoveSelected& move) {
    const Editing& editing = state.editing;
    if (editing.selected.empty()) return;
    const bool continues = move.continues && editing.start && editing.changing;
    if (!continues) beginGesture(state, {Vec2(0.0), std::nullopt});
    EditScene edit{state.scene->description, editing.selected, continues};
    moveBy(edit.scene, edit.selected, move.by);
    editScene(state, edit);
}

void setMaterialOfSelected(AppState& state, const std::string& name) {
    EditScene edit{state.scene->description, state.editing.selected, false};
    setMaterial(edit.scene, edit.selected, name);
    if (!(edit.scene == state.scene->description)) editScene(state, edit);
}

void addMaterialToSelected(AppState& state, std::size_t kind) {
    EditScene edit{state.scene->description, state.editing.selected, false};
    setMaterial(edit.scene, edit.selected, addMaterial(edit.scene, kind));
    editScene(state, edit);
}

void chooseSkyImage(AppState& state, const std::string& image) {
    EditScene edit{state.scene->description, state.editing.selected, false};
    Sky& sky = edit.scene.environment;
    try {
        sky.light.strip = image.empty() ? std::vector<Rgb>() : readSky(usualFolder(state) / image);
        sky.image = image;
        editScene(state, edit);
    } catch (const std::exception& error) {
        state.editing.message = error.what();
    }
}

void undo(AppState& state) {
    stepBack(state, state.editing.history.past, state.editing.history.future);
}

void redo(AppState& state) {
    stepBack(state, state.editing.history.future, state.editing.history.past);
}

void setEditing(AppState& state, bool on) {
    state.editing.on = on;
    state.editing.start.reset();
    if (on) nameFile(state);
    state.fitCamera = false;  // what is drawn shall stay under the pointer
}

}  // namespace halfdisk
