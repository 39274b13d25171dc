// What does the text of an argument mean? A number, a point, a name of a closed set, or one clear message.
//
// All throw InputError, whose text starts with the option's name.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/cli_actions.h"
#include "core/math.h"
#include "core/settings.h"
#include "lessons/input_error.h"
#include "lessons/suggestions.h"
#include "lessons/utf8.h"

namespace halfdisk {

/// A finite decimal number, '.' in every locale; nothing else before or after it.
std::optional<double> parseNumber(std::string_view text);

/// Digits, or a number with an exponent that is whole: 1e6. Nothing if it does not fit.
std::optional<std::uint64_t> parseWhole(std::string_view text);

/// `--samples: 'x' is not ...`. Quotes the text safely.
[[noreturn]] void failArgument(std::string_view option, std::string_view text, std::string_view problem);

/// A number within [least, most].
double numberArgument(std::string_view option, std::string_view text, double least, double most);

/// A whole number in the range of `info`.
std::uint64_t wholeArgument(std::string_view option, std::string_view text, const NumberInfo& info);

inline constexpr NumberInfo kThreadsInfo{"threads", "threads", "threads; the answer does not depend on it",
                                         1,         256,       1};

/// `--threads`; none: as many as the machine has.
unsigned threadsArgument(const std::optional<std::string>& text);

/// `X,Y` in metres, each within the range that a scene file allows. `expected` ends the message.
Vec2 pointArgument(std::string_view option, std::string_view text, std::string_view expected = "X,Y");

/// `X,Y` of any length but zero; returned at unit length.
Vec2 directionArgument(std::string_view option, std::string_view text);

/// `en` (which gives an empty code) or one that there is.
std::string languageArgument(std::string_view option, std::string_view text);

/// `WxH` in pixels.
PictureSize sizeArgument(std::string_view option, std::string_view text);

/// Names of kDefects separated by commas.
DefectSet defectsArgument(std::string_view option, std::string_view text);

/// `uniform, cosine, stratified`.
template <class Table>
std::string joinedNames(const Table& table, std::string_view separator = ", ") {
    return fmt::format("{}", fmt::join(namesOf(table), separator));
}

/// A line `  name  meaning` per entry, for help.
template <class Table>
std::string describedNames(const Table& table) {
    std::string lines;
    for (const auto& entry : table) lines += fmt::format("  {:<11} {}\n", entry.name, entry.meaning);
    return lines;
}

/// The entry of that name.
template <class Enum, std::size_t Count>
Enum namedArgument(std::string_view option, std::string_view text,
                   const std::array<Named<Enum>, Count>& table) {
    if (const std::optional<Enum> value = valueOf(table, text)) return *value;
    failArgument(option, text, fmt::format("is unknown, {}", expectedOneOf(text, namesOf(table))));
}

}  // namespace halfdisk
