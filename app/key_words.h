// What are keys called in the window's language? On a German keyboard Ctrl is Strg.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace halfdisk {

/// Those that have names, longer ones before their beginnings. A language has them as "key Ctrl".
inline constexpr std::array<std::string_view, 14> kKeyNames{
    "Page Down", "Page Up", "Double click", "Ctrl",   "Shift",  "Space", "Home",
    "End",       "Delete",  "Escape",       "Arrows", "arrows", "Mouse", "or"};

/// `Ctrl Z  Ctrl Y`, `Page Down, N` with each name in the context's language.
std::string keyWords(std::string_view keys);

/// What a button does, and the key that does the same: `take the last change back (Ctrl Z)`.
std::string withKey(std::string_view meaning, std::string_view key);

}  // namespace halfdisk
