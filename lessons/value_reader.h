// How does a TOML value become a number, a point, a colour or a name, or else one clear message?
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/math.h"
#include "core/settings.h"
#include "lessons/suggestions.h"
#include "lessons/toml_document.h"
#include "lessons/utf8.h"

namespace halfdisk {

/// Which numbers are allowed, and how a message says so.
struct NumberRule {
    double least, most;
    std::string_view expected;
};

/// Which whole numbers are allowed.
struct WholeRule {
    std::uint64_t least, most;
};

/// Which texts are allowed.
struct TextRule {
    std::size_t mostCharacters;
    bool manyLines = false;
    bool mayBeEmpty = true;
};

/// `1 point`, `3 points`.
std::string counted(std::size_t count, std::string_view what);

/// Throws InputError at `where` of the file.
[[noreturn]] void failAt(const std::string& file, TextPosition where, std::string text);

/// Each reads one value of the key `key`; throws InputError at the value (or the wrong element of it).
bool readFlag(const std::string& file, std::string_view key, const TomlValue& value);
double readNumber(const std::string& file, std::string_view key, const TomlValue& value,
                  const NumberRule& rule);
std::uint64_t readWhole(const std::string& file, std::string_view key, const TomlValue& value,
                        const WholeRule& rule);
Vec2 readPoint(const std::string& file, std::string_view key, const TomlValue& value, const NumberRule& rule,
               std::string_view expected = "two numbers [x, y]");
/// One number for all channels, or three.
Rgb readColour(const std::string& file, std::string_view key, const TomlValue& value, const NumberRule& rule);
std::string readText(const std::string& file, std::string_view key, const TomlValue& value,
                     const TextRule& rule);
/// A name that `NAME:T` can carry: 1 ... 200 characters, no ':' and no control characters.
std::string readName(const std::string& file, std::string_view key, const TomlValue& value);
/// The same rules for a name that is itself a key.
void checkName(const std::string& file, TextPosition where, std::string_view name);
const TomlArray& readArray(const std::string& file, std::string_view key, const TomlValue& value,
                           std::string_view expected);
const TomlTable& readTable(const std::string& file, std::string_view key, const TomlValue& value);

/// Throws InputError for a value that is none of `names`.
[[noreturn]] void failNamed(const std::string& file, std::string_view key, const TomlValue& value,
                            const std::vector<std::string_view>& names);

/// One name of a closed set.
template <class Enum, std::size_t Count>
Enum readNamed(const std::string& file, std::string_view key, const TomlValue& value,
               const std::array<Named<Enum>, Count>& table) {
    if (const auto* name = std::get_if<std::string>(&value.data))
        if (const auto found = valueOf(table, std::string_view(*name))) return *found;
    failNamed(file, key, value, namesOf(table));
}

}  // namespace halfdisk
