// Numbers in sentences: as many digits as are of use, without a formatting library in core.
#pragma once

#include <cmath>
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

/// Two digits of a factor, written out: 1.3, 35, 240.
inline std::string rounded(double factor) {
    if (!(factor >= 99.5 && factor < 1e6)) return number(factor);
    const double unit = std::pow(10.0, std::floor(std::log10(factor)) - 1.0);
    return number(std::round(factor / unit) * unit, 7);
}

inline std::string percent(double share, int digits = 2) {
    // Never 1e+02 %.
    const bool nearlyAll = share > 0.99 && share < 9.995;
    return joined(number(100.0 * share, nearlyAll ? 3 : digits), " %");
}

/// "no wall", "1 wall", "3 walls".
inline std::string counted(std::size_t count, const std::string& noun) {
    return joined(count == 0 ? std::string("no") : std::to_string(count), " ", noun, count == 1 ? "" : "s");
}

}  // namespace halfdisk::words
