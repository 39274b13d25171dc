// Which lessons are there, and which one, at which step, is meant by `as-printed:3`?
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/input_error.h"
#include "lessons/lesson.h"

namespace halfdisk {

struct LessonEntry {
    int number = -1;  ///< -1, and listed last: the file's name is not NN-slug.toml
    std::string slug;
    std::string title;
    int steps = 0;
    std::vector<std::string> stepTitles;  ///< as many
    std::filesystem::path path;
    std::string error;  ///< not empty: the lesson cannot be used, and this is the one message why
};

/// The lessons of a folder (its *.toml files), sorted by number. A broken lesson is listed with its error and
/// hides no other. Throws InputError only if the folder cannot be read.
std::vector<LessonEntry> listLessons(const std::filesystem::path& folder);

/// `as-printed`, `as-printed:3`, `03`, `3:2`.
struct LessonRef {
    std::string lesson;  ///< a slug, or a number with or without leading zeros
    int step = 1;        ///< counts from 1
    bool operator==(const LessonRef&) const = default;
};

/// Throws InputError (without a file) if `text` is no such reference.
LessonRef parseLessonRef(std::string_view text);

/// The entry that is meant. Throws InputError (without a file) that names the lessons there are.
const LessonEntry& findLesson(const std::vector<LessonEntry>& lessons, const LessonRef& ref);

/// Index into lesson.steps. Throws InputError (without a file) that tells the number of steps.
std::size_t stepIndex(const Lesson& lesson, const LessonRef& ref);

}  // namespace halfdisk
