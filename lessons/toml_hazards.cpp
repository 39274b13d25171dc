// Would this text upset the parser itself, rather than be refused by it?
#include "lessons/toml_hazards.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/toml_shield.h"
#include "lessons/utf8.h"

namespace halfdisk {
namespace {

/// Offset behind the string that starts at `at`; where it is malformed, the parser gets no further than that.
std::size_t skipString(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const bool basic = quote == '"';
    const bool multiLine = text.substr(at, 3) == std::string_view(basic ? "\"\"\"" : "'''");
    const std::string_view end = text.substr(at, multiLine ? 3 : 1);
    for (std::size_t i = at + end.size(); i < text.size(); ++i) {
        if (basic && text[i] == '\\') {
            ++i;
        } else if (!multiLine && text[i] == '\n') {
            return i;
        } else if (text.substr(i, end.size()) == end) {
            i += end.size();
            // """a""" may end in up to two quotes of its own.
            for (int own = 0; multiLine && own < 2 && i < text.size() && text[i] == quote; ++own) ++i;
            return i;
        }
    }
    return text.size();
}

}  // namespace

std::optional<TomlHazard> firstHazard(std::string_view text) {
    if (const auto at = firstUnshieldable(text))
        return TomlHazard{*at, "this is a private character of U+100000 ... U+10FFFF, expected any other"};
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    int parts = 1;
    for (std::size_t i = text.substr(0, 3) == kByteOrderMark ? 3 : 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            i = skipString(text, i);
            continue;
        }
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (static_cast<unsigned char>(c) >= 0x80u)
            return TomlHazard{
                i, fmt::format("\"{}\" stands outside of quotes, expected it in a string or a comment",
                               text.substr(i, characterLength(text.substr(i))))};
        if (c == '.') {
            if (++parts > kMaxKeyParts)
                return TomlHazard{
                    i + 1, fmt::format("the key has too many parts, expected at most {} joined by dots",
                                       kMaxKeyParts)};
        } else if (std::string_view("\n[]{},=").find(c) != std::string_view::npos) {
            parts = 1;
        }
        ++i;
    }
    return std::nullopt;
}

}  // namespace halfdisk
