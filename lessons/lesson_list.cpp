// Which lessons are there, and which one, at which step, is meant by `as-printed:3`?
#include "lessons/lesson_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <tuple>

#include "lessons/lesson_file.h"
#include "lessons/scene_file.h"
#include "lessons/suggestions.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

/// A whole number of at most nine digits.
std::optional<int> parseWhole(std::string_view text) {
    if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string_view::npos)
        return std::nullopt;
    return std::stoi(std::string(text));
}

LessonEntry entryOf(const fs::path& path) {
    LessonEntry entry;
    entry.path = path;
    entry.slug = path.stem().string();
    if (const auto name = parseLessonFileName(path)) {
        entry.number = name->number;
        entry.slug = name->slug;
    }
    try {
        const Lesson lesson = loadLesson(path);
        entry.title = lesson.title;
        entry.steps = static_cast<int>(lesson.steps.size());
        for (const Step& step : lesson.steps) entry.stepTitles.push_back(step.title);
    } catch (const InputError& error) {
        entry.error = error.what();
    }
    return entry;
}

/// A scene may lie beside the lessons.
bool isScene(const fs::path& path) {
    try {
        return !loadScene(path).shapes.empty();
    } catch (const InputError&) {
        return false;
    }
}

/// Of two lessons with one number or one slug, only the first by file name can be addressed.
void markClashes(std::vector<LessonEntry>& lessons) {
    for (std::size_t i = 0; i < lessons.size(); ++i)
        for (std::size_t k = 0; k < i && lessons[i].error.empty(); ++k) {
            if (lessons[k].number < 0) continue;
            const bool sameNumber = lessons[i].number == lessons[k].number;
            if (!sameNumber && lessons[i].slug != lessons[k].slug) continue;
            lessons[i].error =
                fmt::format("{}: its {} is that of {}, expected another", lessons[i].path.string(),
                            sameNumber ? "number" : "slug", lessons[k].path.filename().string());
        }
}

}  // namespace

std::vector<LessonEntry> listLessons(const fs::path& folder) {
    std::error_code error;
    fs::directory_iterator file(folder, error);
    if (error)
        throw InputError(folder.string(),
                         fmt::format("the folder of lessons cannot be read: {}", error.message()));
    std::vector<LessonEntry> lessons;
    for (; file != fs::directory_iterator(); file.increment(error)) {
        const fs::path& path = file->path();
        // Editors leave hidden copies beside a file that is being edited.
        const bool hidden = path.filename().string().front() == '.';
        if (path.extension() != ".toml" || hidden) continue;
        LessonEntry entry = entryOf(path);
        if (entry.error.empty() || parseLessonFileName(path) || !isScene(path))
            lessons.push_back(std::move(entry));
    }
    std::sort(lessons.begin(), lessons.end(), [](const LessonEntry& a, const LessonEntry& b) {
        const bool aLast = a.number < 0, bLast = b.number < 0;
        return std::tie(aLast, a.number, a.path) < std::tie(bLast, b.number, b.path);
    });
    markClashes(lessons);
    return lessons;
}

LessonRef parseLessonRef(std::string_view text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    LessonRef ref{std::string(text.substr(0, colon))};
    if (ref.lesson.empty())
        throw InputError(fmt::format(
            "\"{}\" names no lesson, expected LESSON or LESSON:STEP, e.g. \"gather:2\"", excerpt(text)));
    if (colon == text.size()) return ref;
    const auto step = parseWhole(text.substr(colon + 1));
    if (!step || *step < 1)
        throw InputError(fmt::format("\"{}\" names no step, expected LESSON:STEP with a step of 1 or more",
                                     excerpt(text)));
    ref.step = *step;
    return ref;
}

const LessonEntry& findLesson(const std::vector<LessonEntry>& lessons, const LessonRef& ref) {
    const auto number = parseWhole(ref.lesson);
    const auto found = std::find_if(lessons.begin(), lessons.end(), [&](const LessonEntry& entry) {
        return number ? entry.number == *number : entry.slug == ref.lesson;
    });
    if (found != lessons.end()) return *found;
    std::vector<std::string_view> slugs;
    for (const LessonEntry& entry : lessons) slugs.push_back(entry.slug);
    if (slugs.empty())
        throw InputError(fmt::format("there is no lesson \"{}\": the folder has none", excerpt(ref.lesson)));
    throw InputError(
        fmt::format("there is no lesson \"{}\", {}", excerpt(ref.lesson), expectedOneOf(ref.lesson, slugs)));
}

std::size_t stepIndex(const Lesson& lesson, const LessonRef& ref) {
    const int steps = static_cast<int>(lesson.steps.size());
    if (ref.step < 1 || ref.step > steps)
        throw InputError(fmt::format("the lesson \"{}\" has no step {}, expected a step from 1 to {}",
                                     lesson.slug, ref.step, steps));
    return static_cast<std::size_t>(ref.step - 1);
}

}  // namespace halfdisk
