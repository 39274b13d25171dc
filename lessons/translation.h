// How does a lesson speak another language? Its words stand in a file of their own; what a step shows and
// sets does not.
//
// lessons/de/NN-slug.toml is the German of lessons/NN-slug.toml: title, section, every [[term]] (name,
// meaning) and every [[step]] (title, prose, and ask, answer, goal where the step has them), in the same
// order. Their texts may show the numbers of the lesson's claims, with decimalPoint = "," if the language
// writes one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lessons/lesson.h"
#include "lessons/toml_document.h"

namespace halfdisk {

/// "." or ",". Throws InputError.
std::string readDecimalPoint(const std::string& file, const TomlValue& value);

/// Replaces the words of `lesson` by those of the file. Throws InputError if the file's terms or steps are
/// not the lesson's.
void translateLesson(Lesson& lesson, const std::filesystem::path& file);

/// The same by the file that belongs to the language (`de`); the lesson stays as it is if there is none, or
/// no language.
void translateLesson(Lesson& lesson, const std::string& language);

struct Titles {
    std::string lesson;
    std::vector<std::string> steps;
};

/// What a lesson and its steps are called in the language; nothing if no file says so. A file that cannot be
/// read says nothing here: the message comes when the lesson is opened.
std::optional<Titles> translatedTitles(const std::filesystem::path& lessonFile, const std::string& language);

}  // namespace halfdisk
