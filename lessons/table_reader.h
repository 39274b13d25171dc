// How is a table read so that what is read, what is required and what is unknown can never disagree?
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/toml_document.h"

namespace halfdisk {

/// Looks keys up and remembers which ones were asked for: whatever else the table holds is unknown. So one
/// list of look-ups is the whole description of a table.
class TableReader {
 public:
    /// `what` names the table in messages, e.g. "[[circle]]".
    TableReader(std::string file, const TomlTable& table, TextPosition where, std::string what);

    /// The value of a key, or null if the table does not have it.
    const TomlValue* optional(std::string_view key);
    /// The same, but finish() complains if it is missing.
    const TomlValue* required(std::string_view key);

    /// Throws InputError for the first unknown key (at the key), else for the first missing one (at the
    /// table).
    void finish() const;

    const std::string& file() const { return file_; }
    TextPosition where() const { return where_; }
    /// Whether a key is there, and the value of one that is, without asking for it.
    bool has(std::string_view key) const { return table_.find(key) != nullptr; }
    const TomlValue& at(std::string_view key) const { return table_.find(key)->value; }

 private:
    std::string file_;
    const TomlTable& table_;
    TextPosition where_;
    std::string what_;
    std::vector<std::string_view> known_;
    std::optional<std::string_view> missing_;
};

}  // namespace halfdisk
