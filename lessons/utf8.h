// Is this text valid UTF-8, and where is a byte of it on the page?
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "lessons/input_error.h"

namespace halfdisk {

/// Bytes of the well-formed character at the start of `text` (not empty), 0 if there is none.
std::size_t characterLength(std::string_view text);

/// Offset of the first byte that is not part of a well-formed character (overlong forms and surrogates are
/// not).
std::optional<std::size_t> firstInvalidUtf8(std::string_view text);

/// Number of characters (code points) in valid UTF-8.
std::size_t characterCount(std::string_view text);

/// Line and column of the byte at `offset`; the text before it is valid UTF-8.
TextPosition positionOf(std::string_view text, std::size_t offset);

/// True if the text holds a control character: below U+0020, U+007F or U+0080 ... U+009F.
bool hasControlCharacter(std::string_view text);

/// At most `most` characters of `text`, for quoting it in a message; control characters become '?', cuts
/// become "...".
std::string excerpt(std::string_view text, std::size_t most = 60);

}  // namespace halfdisk
