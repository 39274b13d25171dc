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

void editScene(AppState& state, const EditScene& edit);
void undo(AppState& state);
void redo(AppState& state);
void saveEdited(AppState& state, const SaveScene& save);
void setEditing(AppState& state, bool on);

}  // namespace halfdisk
