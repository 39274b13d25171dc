// Could this text nest tables so deeply that a recursive parser runs out of stack?
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace halfdisk {

/// Most parts of a dotted key (a.b.c has three). The parser limits brackets itself, but not dots.
inline constexpr int kMaxKeyParts = 16;

/// Offset of the first part beyond kMaxKeyParts of a dotted key, if any. Strings and comments are skipped.
std::optional<std::size_t> firstTooDeepKey(std::string_view text);

}  // namespace halfdisk
