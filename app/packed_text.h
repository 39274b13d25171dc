// How does a long text become a short one of letters that every mail and chat leaves alone?
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace halfdisk {

/// Compressed (RFC 1950), in the letters of RFC 4648, section 5 (base64url), without padding.
std::string packedText(const std::string& text);

/// The text again; spaces and line ends among the letters do not matter. Nothing if it is damaged, or would
/// be longer than `most` bytes, however long it claims to be.
std::optional<std::string> unpackedText(std::string_view text, std::size_t most);

}  // namespace halfdisk
