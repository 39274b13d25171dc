// Which texts may a lesson hold, and how are they read from a file? Shared by lessons and their translations.
#pragma once

#include "lessons/named_numbers.h"
#include "lessons/prose.h"
#include "lessons/value_reader.h"

namespace halfdisk {

inline constexpr TextRule kHeadingRule{200, false, false};
inline constexpr TextRule kMeaningRule{1000, true, false};
inline constexpr TextRule kProseRule{20'000, true, false};

/// The file that words stand in, and what they may name.
struct LessonText {
    std::string file;
    std::string_view text;  ///< the whole file's, for the place of a fault
    NamedNumbers numbers{};
};

/// The words of the key `key`, with their numbers written out. Throws InputError.
std::string readWords(const LessonText& text, std::string_view key, const TomlValue& value,
                      const TextRule& rule);

/// The same of prose, which may name terms. Throws InputError.
Prose readProse(const LessonText& text, std::string_view key, const TomlValue& value,
                const std::vector<Term>& terms);

/// Where `snippet` stands in a text, at or behind `from`; `from` itself if it is not found: what was written
/// with TOML's own escapes is not.
TextPosition placeOf(std::string_view text, TextPosition from, std::string_view snippet);

}  // namespace halfdisk
