// How is a text file read without trusting its size or its kind?
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace halfdisk {

inline constexpr std::uintmax_t kMaxFileBytes = 4'000'000;

/// The bytes of a file. Throws InputError if it is missing, not a regular file, unreadable, or larger than
/// kMaxFileBytes (which is found out before anything is read).
std::string readTextFile(const std::filesystem::path& path);

}  // namespace halfdisk
