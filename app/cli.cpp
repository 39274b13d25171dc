#include "app/cli.h"

#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <sstream>
#include <string>

#include "app/cli_actions.h"
#include "app/cli_commands.h"
#include "app/cli_output.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

constexpr const char* kFooter = R"(Examples:
  halfdisk                                       the first lesson
  halfdisk as-printed:3 --scene my-room.toml     a lesson's third step, in a scene of your own
  halfdisk lessons                               which lessons there are
  halfdisk probe room.toml --at floor:0.5        how much light arrives there
  halfdisk estimators room.toml                  which ways to carry light there are
  halfdisk export caustic:4 -o caustic           what a step shows as pictures, tables and words
  halfdisk eye room.toml -o room.png             what the scene's eye sees
  halfdisk verify                                whether the lessons' claims are true
  halfdisk extremes                              what holds at the edges of numbers, and what does not

Exit codes: 0 success, 1 failure, 2 bad input, 130 stopped by Ctrl-C (what was done is written).)";

/// "halfdisk scene check" of the command that was being parsed.
std::string commandOf(const CLI::App& app) {
    std::string command = app.get_name();
    for (const CLI::App* sub : app.get_subcommands()) command += " " + commandOf(*sub);
    return command;
}

/// The parser would take the next argument for the value that `--samples=` lacks.
void refuseEmptyValues(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        if (argument == "--") return;
        if (argument.size() > 3 && argument.substr(0, 2) == "--" && argument.back() == '=')
            throw InputError(fmt::format("{} lacks a value after the =", argument));
    }
}

int answerParser(const CLI::App& app, const CLI::ParseError& answer) {
    std::ostringstream help;
    if (app.exit(answer, help, help) == 0) {
        writeOutput(help.str());
        return kExitSuccess;
    }
    writeError(fmt::format("{}; see {} --help", answer.what(), commandOf(app)));
    return kExitBadInput;
}

int parseAndRun(int argc, const char* const* argv) {
    CLI::App app(
        "Halfdisk: see global illumination happen in two dimensions.\nWithout a subcommand: opens the "
        "window.",
        "halfdisk");
    app.footer(kFooter);
    app.set_version_flag("--version", fmt::format("halfdisk {}", kVersion));
    app.require_subcommand(0, 1);

    std::filesystem::path lessonsFolder = HALFDISK_LESSONS_DIR;
    Action chosen;
    addWindowCommand(app, chosen, lessonsFolder);
    addLessonsCommand(app, chosen, lessonsFolder);
    addPictureCommands(app, chosen, lessonsFolder);
    addProbeCommand(app, chosen);
    addRenderCommands(app, chosen);
    addEstimatorsCommand(app, chosen);
    addRequirementsCommand(app, chosen);
    addSceneCommand(app, chosen);
    addExtremesCommand(app, chosen);
    addTradeCommand(app, chosen);
    addVerifyCommand(app, chosen, lessonsFolder);

    refuseEmptyValues(argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& answer) {
        return answerParser(app, answer);
    }
    return chosen();
}

}  // namespace

int runCommandLine(int argc, const char* const* argv) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe then is a failed write, which is told
    try {
        return parseAndRun(argc, argv);
    } catch (const InputError& error) {
        writeError(error.what(), !error.file.empty());
        return kExitBadInput;
    } catch (const std::exception& error) {
        writeError(error.what());
        return kExitFailure;
    }
}

}  // namespace halfdisk
