#include "app/cli_state.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "app/cli_arguments.h"

namespace halfdisk {
namespace {

constexpr std::string_view kOption = "--state";
constexpr std::size_t kMostBytes = std::size_t{32} << 20;  // more than any state takes

std::string contentsOf(std::FILE& file, std::string_view what) {
    std::string bytes;
    char block[1 << 16];
    while (const std::size_t count = std::fread(block, 1, sizeof block, &file)) {
        bytes.append(block, count);
        if (bytes.size() > kMostBytes) failArgument(kOption, what, "is too long, expected a state's text");
    }
    if (std::ferror(&file))
        failArgument(kOption, what,
                     fmt::format("cannot be read: {}", std::generic_category().message(errno)));
    return bytes;
}

}  // namespace

std::string stateArgument(const std::string& text) {
    if (text == "-") return contentsOf(*stdin, text);
    if (text.empty() || text.front() != '@') return text;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(text.c_str() + 1, "rbe"),
                                                               &std::fclose);
    if (!file)
        failArgument(kOption, text,
                     fmt::format("cannot be opened: {}", std::generic_category().message(errno)));
    return contentsOf(*file, text);
}

void addLanguage(CLI::App& command, std::string& language) {
    command.add_option("--language", language, "of the window and the lessons: en, de")->type_name("CODE");
}

void addOpening(CLI::App& command, OpeningTexts& texts) {
    command
        .add_option("LESSON", texts.lesson,
                    "lesson and step, by slug or number: as-printed, as-printed:3 or 07:3")
        ->type_name("[:STEP]");
    command.add_option("--scene", texts.scene, "scene file to show in place of the lesson's own")
        ->type_name("FILE");
    command
        .add_option(
            "--state", texts.state,
            "all that somebody saw, as \"Copy state\" gave it; @FILE: from a file, -: from standard input")
        ->type_name("TEXT");
    addLanguage(command, texts.language);
}

OpeningRequest openingRequest(const OpeningTexts& texts, const std::filesystem::path& lessonsFolder) {
    OpeningRequest request;
    request.lessonsFolder = lessonsFolder;
    if (texts.state && (texts.lesson || texts.scene))
        throw InputError("--state holds the lesson and the scene, expected no other");
    request.language = languageArgument("--language", texts.language);
    if (texts.state) request.shared = stateArgument(*texts.state);
    if (texts.lesson) request.lesson = parseLessonRef(*texts.lesson);
    if (texts.scene) request.scene = *texts.scene;
    return request;
}

}  // namespace halfdisk
