// What does a TOML text say, in file order and with the place of everything? (The parser itself stays in the
// .cpp.)
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lessons/input_error.h"

namespace halfdisk {

struct TomlEntry;
struct TomlValue;
using TomlArray = std::vector<TomlValue>;

/// Keys and values in the order of the file.
struct TomlTable {
    std::vector<TomlEntry> entries;

    const TomlEntry* find(std::string_view key) const;  ///< null if there is none
};

/// A date or a time: legal TOML that no file of ours uses.
struct TomlDate {};

struct TomlValue {
    TextPosition where;
    std::variant<bool, std::int64_t, double, std::string, TomlDate, TomlArray, TomlTable> data;

    /// "a string", "a whole number", ...: for messages.
    std::string_view kind() const;
};

struct TomlEntry {
    std::string key;
    TextPosition where;  ///< of the key
    TomlValue value;
};

/// Parses TOML. Throws InputError at the first fault: invalid UTF-8, syntax, nesting deeper than any sane
/// file.
TomlValue parseToml(std::string_view text, const std::string& file);

}  // namespace halfdisk
