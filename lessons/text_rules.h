// Which texts may a lesson hold, and how is marked-up prose read from a file? Shared by lessons and their
// translations.
#pragma once

#include "lessons/prose.h"
#include "lessons/value_reader.h"

namespace halfdisk {

inline constexpr TextRule kHeadingRule{200, false, false};
inline constexpr TextRule kMeaningRule{1000, true, false};
inline constexpr TextRule kProseRule{20'000, true, false};

/// Prose of the key `key`; `text` is the whole file's, for the place of a fault. Throws InputError.
Prose readProse(const std::string& file, std::string_view text, std::string_view key, const TomlValue& value,
                const std::vector<Term>& terms);

}  // namespace halfdisk
