// To which files can a rendering be written? The checks before the work, and the writing after it.
#include "app/render_output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "app/cli_arguments.h"
#include "lessons/atomic_file.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kOption = "--output";

const OutputFormat* formatOf(const fs::path& path) {
    const std::string extension = path.extension().string();
    const auto found =
        std::find_if(kOutputFormats.begin(), kOutputFormats.end(),
                     [&](const OutputFormat& format) { return format.extension == extension; });
    return found == kOutputFormats.end() ? nullptr : &*found;
}

[[noreturn]] void failExtension(const fs::path& path) {
    std::string names;
    for (const OutputFormat& format : kOutputFormats)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", format.extension);
    failArgument(kOption, path.string(), fmt::format("has no known extension, expected one of {}", names));
}

/// The file that a link leads to, so that it is its folder which is asked.
fs::path targetOf(const fs::path& path) {
    std::error_code error;
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    return target.empty() ? path : target;
}

}  // namespace

void refuseUnwritable(const fs::path& path) {
    std::error_code error;
    const fs::path target = targetOf(path);
    if (fs::is_directory(target, error))
        failArgument(kOption, path.string(), "is a folder, expected a file's name");
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    std::string trial = (folder / ".halfdisk-XXXXXX").string();
    const int file = mkostemp(trial.data(), O_CLOEXEC);
    if (file < 0)
        failArgument(kOption, path.string(),
                     fmt::format("cannot be written: no file can be made in {}: {}", folder.string(),
                                 std::generic_category().message(errno)));
    close(file);
    unlink(trial.c_str());
}

void refuseOutputs(const std::vector<fs::path>& outputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (formatOf(outputs[i]) == nullptr) failExtension(outputs[i]);
        if (std::find(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(i), outputs[i]) !=
            outputs.begin() + static_cast<std::ptrdiff_t>(i))
            failArgument(kOption, outputs[i].string(), "is given twice");
    }
    for (const fs::path& path : outputs) refuseUnwritable(path);
}

void writeOutputs(const std::vector<fs::path>& outputs, const RenderResult& result) {
    for (const fs::path& path : outputs) writeFileAtomically(path, formatOf(path)->encode(result));
}

}  // namespace halfdisk
