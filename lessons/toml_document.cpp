// What does a TOML text say, in file order and with the place of everything? The only file that knows the
// parser.
#include "lessons/toml_document.h"

#include <fmt/format.h>

#include <algorithm>

// Compiled here rather than taken from the shared library: the nesting limit is ours and fuzzing sees inside.
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_MAX_NESTED_VALUES 64
// Some of its assertions fail on malformed text ("[=" is one). In debug builds they would end the program; in
// others they are promises to the optimiser, and broken ones. Without them the parser reports the error that
// it found.
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include "lessons/toml_hazards.h"
#include "lessons/toml_shield.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

TextPosition positionOf(const toml::source_region& region) {
    return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

TomlValue convert(const toml::node& node, TextPosition fallback);

TomlTable convertTable(const toml::table& table) {
    TomlTable converted;
    converted.entries.reserve(table.size());
    for (const auto& [key, value] : table) {
        const TextPosition where = positionOf(key.source());
        converted.entries.push_back({unshielded(key.str()), where, convert(value, where)});
    }
    // The parser sorts by name; what a file lists first should come first.
    std::stable_sort(
        converted.entries.begin(), converted.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
            return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
        });
    return converted;
}

TomlValue convert(const toml::node& node, TextPosition fallback) {
    TomlValue value;
    value.where = positionOf(node.source());
    if (value.where.line <= 0) value.where = fallback;
    if (const toml::table* table = node.as_table()) {
        value.data = convertTable(*table);
    } else if (const toml::array* array = node.as_array()) {
        TomlArray elements;
        elements.reserve(array->size());
        for (const toml::node& element : *array) elements.push_back(convert(element, value.where));
        value.data = std::move(elements);
    } else if (const auto* text = node.as_string()) {
        value.data = unshielded(text->get());
    } else if (const auto* whole = node.as_integer()) {
        value.data = whole->get();
    } else if (const auto* number = node.as_floating_point()) {
        value.data = number->get();
    } else if (const auto* flag = node.as_boolean()) {
        value.data = flag->get();
    } else {
        value.data = TomlDate{};
    }
    return value;
}

/// "Error while parsing array: encountered end-of-file" -> "encountered end-of-file while parsing array".
std::string reworded(std::string_view description) {
    constexpr std::string_view kPrefix = "Error while ";
    const std::size_t colon = description.find(": ");
    if (description.substr(0, kPrefix.size()) != kPrefix || colon == std::string_view::npos)
        return std::string(description);
    return fmt::format("{} while {}", description.substr(colon + 2),
                       description.substr(kPrefix.size(), colon - kPrefix.size()));
}

}  // namespace

const TomlEntry* TomlTable::find(std::string_view key) const {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const TomlEntry& e) { return e.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

std::string_view TomlValue::kind() const {
    constexpr std::string_view kKinds[] = {"true or false",  "a whole number", "a number", "a string",
                                           "a date or time", "an array",       "a table"};
    static_assert(std::size(kKinds) == std::variant_size_v<decltype(data)>);
    return kKinds[data.index()];
}

TomlValue parseToml(std::string_view text, const std::string& file) {
    if (const auto bad = firstInvalidUtf8(text))
        throw InputError(file, positionOf(text, *bad),
                         fmt::format("byte 0x{:02X} is not valid UTF-8, expected UTF-8 text",
                                     static_cast<unsigned char>(text[*bad])));
    if (const auto hazard = firstHazard(text))
        throw InputError(file, positionOf(text, hazard->offset), hazard->text);
    try {
        return convert(toml::parse(shielded(text)), {1, 1});
    } catch (const toml::parse_error& error) {
        throw InputError(
            file, positionOf(error.source()),
            fmt::format("this is not valid TOML: {}", unshielded(reworded(error.description()))));
    }
}

}  // namespace halfdisk
