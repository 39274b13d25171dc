// Numbers in sentences: as many digits as are of use, without a formatting library in core.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace halfdisk::words {

/// All of them, one after the other.
template <class... Parts>
std::string joined(const Parts&... parts) {
    std::string text;
    (text.append(std::string_view(parts)), ...);
    return text;
}

inline std::string number(double value, int digits = 2) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

inline std::string percent(double share, int digits = 2) {
    return joined(number(100.0 * share, digits), " %");
}

/// "no wall", "1 wall", "3 walls".
inline std::string counted(std::size_t count, const std::string& noun) {
    return joined(count == 0 ? std::string("no") : std::to_string(count), " ", noun, count == 1 ? "" : "s");
}

}  // namespace halfdisk::words
