// Which files were opened or saved last, in all the times that the program ran? A list beside the user's
// settings.
#pragma once

#include <filesystem>
#include <vector>

#include "app/app_state.h"

namespace halfdisk {

class RecentFiles {
 public:
    /// Keeps the list in a folder, which is made when it is needed (see stateFolder of autosave.h).
    explicit RecentFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// At the start: the list as it is on the disk. What cannot be read, or is no list, is none.
    std::vector<std::filesystem::path> read() { return kept_ = onDisk(); }

    /// Once a frame: writes the list if it has changed, together with what other windows have added
    /// meanwhile. What cannot be written is told once, in the state's banner. In a kiosk nothing is
    /// remembered.
    void look(AppState& state);

    std::filesystem::path file() const { return folder_ / "recent"; }

 private:
    std::vector<std::filesystem::path> onDisk() const;

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> kept_;
    bool failed_ = false;
};

}  // namespace halfdisk
