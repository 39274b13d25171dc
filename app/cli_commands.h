// Which commands are there? Each adds itself to the parser and, once parsed, says what to do.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "core/settings.h"

namespace halfdisk {

/// What the parsed command line asks for; returns the exit code. Runs after parsing, so that its errors are
/// its own.
using Action = std::function<int()>;

/// The program without a subcommand.
void addWindowCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder);
void addLessonsCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder);
void addPictureCommands(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder);
void addProbeCommand(CLI::App& app, Action& chosen);
void addRenderCommands(CLI::App& app, Action& chosen);  ///< eye, profile, field
void addEstimatorsCommand(CLI::App& app, Action& chosen);
void addRequirementsCommand(CLI::App& app, Action& chosen);
void addSceneCommand(CLI::App& app, Action& chosen);
void addExtremesCommand(CLI::App& app, Action& chosen);
void addTradeCommand(CLI::App& app, Action& chosen);
void addVerifyCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder);

/// `--lessons DIR`, before or after the subcommand.
void addLessonsFolder(CLI::App& command, std::filesystem::path& lessonsFolder);

/// An option of the number's name, whose value is told by `letter` in the help.
void addNumber(CLI::App& command, const NumberInfo& info, const char* letter, std::string& text);

/// `--language CODE` of what the window shows; the command line itself speaks English.
void addLanguage(CLI::App& command, std::string& language);

}  // namespace halfdisk
