#include "lessons/typed_numbers.h"

#include <algorithm>
#include <string_view>

#include "lessons/text_file.h"
#include "lessons/text_rules.h"
#include "lessons/toml_document.h"

namespace halfdisk {
namespace {

constexpr std::string_view kBold = "**";

/// Digits, and no {reference} beside them.
bool isTyped(std::string_view words) {
    return words.find_first_of("0123456789") != std::string_view::npos &&
           words.find('{') == std::string_view::npos;
}

/// Adds those of one text; formulas have no bold words.
void addFrom(std::string_view file, TextPosition where, std::string_view text,
             std::vector<TypedNumber>& numbers) {
    while (!text.empty()) {
        const std::string_view paragraph = text.substr(0, text.find("\n\n"));
        for (std::size_t at = paragraph.find(kBold); at != std::string_view::npos;) {
            const std::size_t start = at + kBold.size();
            const std::size_t end = paragraph.find(kBold, start);
            if (end == std::string_view::npos) break;
            const std::string_view words = paragraph.substr(start, end - start);
            const std::string_view line = paragraph.substr(at);
            if (isTyped(words))
                numbers.push_back(
                    {placeOf(file, where, line.substr(0, line.find('\n'))), std::string(words)});
            at = paragraph.find(kBold, end + kBold.size());
        }
        text.remove_prefix(paragraph.size());
        text.remove_prefix(std::min(text.find_first_not_of('\n'), text.size()));
    }
}

/// Steps in lessons hold a table [step.question], steps in translations its words themselves.
void addFromStep(std::string_view file, const TomlTable& step, std::vector<TypedNumber>& numbers) {
    for (const TomlEntry& entry : step.entries) {
        if (const auto* table = std::get_if<TomlTable>(&entry.value.data); table && entry.key == "question")
            addFromStep(file, *table, numbers);
        const auto* text = std::get_if<std::string>(&entry.value.data);
        if (text != nullptr && (entry.key == "prose" || entry.key == "ask" || entry.key == "answer"))
            addFrom(file, entry.value.where, *text, numbers);
    }
}

}  // namespace

std::vector<TypedNumber> typedNumbers(const std::filesystem::path& file) {
    const std::string text = readTextFile(file);
    const TomlValue document = parseToml(text, file.string());
    std::vector<TypedNumber> numbers;
    const TomlEntry* steps = std::get<TomlTable>(document.data).find("step");
    const auto* tables = steps != nullptr ? std::get_if<TomlArray>(&steps->value.data) : nullptr;
    if (tables == nullptr) return numbers;
    for (const TomlValue& step : *tables)
        if (const auto* table = std::get_if<TomlTable>(&step.data)) addFromStep(text, *table, numbers);
    return numbers;
}

}  // namespace halfdisk
