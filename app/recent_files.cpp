#include "app/recent_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "lessons/atomic_file.h"
#include "lessons/text_file.h"

namespace halfdisk {
namespace {

constexpr std::uintmax_t kMostBytes = 100'000;

}  // namespace

std::vector<std::filesystem::path> RecentFiles::onDisk() const {
    std::vector<std::filesystem::path> files;
    std::string text;
    try {
        text = readFileOf(file(), kMostBytes, "a list of files");
    } catch (const std::exception&) {
        return files;
    }
    for (std::size_t at = 0; at < text.size() && files.size() < kMostRecent;) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        const bool isPath = line.size() > 1 && line.front() == '/' && line.find('\0') == std::string::npos;
        if (isPath && std::find(files.begin(), files.end(), line) == files.end()) files.push_back(line);
    }
    return files;
}

void RecentFiles::look(AppState& state) {
    if (state.recent == kept_ || state.rules.kiosk) return;
    std::vector<std::filesystem::path> all;
    const auto add = [&](const std::filesystem::path& path) {
        const bool known = std::find(all.begin(), all.end(), path) != all.end();
        if (!known && all.size() < kMostRecent) all.push_back(path);
    };
    for (const auto& path : state.recent) add(path);
    for (const auto& path : onDisk()) add(path);
    state.recent = kept_ = all;
    std::string text;
    for (const auto& path : all)
        if (path.string().find('\n') == std::string::npos) text += path.string() + '\n';
    try {
        std::filesystem::create_directories(folder_);
        writeFileAtomically(file(), text);
    } catch (const std::exception& error) {
        if (!failed_) state.banner = fmt::format("the last files cannot be remembered: {}", error.what());
        failed_ = true;
    }
}

}  // namespace halfdisk
