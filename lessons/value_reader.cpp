// How does a TOML value become a number, a point, a colour or a name, or else one clear message?
#include "lessons/value_reader.h"

#include <fmt/format.h>

#include <cmath>

namespace halfdisk {
namespace {

constexpr std::size_t kMaxNameCharacters = 200;

[[noreturn]] void wrongType(const std::string& file, std::string_view key, const TomlValue& value,
                            std::string_view expected) {
    failAt(file, value.where, fmt::format("\"{}\" is {}, expected {}", excerpt(key), value.kind(), expected));
}

/// 5 and 5.0 are the same number.
bool asNumber(const TomlValue& value, double& number) {
    if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
        number = static_cast<double>(*whole);
        return true;
    }
    if (const auto* real = std::get_if<double>(&value.data)) {
        number = *real;
        return true;
    }
    return false;
}

double checked(const std::string& file, std::string_view key, const TomlValue& value, double number,
               const NumberRule& rule) {
    if (!(number >= rule.least && number <= rule.most))  // NaN fails both
        failAt(file, value.where,
               fmt::format("\"{}\" is {}, expected {}", excerpt(key), number, rule.expected));
    return number;
}

}  // namespace

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void failAt(const std::string& file, TextPosition where, std::string text) {
    throw InputError(file, where, std::move(text));
}

bool readFlag(const std::string& file, std::string_view key, const TomlValue& value) {
    const auto* flag = std::get_if<bool>(&value.data);
    if (flag == nullptr) wrongType(file, key, value, "true or false");
    return *flag;
}

double readNumber(const std::string& file, std::string_view key, const TomlValue& value,
                  const NumberRule& rule) {
    double number = 0.0;
    if (!asNumber(value, number)) wrongType(file, key, value, rule.expected);
    return checked(file, key, value, number, rule);
}

std::uint64_t readWhole(const std::string& file, std::string_view key, const TomlValue& value,
                        const WholeRule& rule) {
    const std::string expected = fmt::format("a whole number from {} to {}", rule.least, rule.most);
    const auto* whole = std::get_if<std::int64_t>(&value.data);
    if (whole == nullptr) {
        if (const auto* real = std::get_if<double>(&value.data))
            failAt(file, value.where, fmt::format("\"{}\" is {}, expected {}", key, *real, expected));
        wrongType(file, key, value, expected);
    }
    if (*whole < 0 || static_cast<std::uint64_t>(*whole) < rule.least ||
        static_cast<std::uint64_t>(*whole) > rule.most)
        failAt(file, value.where, fmt::format("\"{}\" is {}, expected {}", excerpt(key), *whole, expected));
    return static_cast<std::uint64_t>(*whole);
}

Vec2 readPoint(const std::string& file, std::string_view key, const TomlValue& value, const NumberRule& rule,
               std::string_view expected) {
    const auto* pair = std::get_if<TomlArray>(&value.data);
    if (pair == nullptr) wrongType(file, key, value, expected);
    if (pair->size() != 2)
        failAt(file, value.where,
               fmt::format("\"{}\" has {}, expected {}", excerpt(key), counted(pair->size(), "element"),
                           expected));
    return {readNumber(file, key, (*pair)[0], rule), readNumber(file, key, (*pair)[1], rule)};
}

Rgb readColour(const std::string& file, std::string_view key, const TomlValue& value,
               const NumberRule& rule) {
    double grey = 0.0;
    if (asNumber(value, grey)) return Rgb(checked(file, key, value, grey, rule));
    const auto* channels = std::get_if<TomlArray>(&value.data);
    if (channels == nullptr) wrongType(file, key, value, "one number or three [red, green, blue]");
    if (channels->size() != 3)
        failAt(file, value.where,
               fmt::format("\"{}\" has {}, expected one number or three [red, green, blue]", excerpt(key),
                           counted(channels->size(), "element")));
    return {readNumber(file, key, (*channels)[0], rule), readNumber(file, key, (*channels)[1], rule),
            readNumber(file, key, (*channels)[2], rule)};
}

std::string readText(const std::string& file, std::string_view key, const TomlValue& value,
                     const TextRule& rule) {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr) wrongType(file, key, value, "a string");
    if (!rule.mayBeEmpty && text->find_first_not_of(" \t\r\n") == std::string::npos)
        failAt(file, value.where, fmt::format("\"{}\" is empty, expected some text", excerpt(key)));
    const std::size_t characters = characterCount(*text);
    if (characters > rule.mostCharacters)
        failAt(file, value.where,
               fmt::format("\"{}\" has {} characters, expected at most {}", excerpt(key), characters,
                           rule.mostCharacters));
    std::string visible = *text;
    if (rule.manyLines) std::erase_if(visible, [](char c) { return c == '\n' || c == '\t' || c == '\r'; });
    if (hasControlCharacter(visible))
        failAt(file, value.where,
               fmt::format("\"{}\" holds a control character, expected {}", excerpt(key),
                           rule.manyLines ? "plain text" : "plain text on one line"));
    return *text;
}

void checkName(const std::string& file, TextPosition where, std::string_view name) {
    if (name.empty()) failAt(file, where, "the name is empty, expected at least one character");
    if (characterCount(name) > kMaxNameCharacters)
        failAt(file, where,
               fmt::format("the name has {} characters, expected at most {}", characterCount(name),
                           kMaxNameCharacters));
    if (name.find(':') != std::string_view::npos)
        failAt(file, where,
               fmt::format(
                   "the name \"{}\" holds a ':', expected a name without one (NAME:T is a point on a wall)",
                   excerpt(name)));
    if (hasControlCharacter(name))
        failAt(file, where,
               fmt::format("the name \"{}\" holds a control character, expected plain text", excerpt(name)));
}

std::string readName(const std::string& file, std::string_view key, const TomlValue& value) {
    const auto* name = std::get_if<std::string>(&value.data);
    if (name == nullptr) wrongType(file, key, value, "a string");
    checkName(file, value.where, *name);
    return *name;
}

const TomlArray& readArray(const std::string& file, std::string_view key, const TomlValue& value,
                           std::string_view expected) {
    const auto* array = std::get_if<TomlArray>(&value.data);
    if (array == nullptr) wrongType(file, key, value, expected);
    return *array;
}

const TomlTable& readTable(const std::string& file, std::string_view key, const TomlValue& value) {
    const auto* table = std::get_if<TomlTable>(&value.data);
    if (table == nullptr) wrongType(file, key, value, "a table");
    return *table;
}

void failNamed(const std::string& file, std::string_view key, const TomlValue& value,
               const std::vector<std::string_view>& names) {
    const auto* name = std::get_if<std::string>(&value.data);
    if (name == nullptr) wrongType(file, key, value, "a string");
    failAt(file, value.where,
           fmt::format("\"{}\" is \"{}\", {}", excerpt(key), excerpt(*name), expectedOneOf(*name, names)));
}

}  // namespace halfdisk
