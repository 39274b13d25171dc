// halfdisk [LESSON[:STEP]] [--scene FILE]: what does the program do without a subcommand? It opens the
// window.
#include <memory>
#include <optional>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "lessons/input_error.h"

namespace halfdisk {
namespace {

struct WindowTexts {
    std::optional<std::string> lesson, scene;
    std::vector<std::string> locks, hidden;
    bool kiosk = false;
    std::optional<std::string> state;
    std::string language;
};

WindowRequest windowRequest(const WindowTexts& texts, const std::filesystem::path& lessonsFolder) {
    WindowRequest request{lessonsFolder, {}, {}, {}};
    for (const std::string& text : texts.locks) addLock(request.rules, text);
    for (const std::string& text : texts.hidden) addHidden(request.rules, text);
    request.rules.kiosk = texts.kiosk;
    if (texts.state && (texts.lesson || texts.scene))
        throw InputError("--state holds the lesson and the scene, expected no other");
    request.shared = texts.state;
    request.language = languageArgument("--language", texts.language);
    if (texts.lesson) request.lesson = parseLessonRef(*texts.lesson);
    if (texts.scene) request.scene = *texts.scene;
    return request;
}

}  // namespace

void addLessonsFolder(CLI::App& command, std::filesystem::path& lessonsFolder) {
    command.add_option("--lessons", lessonsFolder, "folder of the lesson files")
        ->type_name("DIR")
        ->capture_default_str();
}

void addLanguage(CLI::App& command, std::string& language) {
    command.add_option("--language", language, "of the window and the lessons: en, de")->type_name("CODE");
}

void addWindowCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto texts = std::make_shared<WindowTexts>();
    app.add_option("LESSON", texts->lesson,
                   "lesson to open: slug or number, e.g. as-printed or 07:2 (the second step)")
        ->type_name("[:STEP]");
    app.add_option("--scene", texts->scene, "scene file to show in place of the lesson's own")
        ->type_name("FILE");
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
    app.add_option("--state", texts->state, "all that somebody saw, as \"Copy state\" gave it")
        ->type_name("TEXT");
    addLanguage(app, texts->language);
    addLessonsFolder(app, lessonsFolder);
    // Called whenever parsing succeeds, after the callbacks of the subcommands.
    app.final_callback([&app, &chosen, texts, &lessonsFolder] {
        if (app.get_subcommands().empty()) {
            chosen = [texts, &lessonsFolder] { return runWindow(windowRequest(*texts, lessonsFolder)); };
        } else if (texts->lesson) {
            throw InputError("'" + *texts->lesson + "' was not expected before or after a command");
        } else if (texts->scene) {
            throw InputError("--scene was not expected before a command");
        } else if (texts->state) {
            throw InputError("--state was not expected before a command");
        } else if (!texts->language.empty()) {
            throw InputError("--language was not expected before a command");
        } else if (texts->kiosk || !texts->locks.empty() || !texts->hidden.empty()) {
            throw InputError("--lock, --hide and --kiosk were not expected before a command");
        }
    });
}

}  // namespace halfdisk
