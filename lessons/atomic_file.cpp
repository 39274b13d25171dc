// How is a file replaced so that a reader, or a power cut, sees the old bytes or the new ones, never a
// mixture?
#include "lessons/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int errorNumber) {
    throw std::runtime_error(fmt::format("{}: the file cannot be written: {}", path.string(),
                                         std::generic_category().message(errorNumber)));
}

/// An open file that is closed and removed unless it was renamed to its final place.
struct TemporaryFile {
    fs::path path;
    int descriptor = -1;
    bool renamed = false;

    TemporaryFile() = default;
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor >= 0) ::close(descriptor);
        if (!renamed && !path.empty()) ::unlink(path.c_str());
    }
};

void openBeside(TemporaryFile& file, const fs::path& target) {
    constexpr int kAttempts = 1000;  // other writers of the same process take some of the names
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const fs::path candidate =
            target.parent_path() / fmt::format(".halfdisk-{}-{}.tmp", ::getpid(), attempt);
        file.descriptor = ::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file.descriptor >= 0) {
            file.path = candidate;
            return;
        }
        if (errno != EEXIST) break;
    }
    fail(target, errno);
}

void writeAll(int descriptor, std::string_view bytes, const fs::path& target) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(target, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// Makes the rename itself survive a power cut. Best effort: some file systems refuse to flush a directory.
void flushDirectory(const fs::path& directory) {
    const int descriptor =
        ::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

void writeFileAtomically(const fs::path& path, std::string_view bytes) {
    std::error_code error;
    fs::path target = path;
    if (fs::is_symlink(path, error)) target = fs::weakly_canonical(path, error);
    if (error && target.empty()) fail(path, error.value());
    if (target.empty()) fail(path, ENOENT);
    // A device or a pipe would be gone: the new file takes its place.
    if (const fs::file_status status = fs::status(target, error);
        fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
        throw std::runtime_error(fmt::format(
            "{}: the file cannot be written: it is a device or a pipe, expected a file", path.string()));
    if (fs::is_directory(target, error)) fail(path, EISDIR);

    TemporaryFile file;
    openBeside(file, target);
    struct stat existing {};
    if (::stat(target.c_str(), &existing) == 0 && ::fchmod(file.descriptor, existing.st_mode & 07777u) != 0)
        fail(path, errno);
    writeAll(file.descriptor, bytes, path);
    if (::fsync(file.descriptor) != 0) fail(path, errno);
    const int closed = ::close(file.descriptor);
    file.descriptor = -1;
    if (closed != 0) fail(path, errno);
    if (::rename(file.path.c_str(), target.c_str()) != 0) fail(path, errno);
    file.renamed = true;
    flushDirectory(target.parent_path());
}

}  // namespace halfdisk
