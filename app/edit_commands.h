// What do the commands that change a scene do? commands.cpp sorts them out; here is what happens.
#pragma once

#include "app/commands.h"

namespace halfdisk {

/// Whether the scene differs from what was opened or saved last.
bool isEdited(const AppState& state);

/// What would be lost if the program ended now; null: nothing. The scene that is seen, or one put aside.
std::shared_ptr<const PreparedScene> unsavedScene(const AppState& state);

/// The sky's picture is named only where it lies beside the file; elsewhere its colours are written
/// themselves.
SceneDescription withoutFarImage(SceneDescription scene, const std::filesystem::path& file);

/// Shows another scene in place of the present one, which can be brought back if it was edited.
void replaceScene(AppState& state, std::shared_ptr<const PreparedScene> scene);

/// The folder of the scene that is shown; of one without a file the current folder.
std::filesystem::path usualFolder(const AppState& state);

void editScene(AppState& state, const EditScene& edit);
void beginGesture(AppState& state, const BeginGesture& gesture);
void actOnSelected(AppState& state, EditAct act);
void addNew(AppState& state, const AddNew& add);
void moveSelected(AppState& state, const MoveSelected& move);
void setMaterialOfSelected(AppState& state, const std::string& name);
void addMaterialToSelected(AppState& state, std::size_t kind);
/// A picture that cannot be read is told, and the sky stays.
void chooseSkyImage(AppState& state, const std::string& image);
void undo(AppState& state);
void redo(AppState& state);
void saveEdited(AppState& state, const SaveScene& save);
void setEditing(AppState& state, bool on);

/// Where the scene is saved, if it is another one than the present name is for: a file of one's own has its
/// own name, one of the course gets another.
void nameFile(AppState& state);

}  // namespace halfdisk
