#include "lessons/text_rules.h"

#include <fmt/format.h>

namespace halfdisk {
namespace {

/// Offset of a place in a text.
std::size_t offsetOf(std::string_view text, TextPosition where) {
    std::size_t at = 0;
    for (int line = 1; line < where.line && at < text.size(); ++line)
        at = std::min(text.find('\n', at), text.size()) + 1;
    for (int column = 1; column < where.column && at < text.size(); ++column) {
        do ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u);
    }
    return std::min(at, text.size());
}

[[noreturn]] void failInText(const LessonText& text, std::string_view key, const TomlValue& value,
                             const MarkupError& error) {
    failAt(text.file, placeOf(text.text, value.where, error.snippet),
           fmt::format("\"{}\": {}", key, error.what()));
}

}  // namespace

TextPosition placeOf(std::string_view text, TextPosition from, std::string_view snippet) {
    const std::size_t found = text.find(snippet, offsetOf(text, from));
    return found == std::string_view::npos ? from : positionOf(text, found);
}

std::string readWords(const LessonText& text, std::string_view key, const TomlValue& value,
                      const TextRule& rule) {
    const std::string words = readText(text.file, key, value, rule);
    try {
        return withNumbers(words, text.numbers);
    } catch (const MarkupError& error) {
        failInText(text, key, value, error);
    }
}

Prose readProse(const LessonText& text, std::string_view key, const TomlValue& value,
                const std::vector<Term>& terms) {
    const std::string marked = readText(text.file, key, value, kProseRule);
    try {
        Prose asWritten = parseProse(marked, terms);
        const std::string filled = withNumbers(marked, text.numbers);
        // Numbers hold no markup, so that only what was written can be wrong; faults of it were told where
        // they stand.
        return filled == marked ? std::move(asWritten) : parseProse(filled, terms);
    } catch (const MarkupError& error) {
        failInText(text, key, value, error);
    }
}

}  // namespace halfdisk
