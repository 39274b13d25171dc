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

}  // namespace

Prose readProse(const std::string& file, std::string_view text, std::string_view key, const TomlValue& value,
                const std::vector<Term>& terms) {
    const std::string marked = readText(file, key, value, kProseRule);
    try {
        return parseProse(marked, terms);
    } catch (const MarkupError& error) {
        // What was written with TOML's own escapes is not found again; then the start of the text must do.
        const std::size_t found = text.find(error.snippet, offsetOf(text, value.where));
        failAt(file, found == std::string_view::npos ? value.where : positionOf(text, found),
               fmt::format("\"{}\": {}", key, error.what()));
    }
}

}  // namespace halfdisk
