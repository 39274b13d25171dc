// halfdisk lessons: which lessons are there?
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "app/cli_actions.h"
#include "app/cli_commands.h"
#include "app/cli_output.h"
#include "lessons/lesson_file.h"
#include "lessons/lesson_list.h"

namespace halfdisk {
namespace {

struct ListedLesson {
    LessonEntry entry;
    std::string section;
};

std::vector<ListedLesson> listedLessons(const std::filesystem::path& folder) {
    std::vector<ListedLesson> lessons;
    for (LessonEntry& entry : listLessons(folder)) {
        ListedLesson listed{std::move(entry), {}};
        try {
            if (listed.entry.error.empty()) listed.section = loadLesson(listed.entry.path).section;
        } catch (const InputError& changedMeanwhile) {
            listed.entry.error = changedMeanwhile.what();
        }
        lessons.push_back(std::move(listed));
    }
    return lessons;
}

Json lessonJson(const ListedLesson& lesson) {
    const LessonEntry& entry = lesson.entry;
    Json object;
    object["number"] = entry.number >= 0 ? Json(entry.number) : Json(nullptr);
    object["slug"] = entry.slug;
    if (!entry.error.empty()) {
        object["error"] = entry.error;
        return object;
    }
    object["title"] = entry.title;
    object["section"] = lesson.section;
    object["steps"] = entry.steps;
    return object;
}

std::string lineOf(const ListedLesson& lesson) {
    const LessonEntry& entry = lesson.entry;
    const std::string number = entry.number >= 0 ? fmt::format("{:02}", entry.number) : "--";
    if (!entry.error.empty())
        return fmt::format("{}  {:<14}  cannot be used: {}\n", number, entry.slug, entry.error);
    return fmt::format("{}  {:<14}  {:<18}  {:>2} steps  {}\n", number, entry.slug, entry.title, entry.steps,
                       lesson.section);
}

int runLessons(const std::filesystem::path& folder, bool asJson) {
    Json list = Json::array();
    std::string lines;
    bool broken = false;
    for (const ListedLesson& lesson : listedLessons(folder)) {
        list.push_back(lessonJson(lesson));
        lines += lineOf(lesson);
        broken = broken || !lesson.entry.error.empty();
    }
    if (asJson) {
        writeJson(Json{{"lessons", list}});
    } else {
        writeOutput(lines.empty() ? fmt::format("no lessons in {}\n", folder.string()) : lines);
    }
    return broken ? kExitBadInput : kExitSuccess;
}

}  // namespace

void addLessonsCommand(CLI::App& app, Action& chosen, std::filesystem::path& lessonsFolder) {
    const auto asJson = std::make_shared<bool>(false);
    CLI::App* command =
        app.add_subcommand("lessons", "list the lessons: number, slug, title, steps, section");
    command->add_flag("--json", *asJson, "print one JSON object");
    addLessonsFolder(*command, lessonsFolder);
    command->footer(
        "A lesson whose file cannot be used is listed with its error; the exit code is then "
        "2.\n\nExamples:\n"
        "  halfdisk lessons\n"
        "  halfdisk lessons --lessons ~/my-course --json");
    command->callback([&chosen, asJson, &lessonsFolder] {
        chosen = [asJson, &lessonsFolder] { return runLessons(lessonsFolder, *asJson); };
    });
}

}  // namespace halfdisk
