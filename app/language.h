// In which language does the window speak? English stands in the source; a language is a table from those
// words to others.
#pragma once

#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace halfdisk {

struct Language {
    std::string code;                ///< of lessons/<code>/ and --language: de
    std::string name;                ///< in itself: Deutsch
    std::string decimalPoint = ".";  ///< of numbers that are shown; files and fields have a point
    std::map<std::string, std::string, std::less<>> words;
    std::map<std::string, std::string, std::less<>>
        messages;  ///< with {} for each value: see message_words.h
};

/// All but English, from assets/languages. Throws InputError if one of these files is not as it should be:
/// a template must keep its placeholders.
std::vector<Language> loadLanguages();

/// Reads one: name = "...", [words] and [messages] English = "translation".
Language parseLanguage(std::string_view text, const std::string& file, std::string code);

/// Null: English, or there is no such language.
const Language* findLanguage(const std::vector<Language>& languages, std::string_view code);

/// The current ImGui context speaks this language from now on (null: English). It must outlive the frame.
void speak(const Language* language);

/// What the current context speaks; null: English, or there is no context.
const Language* spoken();

/// The words in the context's language; the same words if it has none for them.
std::string_view tr(std::string_view english);

/// A number's text, or a list's of numbers, as it is written in the context's language: `0,5; 1,25` for
/// `0.5, 1.25` where the point is a comma.
std::string local(std::string number);

/// A number that a template formats, in the context's language.
struct LocalNumber {
    double value;
};

/// Numbers with a fraction become local, all else stays as it is.
template <class Value>
const Value& localIfNumber(const Value& value) {
    return value;
}
inline LocalNumber localIfNumber(double value) {
    return {value};
}
inline LocalNumber localIfNumber(float value) {
    return {static_cast<double>(value)};
}

/// What tr says of a template with its values put in.
template <class... Values>
std::string sayLocal(std::string_view english, const Values&... values) {
    return fmt::vformat(tr(english), fmt::make_format_args(values...));
}
template <class... Values>
std::string say(std::string_view english, const Values&... values) {
    return sayLocal(english, localIfNumber(values)...);
}

}  // namespace halfdisk

template <>
struct fmt::formatter<halfdisk::LocalNumber> : fmt::formatter<double> {
    auto format(halfdisk::LocalNumber number, fmt::format_context& context) const {
        fmt::memory_buffer plain;
        fmt::format_context to(fmt::appender(plain), context.args(), context.locale());
        fmt::formatter<double>::format(number.value, to);
        return fmt::format_to(context.out(), "{}", halfdisk::local(fmt::to_string(plain)));
    }
};
