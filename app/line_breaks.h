// Where may a line of words end? At spaces alone, so that 0.81 stays one number.
#pragma once

#include <string>
#include <string_view>

namespace halfdisk {

/// Where the first word of `text` ends; a number and its percent sign are one.
std::size_t endOfWord(std::string_view text);

/// The words with as many line ends as the current font needs to stay within `width` pixels. A word that is
/// wider stands on a line of its own.
std::string brokenInto(std::string_view words, float width);

}  // namespace halfdisk
