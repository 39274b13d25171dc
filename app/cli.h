// What does the command line ask for? One subcommand per file: cli_window, cli_lessons, cli_pictures,
// cli_probe_command, cli_render_command, cli_estimators, cli_scene.
#pragma once

#include <string_view>

namespace halfdisk {

/// As in the project's CMake file; a test holds them equal.
inline constexpr std::string_view kVersion = "0.1.0";

/// Does what the arguments say and returns the exit code (cli_actions.h). Throws nothing: every error becomes
/// one line on stderr.
int runCommandLine(int argc, const char* const* argv);

}  // namespace halfdisk
