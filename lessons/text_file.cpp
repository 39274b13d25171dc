// How is a file read without trusting its size or its kind?
#include "lessons/text_file.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "lessons/input_error.h"

namespace halfdisk {
namespace {

[[noreturn]] void refuseSize(const std::string& name, std::uintmax_t bytes, std::uintmax_t most) {
    throw InputError(name, fmt::format("the file has {} bytes, expected at most {}", bytes, most));
}

}  // namespace

std::string readFileOf(const std::filesystem::path& path, std::uintmax_t mostBytes,
                       std::string_view expected) {
    const std::string name = path.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw InputError(name, fmt::format("there is no such file, expected {}", expected));
    if (error) throw InputError(name, fmt::format("the file cannot be read: {}", error.message()));
    if (std::filesystem::is_directory(status))
        throw InputError(name, fmt::format("this is a directory, expected {}", expected));
    // Devices and pipes have no size and may never end.
    if (!std::filesystem::is_regular_file(status))
        throw InputError(name, fmt::format("this is not a regular file, expected {}", expected));
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) throw InputError(name, fmt::format("the file cannot be read: {}", error.message()));
    if (bytes > mostBytes) refuseSize(name, bytes, mostBytes);

    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(name, "the file cannot be opened for reading, expected read permission");
    // One byte more than was announced, so that a file that grows meanwhile is noticed and still bounded.
    std::string text(static_cast<std::size_t>(bytes) + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) throw InputError(name, "the file cannot be read to its end");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > mostBytes) refuseSize(name, text.size(), mostBytes);
    return text;
}

std::string readTextFile(const std::filesystem::path& path) {
    return readFileOf(path, kMaxFileBytes, "a TOML file");
}

}  // namespace halfdisk
