// How is a file read without trusting its size or its kind?
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace halfdisk {

inline constexpr std::uintmax_t kMaxFileBytes = 4'000'000;

/// The bytes of a file. Throws InputError if it is missing, not a regular file, unreadable, or larger than
/// `mostBytes` (which is found out before anything is read); `expected` names what it should be.
std::string readFileOf(const std::filesystem::path& path, std::uintmax_t mostBytes,
                       std::string_view expected);

/// The same for a scene or a lesson: a TOML file of at most kMaxFileBytes.
std::string readTextFile(const std::filesystem::path& path);

}  // namespace halfdisk
