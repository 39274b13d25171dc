// How does a lesson, a scene or what somebody else saw get on the screen? The commands' part that reads
// files.
//
// All but openLesson, openScene and openDescribed (commands.h) may leave the state half changed when they
// throw.
#pragma once

#include "app/cli_actions.h"
#include "app/commands.h"

namespace halfdisk {

/// What the command line asks for. Throws InputError.
AppState openRequested(const OpeningRequest& request);

/// The light is to be computed again, and the recorded run starts at its beginning.
void askAnew(AppState& state);

/// As the step sets it, in the lesson's own scene.
void enterStep(AppState& state, std::size_t step);

void goTo(AppState& state, const LessonRef& ref);
void showSceneAlone(AppState& state, const std::filesystem::path& file);
/// A lesson or a scene, told apart by its name.
void openAny(AppState& state, const std::filesystem::path& file);
/// What somebody else saw. The window, and what the class may do, stay as they are.
void showShared(AppState& state, const std::string& text);
/// The same lesson, step and settings in other words; empty: English.
void setLanguage(AppState& state, const std::string& code);
/// Reads the files that are shown again.
void reload(AppState& state);

}  // namespace halfdisk
