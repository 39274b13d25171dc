// How is a file replaced so that a reader, or a power cut, sees the old bytes or the new ones, never a
// mixture?
#pragma once

#include <filesystem>
#include <string_view>

namespace halfdisk {

/// Writes a temporary file beside `path`, flushes it to the disk and renames it over `path`. A symbolic link
/// is followed; the permissions of an existing file are kept. Throws std::runtime_error naming the file and
/// the cause; then `path` is untouched and no temporary file is left.
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace halfdisk
