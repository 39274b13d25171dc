// How is a table read so that what is read, what is required and what is unknown can never disagree?
#include "lessons/table_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/suggestions.h"
#include "lessons/utf8.h"

namespace halfdisk {

TableReader::TableReader(std::string file, const TomlTable& table, TextPosition where, std::string what)
    : file_(std::move(file)), table_(table), where_(where), what_(std::move(what)) {}

const TomlValue* TableReader::optional(std::string_view key) {
    known_.push_back(key);
    const TomlEntry* entry = table_.find(key);
    return entry == nullptr ? nullptr : &entry->value;
}

const TomlValue* TableReader::required(std::string_view key) {
    const TomlValue* value = optional(key);
    if (value == nullptr && !missing_) missing_ = key;
    return value;
}

void TableReader::finish() const {
    // A misspelt key is both unknown and missing: the unknown one is where the slip is.
    for (const TomlEntry& entry : table_.entries)
        if (std::find(known_.begin(), known_.end(), entry.key) == known_.end())
            throw InputError(file_, entry.where,
                             fmt::format("unknown key \"{}\" in {}, {}", excerpt(entry.key), what_,
                                         expectedOneOf(entry.key, known_)));
    if (missing_)
        throw InputError(file_, where_, fmt::format("{} has no \"{}\", which is required", what_, *missing_));
}

}  // namespace halfdisk
