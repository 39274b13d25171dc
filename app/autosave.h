// How does a change of a scene outlive the program? A copy beside the user's settings, written while one
// works.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/app_state.h"

namespace halfdisk {

/// Seconds that a change may be older than the copy.
inline constexpr double kAutosaveSeconds = 2.0;

class Autosave {
 public:
    /// Keeps the copy of this process in the folder, which is made when it is needed.
    Autosave(std::filesystem::path folder, long process) : folder_(std::move(folder)), process_(process) {}

    /// Once a frame, `now` in seconds of any clock: writes the copy if there are unsaved changes that it
    /// lacks, and takes it away when there are none. What cannot be written is told once, in the state's
    /// banner.
    void look(AppState& state, double now);

    /// At the start: what a process that runs no more left behind, moved to a name of its own so that it
    /// stays. Nothing if there is none.
    std::optional<std::filesystem::path> recovered() const;

    std::filesystem::path file() const;

 private:
    std::filesystem::path folder_;
    long process_;
    std::shared_ptr<const PreparedScene> kept_;  // what the copy holds; null: there is none
    double lastWrite_ = -1e300;
    bool failed_ = false;
};

/// $XDG_STATE_HOME/halfdisk, else ~/.local/state/halfdisk, else a folder for files that may go.
std::filesystem::path stateFolder();

}  // namespace halfdisk
