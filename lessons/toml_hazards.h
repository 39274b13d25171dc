// Would this text upset the parser itself, rather than be refused by it?
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace halfdisk {

/// Most parts of a dotted key (a.b.c has three). The parser limits nested brackets itself, but recurses once
/// for each part of a key and runs out of stack.
inline constexpr int kMaxKeyParts = 16;

struct TomlHazard {
    std::size_t offset;
    std::string text;  ///< what is wrong, what was expected
};

/// One of these, if there is any: a dotted key of too many parts; a character beyond ASCII outside of strings
/// and comments (no valid TOML has one); a character that toml_shield.h keeps for itself. `text` is valid
/// UTF-8.
std::optional<TomlHazard> firstHazard(std::string_view text);

}  // namespace halfdisk
