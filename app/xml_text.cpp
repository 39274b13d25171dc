#include "app/xml_text.h"

#include <algorithm>
#include <cstdint>

#include "lessons/utf8.h"

namespace halfdisk {

std::string xmlText(std::string_view text) {
    std::string safe;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = characterLength(text.substr(i));
        const std::string_view one = text.substr(i, std::max<std::size_t>(length, 1));
        i += one.size();
        if (length == 0 || hasControlCharacter(one) || one == "\uFFFE" || one == "\uFFFF")
            safe += one == "\n" ? std::string_view("\n") : std::string_view("\uFFFD");
        else if (one == "&")
            safe += "&amp;";
        else if (one == "<")
            safe += "&lt;";
        else if (one == ">")
            safe += "&gt;";
        else if (one == "\"")
            safe += "&quot;";
        else
            safe += one;
    }
    return safe;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

}  // namespace halfdisk
