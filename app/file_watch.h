// Has a file on screen changed on the disk? Looked at between frames, so that a teacher's edit shows at once.
#pragma once

#include <filesystem>
#include <map>

#include "app/app_state.h"

namespace halfdisk {

class FileWatch {
 public:
    /// Whether the lesson's, the scene's or the lessons folder's time of change differs from the last look.
    /// The first look at a file only notes it; a file that cannot be read counts as unchanged.
    bool changed(const AppState& state);

 private:
    std::map<std::filesystem::path, std::filesystem::file_time_type> seen_;
};

}  // namespace halfdisk
