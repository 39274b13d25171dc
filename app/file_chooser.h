// Which files can be opened? A path that is typed, the lessons and scenes in its folder, and the last ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace halfdisk {

/// A line of the list.
struct FileChoice {
    std::filesystem::path path;
    std::string name;  ///< as shown; folders end with '/'
    bool isFolder = false;
    bool isRecent = false;   ///< it is here since it was opened or saved before
    bool isMissing = false;  ///< it was there then
    bool operator==(const FileChoice&) const = default;
};

/// The list of files, while it is open. The disk is read when the list opens and when another folder is
/// typed, not in every frame.
struct FileChooser {
    bool shown = false;
    std::string path;              ///< as typed
    std::filesystem::path folder;  ///< the one that `inFolder` lists
    std::vector<FileChoice> inFolder;
    std::vector<FileChoice> recent;
    std::size_t selected = 0;  ///< of what choicesOf gives
};

/// Most entries of a folder that are listed.
inline constexpr std::size_t kMostFilesListed = 2000;
/// Files that are remembered.
inline constexpr std::size_t kMostRecent = 10;

/// Folders and *.toml files, sorted by name, folders last; nothing of what cannot be read.
std::vector<FileChoice> listFolder(const std::filesystem::path& folder);

/// The same for what was opened or saved before.
std::vector<FileChoice> listRecent(const std::vector<std::filesystem::path>& recent);

/// Opens the list at a folder. It lists that, and what was used last.
void openChooser(FileChooser& chooser, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& recent);

/// Lists the folder of a path anew if it is another one.
void setChooserPath(FileChooser& chooser, const std::string& path);

/// What the path may mean: while none is typed but a folder, the last files and then all of the folder; else
/// what the name finds there, the best first (see fuzzy.h).
std::vector<FileChoice> choicesOf(const FileChooser& chooser);

/// Puts a file first; the oldest one is forgotten.
void remember(std::vector<std::filesystem::path>& recent, const std::filesystem::path& file);

}  // namespace halfdisk
