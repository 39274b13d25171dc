// halfdisk screenshot, halfdisk tour: how is a lesson drawn to a file, without a display?
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/cli_actions.h"
#include "app/cli_arguments.h"
#include "app/cli_commands.h"
#include "app/window_host.h"

namespace halfdisk {
namespace {

struct ScreenshotTexts {
    std::string lesson, output;
    std::optional<std::string> scene;
    std::string size = fmt::format("{}x{}", PictureSize{}.width, PictureSize{}.height);
    std::string scale = "1";
    std::string language;
};

ScreenshotRequest screenshotRequest(const ScreenshotTexts& texts,
                                    const std::filesystem::path& lessonsFolder) {
    ScreenshotRequest request{lessonsFolder, parseLessonRef(texts.lesson), {}, texts.output, {}, 1.0};
    if (texts.scene) request.scene = *texts.scene;
    request.size = sizeArgument("--size", texts.size);
    request.language = languageArgument("--language", texts.language);
    request.scale = numberArgument("--scale", texts.scale, kLeastPictureScale, kMostPictureScale);
    return request;
}

void addScreenshot(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto texts = std::make_shared<ScreenshotTexts>();
    CLI::App* command =
        app.add_subcommand("screenshot", "draw one step of a lesson to a PNG file, without a display");
    command->add_option("LESSON", texts->lesson, "lesson and step: as-printed:3 or 07:3")
        ->type_name("[:STEP]")
        ->required();
    command->add_option("-o,--output", texts->output, "the picture")->type_name("FILE.png")->required();
    command
        ->add_option("--size", texts->size,
                     fmt::format("pixels, each {} to {}", kLeastPictureSize, kMostPictureSize))
        ->type_name("WxH")
        ->capture_default_str();
    command
        ->add_option(
            "--scale", texts->scale,
            fmt::format("size of text and controls, {} to {}", kLeastPictureScale, kMostPictureScale))
        ->type_name("S")
        ->capture_default_str();
    command->add_option("--scene", texts->scene, "scene file to show in place of the lesson's own")
        ->type_name("FILE");
    addLanguage(*command, texts->language);
    addLessonsFolder(*command, lessonsFolder);
    command->footer(
        "Examples:\n"
        "  halfdisk screenshot gather -o gather.png\n"
        "  halfdisk screenshot as-printed:3 -o slide.png --size 1920x1080 --scale 1.5");
    command->callback([&chosen, texts, &lessonsFolder] {
        chosen = [texts, &lessonsFolder] { return runScreenshot(screenshotRequest(*texts, lessonsFolder)); };
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
    addTour(app, chosen, lessonsFolder);
    addHasDisplay(app, chosen);
}

}  // namespace halfdisk
