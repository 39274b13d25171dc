// How do letters beyond ASCII get past a parser that has undefined behaviour on many of them?
#include "lessons/toml_shield.h"

#include <algorithm>

#include "lessons/utf8.h"

namespace halfdisk {
namespace {

// In UTF-8, U+100000 + c is F4 8x xx xx: the lead byte F4 is plane 16 and no other.
constexpr char kPlane16 = '\xf4';
constexpr char32_t kShift = 0x100000;

unsigned bits(char c, unsigned mask) {
    return static_cast<unsigned char>(c) & mask;
}

char continuation(char32_t value) {
    return static_cast<char>(0x80u | (value & 0x3Fu));
}

}  // namespace

std::optional<std::size_t> firstUnshieldable(std::string_view text) {
    const std::size_t found = std::min(text.find(kPlane16), text.find("\\U0010"));
    return found == std::string_view::npos ? std::nullopt : std::optional(found);
}

std::string shielded(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    std::string result(text.substr(0, text.substr(0, 3) == kByteOrderMark ? 3 : 0));
    result.reserve(text.size());
    for (std::size_t i = result.size(); i < text.size();) {
        const std::size_t length = characterLength(text.substr(i));
        if (length == 2 || length == 3) {
            char32_t c = 0;
            if (length == 2) c = bits(text[i], 0x1Fu) << 6 | bits(text[i + 1], 0x3Fu);
            if (length == 3)
                c = bits(text[i], 0x0Fu) << 12 | bits(text[i + 1], 0x3Fu) << 6 | bits(text[i + 2], 0x3Fu);
            c += kShift;
            result += {kPlane16, continuation(c >> 12), continuation(c >> 6), continuation(c)};
        } else {
            result += text.substr(i, length);
        }
        i += length;
    }
    return result;
}

std::string unshielded(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = std::max<std::size_t>(1, characterLength(text.substr(i)));
        if (text[i] == kPlane16 && length == 4) {
            const unsigned c =
                bits(text[i + 1], 0x0Fu) << 12 | bits(text[i + 2], 0x3Fu) << 6 | bits(text[i + 3], 0x3Fu);
            if (c < 0x800u) {
                result += {static_cast<char>(0xC0u | c >> 6), continuation(c)};
            } else {
                result += {static_cast<char>(0xE0u | c >> 12), continuation(c >> 6), continuation(c)};
            }
        } else {
            result += text.substr(i, length);
        }
        i += length;
    }
    return result;
}

}  // namespace halfdisk
