#include "app/file_chooser.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <tuple>

#include "app/fuzzy.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLooked = 50'000;  // entries of a folder

/// What a shell would make of `~/`.
fs::path meant(const std::string& typed) {
    const char* home = std::getenv("HOME");
    if (home != nullptr && typed.rfind("~/", 0) == 0) return fs::path(home) / typed.substr(2);
    return typed;
}

/// Of what is typed: up to the last '/'.
fs::path folderOf(const std::string& typed) {
    const fs::path folder = meant(typed).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

std::vector<FileChoice> listFolder(const fs::path& folder) {
    std::vector<FileChoice> choices;
    std::error_code failed;
    std::size_t looked = 0;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end && looked < kMostLooked;
         entry.increment(failed), ++looked) {
        const std::string name = entry->path().filename().string();
        if (name.empty() || name.front() == '.' || choices.size() >= kMostFilesListed) continue;
        std::error_code none;
        const bool isFolder = entry->is_directory(none);
        if (!isFolder && entry->path().extension() != ".toml") continue;
        choices.push_back({entry->path(), isFolder ? name + '/' : name, isFolder});
    }
    std::sort(choices.begin(), choices.end(), [](const FileChoice& a, const FileChoice& b) {
        return std::tie(a.isFolder, a.name) < std::tie(b.isFolder, b.name);
    });
    return choices;
}

std::vector<FileChoice> listRecent(const std::vector<fs::path>& recent) {
    std::vector<FileChoice> choices;
    for (const fs::path& file : recent) {
        std::error_code none;
        choices.push_back({file, file.string(), false, true, !fs::is_regular_file(file, none)});
    }
    return choices;
}

void openChooser(FileChooser& chooser, const fs::path& folder, const std::vector<fs::path>& recent) {
    chooser = {};
    chooser.shown = true;
    chooser.recent = listRecent(recent);
    std::error_code none;
    const fs::path whole = fs::absolute(folder, none).lexically_normal();
    setChooserPath(chooser, ((none ? folder : whole) / "").string());
}

void setChooserPath(FileChooser& chooser, const std::string& path) {
    chooser.path = path;
    chooser.selected = 0;
    const fs::path folder = folderOf(path);
    if (folder == chooser.folder) return;
    chooser.folder = folder;
    chooser.inFolder = listFolder(folder);
}

std::vector<FileChoice> choicesOf(const FileChooser& chooser) {
    const std::string typed = fs::path(chooser.path).filename().string();
    if (typed.empty()) {
        std::vector<FileChoice> all = chooser.recent;
        all.insert(all.end(), chooser.inFolder.begin(), chooser.inFolder.end());
        return all;
    }
    std::vector<FileChoice> found;
    std::vector<int> scores;
    const FuzzyQuery wanted(typed);
    const auto look = [&](const FileChoice& choice, const std::string& name) {
        const auto score = fuzzyScore(wanted, name);
        if (!score) return;
        const auto place = std::upper_bound(scores.begin(), scores.end(), *score, std::greater<>());
        found.insert(found.begin() + (place - scores.begin()), choice);
        scores.insert(place, *score);
    };
    for (const FileChoice& choice : chooser.inFolder) look(choice, choice.name);
    for (const FileChoice& choice : chooser.recent)
        if (choice.path.parent_path() != chooser.folder) look(choice, choice.path.filename().string());
    return found;
}

void remember(std::vector<fs::path>& recent, const fs::path& file) {
    std::error_code none;
    const fs::path whole = fs::absolute(file, none).lexically_normal();
    const fs::path& path = none ? file : whole;
    recent.erase(std::remove(recent.begin(), recent.end(), path), recent.end());
    recent.insert(recent.begin(), path);
    if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

}  // namespace halfdisk
