// Are two texts the same? A short text that differs where they do, by accident, not by intent.
#pragma once

#include <string>
#include <string_view>

namespace halfdisk {

/// 16 hexadecimal digits: FNV-1a of the bytes.
std::string fingerprintOf(std::string_view bytes);

}  // namespace halfdisk
