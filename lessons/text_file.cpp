// How is a text file read without trusting its size or its kind?
#include "lessons/text_file.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "lessons/input_error.h"

namespace halfdisk {
namespace {

[[noreturn]] void refuseSize(const std::string& name, std::uintmax_t bytes) {
    throw InputError(name, fmt::format("the file has {} bytes, expected at most {}", bytes, kMaxFileBytes));
}

}  // namespace

std::string readTextFile(const std::filesystem::path& path) {
    const std::string name = path.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw InputError(name, "there is no such file, expected a TOML file");
    if (error) throw InputError(name, fmt::format("the file cannot be read: {}", error.message()));
    if (std::filesystem::is_directory(status))
        throw InputError(name, "this is a directory, expected a TOML file");
    // Devices and pipes have no size and may never end.
    if (!std::filesystem::is_regular_file(status))
        throw InputError(name, "this is not a regular file, expected a TOML file");
    const std::uintmax_t bytes = std::filesystem::file_size(path, error);
    if (error) throw InputError(name, fmt::format("the file cannot be read: {}", error.message()));
    if (bytes > kMaxFileBytes) refuseSize(name, bytes);

    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(name, "the file cannot be opened for reading, expected read permission");
    // One byte more than was announced, so that a file that grows meanwhile is noticed and still bounded.
    std::string text(static_cast<std::size_t>(bytes) + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) throw InputError(name, "the file cannot be read to its end");
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMaxFileBytes) refuseSize(name, text.size());
    return text;
}

}  // namespace halfdisk
