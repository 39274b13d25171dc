#include "app/language.h"

#include <imgui.h>

#include <algorithm>

#include "app/embedded_sources.h"
#include "lessons/table_reader.h"
#include "lessons/translation.h"
#include "lessons/value_reader.h"

namespace halfdisk {
namespace {

constexpr TextRule kWordsRule{2000, true, false};

/// {} {:.3f} ... in their order.
std::vector<std::string_view> placeholdersOf(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
        const std::size_t close = std::min(text.find('}', open), text.size() - 1);
        found.push_back(text.substr(open, close - open + 1));
    }
    return found;
}

using Words = std::map<std::string, std::string, std::less<>>;

Words readWords(const std::string& file, std::string_view key, const TomlValue& value) {
    Words words;
    for (const TomlEntry& entry : readTable(file, key, value).entries) {
        std::string translation = readText(file, entry.key, entry.value, kWordsRule);
        if (placeholdersOf(translation) != placeholdersOf(entry.key))
            failAt(
                file, entry.value.where,
                fmt::format("\"{}\" has other placeholders than \"{}\", expected the same in the same order",
                            translation, entry.key));
        words.emplace(entry.key, std::move(translation));
    }
    return words;
}

}  // namespace

Language parseLanguage(std::string_view text, const std::string& file, std::string code) {
    const TomlValue document = parseToml(text, file);
    TableReader table(file, std::get<TomlTable>(document.data), document.where, "a language");
    const TomlValue* name = table.required("name");
    const TomlValue* decimalPoint = table.optional("decimalPoint");
    const TomlValue* words = table.required("words");
    const TomlValue* messages = table.optional("messages");
    table.finish();
    Language language;
    language.code = std::move(code);
    language.name = readText(file, "name", *name, kWordsRule);
    language.words = readWords(file, "words", *words);
    if (decimalPoint != nullptr) language.decimalPoint = readDecimalPoint(file, *decimalPoint);
    if (messages != nullptr) language.messages = readWords(file, "messages", *messages);
    return language;
}

std::vector<Language> loadLanguages() {
    constexpr std::string_view kFolder = "assets/languages/", kEnding = ".toml";
    std::vector<Language> languages;
    for (const EmbeddedSource& source : embeddedSources()) {
        if (!source.file.starts_with(kFolder)) continue;
        std::string_view code = source.file.substr(kFolder.size());
        code.remove_suffix(kEnding.size());
        languages.push_back(parseLanguage(source.text, std::string(source.file), std::string(code)));
    }
    return languages;
}

const Language* findLanguage(const std::vector<Language>& languages, std::string_view code) {
    for (const Language& language : languages)
        if (language.code == code) return &language;
    return nullptr;
}

void speak(const Language* language) {
    ImGui::GetIO().UserData = const_cast<Language*>(language);
}

const Language* spoken() {
    return ImGui::GetCurrentContext() ? static_cast<const Language*>(ImGui::GetIO().UserData) : nullptr;
}

std::string_view tr(std::string_view english) {
    const Language* language = spoken();
    if (!language) return english;
    const auto found = language->words.find(english);
    return found == language->words.end() ? english : std::string_view(found->second);
}

std::string local(std::string number) {
    const Language* language = spoken();
    if (!language || language->decimalPoint == ".") return number;
    const auto isDigit = [&](std::size_t at) {
        return at < number.size() && number[at] >= '0' && number[at] <= '9';
    };
    std::string result;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == '.' && isDigit(i + 1))
            result += language->decimalPoint;
        else
            result += number[i] == ',' ? ';' : number[i];
    }
    return result;
}

}  // namespace halfdisk
