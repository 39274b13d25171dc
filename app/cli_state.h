// Which state is meant by `--state`, and what is to be opened? For the window, pictures and exports alike.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "app/app_state.h"
#include "app/cli_actions.h"

namespace halfdisk {

/// What was typed: a lesson, a scene, or a state in place of both.
struct OpeningTexts {
    std::optional<std::string> lesson, scene, state;
    std::string language{};
};

/// Adds LESSON, --scene and --state.
void addOpening(CLI::App& command, OpeningTexts& texts);

/// Checked but for the files. Reads what --state names. Throws InputError.
OpeningRequest openingRequest(const OpeningTexts& texts, const std::filesystem::path& lessonsFolder);

/// The text itself, of `@FILE` what the file holds, of `-` what comes on standard input: a shell takes no
/// more than 128 kB as an argument. Throws InputError.
std::string stateArgument(const std::string& text);

}  // namespace halfdisk
