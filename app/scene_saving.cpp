// Where does a scene that was changed go? Its file, and what is asked before another one is written over.
#include <fmt/format.h>

#include <fstream>

#include "app/edit_commands.h"

namespace halfdisk {
namespace {

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
        editing.message =
            comments ? fmt::format("{} has comments, which would go. Save again to write over it.", save.path)
                     : fmt::format("{} is there already. Save again to write over it.", save.path);
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

}  // namespace halfdisk
