// How do letters beyond ASCII get past a parser that has undefined behaviour on many of them?
//
// toml++ 3.3 asks of every character of a bare word whether it is a blank, and runs into
// __builtin_unreachable for most of U+00A1 ... U+0499 (Greek, Cyrillic, accents) and U+3000 ... U+3400.
// Before it parses, each character of U+0080 ... U+FFFF is moved up to the private plane 16, one for one, so
// that lines and columns stay; after it, back.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace halfdisk {

/// Offset of a character of plane 16 (also as an escape, \U0010....): it could not be told from a shielded
/// one.
std::optional<std::size_t> firstUnshieldable(std::string_view text);

/// `text` (valid UTF-8) with the characters U+0080 ... U+FFFF moved to U+100080 ... U+10FFFF; a leading byte
/// order mark stays.
std::string shielded(std::string_view text);

/// The inverse of shielded().
std::string unshielded(std::string_view text);

}  // namespace halfdisk
