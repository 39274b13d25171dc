#include "app/file_watch.h"

#include <system_error>
#include <vector>

namespace halfdisk {

bool FileWatch::changed(const AppState& state) {
    std::vector<std::filesystem::path> files{state.lessonsFolder, state.sceneOverride};
    if (state.lesson) {
        files.push_back(state.lesson->file);
        files.push_back(state.lesson->scenePath);
    }
    bool any = false;
    for (const auto& file : files) {
        if (file.empty()) continue;
        std::error_code failed;
        const auto time = std::filesystem::last_write_time(file, failed);
        if (failed) continue;
        const auto [entry, isNew] = seen_.try_emplace(file, time);
        any = any || (!isNew && entry->second != time);
        entry->second = time;
    }
    return any;
}

}  // namespace halfdisk
