// Could this text nest tables so deeply that a recursive parser runs out of stack?
#include "lessons/toml_nesting.h"

namespace halfdisk {
namespace {

/// Offset behind the string or comment that starts at `at`; the text may be malformed, the parser will tell later.
std::size_t skipString(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const bool basic = quote == '"';
    const bool multiLine = text.substr(at, 3) == std::string_view(basic ? "\"\"\"" : "'''");
    const std::size_t quotes = multiLine ? 3 : 1;
    for (std::size_t i = at + quotes; i < text.size(); ++i) {
        if (basic && text[i] == '\\') {
            ++i;
        } else if (!multiLine && text[i] == '\n') {
            return i;
        } else if (text[i] == quote && (!multiLine || text.substr(i, 3) == text.substr(at, 3))) {
            i += quotes;
            // Up to two more quotes belong to a multi-line string: """a""" + "" ends behind five.
            while (multiLine && i < text.size() && text[i] == quote) ++i;
            return i;
        }
    }
    return text.size();
}

}  // namespace

std::optional<std::size_t> firstTooDeepKey(std::string_view text) {
    int parts = 1;
    for (std::size_t i = 0; i < text.size();) {
        switch (text[i]) {
            case '"':
            case '\'': i = skipString(text, i); continue;
            case '#':
                while (i < text.size() && text[i] != '\n') ++i;
                continue;
            case '.':
                if (++parts > kMaxKeyParts) return i + 1;
                break;
            case '\n':
            case '[':
            case ']':
            case '{':
            case '}':
            case ',':
            case '=': parts = 1; break;
            default: break;
        }
        ++i;
    }
    return std::nullopt;
}

}  // namespace halfdisk
