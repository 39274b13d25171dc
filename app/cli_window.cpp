// halfdisk [LESSON[:STEP]] [--scene FILE]: what does the program do without a subcommand? It opens the
// window.
#include <memory>
#include <optional>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/cli_state.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

struct WindowTexts {
    OpeningTexts opening;
    std::vector<std::string> locks, hidden;
    bool kiosk = false;
};

WindowRequest windowRequest(const WindowTexts& texts, const std::filesystem::path& lessonsFolder) {
    WindowRequest request;
    for (const std::string& text : texts.locks) addLock(request.rules, text);
    for (const std::string& text : texts.hidden) addHidden(request.rules, text);
    request.rules.kiosk = texts.kiosk;
    request.opening = openingRequest(texts.opening, lessonsFolder);
    return request;
}

}  // namespace

void addLessonsFolder(CLI::App& command, std::filesystem::path& lessonsFolder) {
    command.add_option("--lessons", lessonsFolder, "folder of the lesson files")
        ->type_name("DIR")
        ->capture_default_str();
}

void addNumber(CLI::App& command, const NumberInfo& info, const char* letter, std::string& text) {
    command.add_option(fmt::format("--{}", info.name), text, std::string(info.meaning))
        ->type_name(letter)
        ->capture_default_str();
}

void addWindowCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto texts = std::make_shared<WindowTexts>();
    addOpening(app, texts->opening);
    app.add_option("--lock", texts->locks,
                   fmt::format("for a class: this control stays as it is, or at a value; may be repeated: {}",
                               joinedNames(kControls)))
        ->type_name("CONTROL[=VALUE]")
        ->allow_extra_args(false);
    app.add_option("--hide", texts->hidden,
                   fmt::format("for a class: leave out {}, or a view; may be repeated: {}",
                               joinedNames(kPanels), joinedNames(kViews)))
        ->type_name("PANEL|VIEW")
        ->allow_extra_args(false);
    app.add_flag(
        "--kiosk", texts->kiosk,
        "for a class: this lesson only; no other files, no editing, nothing unlocked but what the step does");
    addLessonsFolder(app, lessonsFolder);
    // Called whenever parsing succeeds, after the callbacks of the subcommands.
    app.final_callback([&app, &chosen, texts, &lessonsFolder] {
        if (app.get_subcommands().empty()) {
            chosen = [texts, &lessonsFolder] { return runWindow(windowRequest(*texts, lessonsFolder)); };
        } else if (texts->opening.lesson) {
            throw InputError("'" + *texts->opening.lesson + "' was not expected before or after a command");
        } else if (texts->opening.scene) {
            throw InputError("--scene was not expected before a command");
        } else if (texts->opening.state) {
            throw InputError("--state was not expected before a command");
        } else if (!texts->opening.language.empty()) {
            throw InputError("--language was not expected before a command");
        } else if (texts->kiosk || !texts->locks.empty() || !texts->hidden.empty()) {
            throw InputError("--lock, --hide and --kiosk were not expected before a command");
        }
    });
}

}  // namespace halfdisk
