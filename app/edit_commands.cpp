#include "app/edit_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
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

/// Whether somebody wrote comments into the file, which a file that is written anew would lack.
bool hasComments(const std::filesystem::path& file) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.find('#') != std::string::npos) return true;
    return false;
}

/// Of the scene that is shown; empty: none.
std::filesystem::path openedFile(const AppState& state) {
    return state.sceneOverride.empty() && state.lesson ? state.lesson->scenePath : state.sceneOverride;
}

/// Those files stay as they are unless somebody insists.
bool isOfCourse(const AppState& state) {
    if (state.sceneOverride.empty()) return true;
    std::error_code none;
    const std::filesystem::path way =
        std::filesystem::relative(state.sceneOverride, state.lessonsFolder, none);
    return !none && !way.empty() && *way.begin() != "..";
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

SceneDescription withoutFarImage(SceneDescription scene, const std::filesystem::path& file) {
    std::error_code none;
    std::string& image = scene.environment.image;
    if (!image.empty() && !std::filesystem::exists(file.parent_path() / image, none)) image.clear();
    return scene;
}

std::filesystem::path usualFolder(const AppState& state) {
    const std::filesystem::path folder = openedFile(state).parent_path();
    return folder.empty() ? std::filesystem::path(".") : folder;
}

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

void saveEdited(AppState& state, const SaveScene& save) {
    Editing& editing = state.editing;
    const std::filesystem::path file(save.path);
    if (save.path.empty() || file.extension() != ".toml") {
        editing.message = "a scene file's name ends with .toml";
        return;
    }
    std::error_code none;
    const bool there = std::filesystem::exists(file, none), comments = there && hasComments(file);
    const bool isOwn = editing.savedAs == save.path || (editing.origin == save.path && !isOfCourse(state));
    if (!editing.confirmed && (comments || (there && !isOwn))) {
        editing.confirmed = true;
        editing.message = fmt::format("{} {}. Save again to write over it.", save.path,
                                      comments ? "has comments, which would go" : "is there already");
        return;
    }
    try {
        saveScene(withoutFarImage(state.scene->description, file), file);
        editing.clean = state.scene;
        editing.neverSaved = false;
        editing.savedAs = save.path;
        remember(state.recent, file);
        editing.message = fmt::format("saved: {}", save.path);
    } catch (const std::exception& error) {
        editing.message = error.what();
    }
    editing.confirmed = false;
}

void nameFile(AppState& state) {
    Editing& editing = state.editing;
    const std::filesystem::path opened = openedFile(state);
    if (!editing.path.empty() && editing.origin == opened.string()) return;
    const std::string stem = opened.stem().string();
    editing.path = !isOfCourse(state) ? opened.string()
                   : stem.empty()     ? "scene.toml"
                                      : "my_" + stem + ".toml";
    editing.origin = opened.string();
    editing.savedAs.clear();
    editing.confirmed = false;
}

void setEditing(AppState& state, bool on) {
    state.editing.on = on;
    state.editing.start.reset();
    if (on) nameFile(state);
    state.fitCamera = false;  // what is drawn shall stay under the pointer
}

}  // namespace halfdisk
