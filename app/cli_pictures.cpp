// halfdisk screenshot, export and tour: how is a lesson drawn to a file, without a display?
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/cli_state.h"
#include "app/window_host.h"

namespace halfdisk {
namespace {

/// What `screenshot` and `export` have in common.
struct PictureTexts {
    OpeningTexts opening;
    std::string output;
    std::string size = fmt::format("{}x{}", PictureSize{}.width, PictureSize{}.height);
    std::string scale = "1";
};

/// What is to be seen must be said here; the window has a first lesson.
OpeningRequest openingOf(const PictureTexts& texts, const std::filesystem::path& lessonsFolder) {
    if (!texts.opening.lesson && !texts.opening.scene && !texts.opening.state)
        throw InputError("nothing to draw, expected LESSON[:STEP], --scene FILE or --state TEXT");
    return openingRequest(texts.opening, lessonsFolder);
}

template <class Request>
Request requestOf(const PictureTexts& texts, const std::filesystem::path& lessonsFolder) {
    const PictureSize size = sizeArgument("--size", texts.size);
    const double scale = numberArgument("--scale", texts.scale, kLeastPictureScale, kMostPictureScale);
    return Request{openingOf(texts, lessonsFolder), texts.output, size, scale};
}

void addPictureOptions(CLI::App& command, PictureTexts& texts) {
    addOpening(command, texts.opening);
    command
        .add_option("--size", texts.size,
                    fmt::format("pixels, each {} to {}", kLeastPictureSize, kMostPictureSize))
        ->type_name("WxH")
        ->capture_default_str();
    command
        .add_option("--scale", texts.scale,
                    fmt::format("size of text and controls, {} to {}", kLeastPictureScale, kMostPictureScale))
        ->type_name("S")
        ->capture_default_str();
}

void addScreenshot(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto texts = std::make_shared<PictureTexts>();
    CLI::App* command =
        app.add_subcommand("screenshot", "draw one step of a lesson to a PNG file, without a display");
    command->add_option("-o,--output", texts->output, "the picture")->type_name("FILE.png")->required();
    addPictureOptions(*command, *texts);
    addLessonsFolder(*command, lessonsFolder);
    command->footer(
        "Examples:\n"
        "  halfdisk screenshot gather -o gather.png\n"
        "  halfdisk screenshot as-printed:3 -o slide.png --size 1920x1080 --scale 1.5\n"
        "  halfdisk screenshot --state @seen.halfdisk -o seen.png");
    command->callback([&chosen, texts, &lessonsFolder] {
        chosen = [texts, &lessonsFolder] {
            return runScreenshot(requestOf<ScreenshotRequest>(*texts, lessonsFolder));
        };
    });
}

void addExport(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto texts = std::make_shared<PictureTexts>();
    CLI::App* command =
        app.add_subcommand("export", "write what one step shows to a folder: PNG, SVG, CSV, JSON and words");
    command->add_option("-o,--output", texts->output, "folder for the files; made if it is not there")
        ->type_name("DIR")
        ->required();
    addPictureOptions(*command, *texts);
    addLessonsFolder(*command, lessonsFolder);
    command->footer(
        "Waits until the light is complete, and prints the files:\n"
        "  screen.png              the whole screen\n"
        "  canvas.svg              the canvas\n"
        "  PLOT.svg, PLOT.csv      integrand, error, histogram, profile, difference, eye,\n"
        "                          strategies: those that the step shows\n"
        "  field.csv               the field of light, a row for each cell\n"
        "  tree.json               the recorded run that is shown: settings, P, events, rays; of castRay "
        "calls (a tree)\n"
        "  state.txt               all of it in words, for those who cannot see the canvas\n"
        "  state.halfdisk          the state itself: halfdisk --state @state.halfdisk\n"
        "The same state gives the same bytes. Words are in the language of --language; heads of tables, "
        "keys\n"
        "and names are English, for other programs.\n\n"
        "Examples:\n"
        "  halfdisk export caustic:4 -o caustic\n"
        "  halfdisk export caustic:4 -o kaustik --language de\n"
        "  halfdisk export --scene room.toml -o room --size 1920x1080 --scale 2\n"
        "  halfdisk export --state - -o seen < state.halfdisk");
    command->callback([&chosen, texts, &lessonsFolder] {
        chosen = [texts, &lessonsFolder] {
            return runExport(requestOf<ExportRequest>(*texts, lessonsFolder));
        };
    });
}

void addTour(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto folder = std::make_shared<std::string>(), language = std::make_shared<std::string>();
    CLI::App* command =
        app.add_subcommand("tour", "draw every step of every lesson to DIR/<slug>-<step>.png");
    command->add_option("-o,--output", *folder, "folder for the pictures; made if it is not there")
        ->type_name("DIR")
        ->required();
    addLanguage(*command, *language);
    addLessonsFolder(*command, lessonsFolder);
    command->footer("Example:\n  halfdisk tour -o pictures");
    command->callback([&chosen, folder, language, &lessonsFolder] {
        chosen = [folder, language, &lessonsFolder] {
            return runTour({lessonsFolder, *folder, languageArgument("--language", *language)});
        };
    });
}

/// For scripts that choose between the window and the tour; not in the help.
void addHasDisplay(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("has-display", "exit code 0 if a window could be opened, else 1");
    command->group("");
    command->callback([&chosen] { chosen = [] { return hasDisplay() ? kExitSuccess : kExitFailure; }; });
}

}  // namespace

void addPictureCommands(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    addScreenshot(app, chosen, lessonsFolder);
    addExport(app, chosen, lessonsFolder);
    addTour(app, chosen, lessonsFolder);
    addHasDisplay(app, chosen);
}

}  // namespace halfdisk
