// Is this text valid UTF-8, and where is a byte of it on the page? (RFC 3629, table of well-formed sequences)
#include "lessons/utf8.h"

#include <algorithm>

namespace halfdisk {
namespace {

bool isContinuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

}  // namespace

std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80u) return 1;
    const std::size_t length = lead >= 0xC2u && lead <= 0xDFu   ? 2
                               : (lead & 0xF0u) == 0xE0u        ? 3
                               : lead >= 0xF0u && lead <= 0xF4u ? 4
                                                                : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!isContinuation(text[i])) return 0;
    // The second byte also rules out overlong forms, surrogates and values above U+10FFFF.
    const unsigned second = byte(1);
    if (lead == 0xE0u && second < 0xA0u) return 0;
    if (lead == 0xEDu && second > 0x9Fu) return 0;
    if (lead == 0xF0u && second < 0x90u) return 0;
    if (lead == 0xF4u && second > 0x8Fu) return 0;
    return length;
}

std::optional<std::size_t> firstInvalidUtf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = characterLength(text.substr(at));
        if (length == 0) return at;
        at += length;
    }
    return std::nullopt;
}

std::size_t characterCount(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !isContinuation(c); }));
}

TextPosition positionOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const std::size_t newline = before.rfind('\n');
    const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
            static_cast<int>(characterCount(line)) + 1};
}

bool hasControlCharacter(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (c < 0x20u || c == 0x7Fu) return true;
        const bool c1 = c == 0xC2u && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0u;
        if (c1) return true;
    }
    return false;
}

std::string excerpt(std::string_view text, std::size_t most) {
    std::string shown;
    std::size_t characters = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!isContinuation(text[i]) && ++characters > most) return shown + "...";
        const auto c = static_cast<unsigned char>(text[i]);
        shown += c < 0x20u || c == 0x7Fu ? '?' : text[i];
    }
    return shown;
}

}  // namespace halfdisk
