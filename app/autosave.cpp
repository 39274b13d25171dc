#include "app/autosave.h"

#include <fmt/format.h>

#include <signal.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "app/edit_commands.h"
#include "lessons/scene_file.h"

namespace halfdisk {
namespace {

constexpr std::string_view kUnsaved = "unsaved-";

/// Dead, though nobody has asked how it ended: `PID (name) Z ...`, where the name may hold anything.
bool isZombie(long process) {
    std::ifstream stat(fmt::format("/proc/{}/stat", process));
    const std::string words{std::istreambuf_iterator<char>(stat), {}};
    const std::size_t name = words.rfind(") ");
    return name != std::string::npos && words.compare(name + 2, 1, "Z") == 0;
}

/// Also if it belongs to somebody else.
bool isRunning(long process) {
    if (isZombie(process)) return false;
    return kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM;
}

}  // namespace

void Autosave::look(AppState& state, double now) {
    std::error_code none;
    const std::shared_ptr<const PreparedScene> unsaved = unsavedScene(state);
    if (!unsaved) {
        if (kept_) std::filesystem::remove(file(), none);
        kept_.reset();
        return;
    }
    if (kept_ == unsaved || now - lastWrite_ < kAutosaveSeconds) return;
    lastWrite_ = now;
    try {
        std::filesystem::create_directories(folder_);
        saveScene(withoutFarImage(unsaved->description, file()), file());
        kept_ = unsaved;
    } catch (const std::exception& error) {
        if (!failed_) state.banner = fmt::format("unsaved changes cannot be kept: {}", error.what());
        failed_ = true;
    }
}

std::filesystem::path Autosave::file() const {
    return folder_ / fmt::format("{}{}.toml", kUnsaved, process_);
}

std::optional<std::filesystem::path> Autosave::recovered() const {
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, failed)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind(kUnsaved, 0) != 0) continue;
        const long process = std::strtol(name.c_str() + kUnsaved.size(), nullptr, 10);
        if (process <= 0 || isRunning(process)) continue;
        constexpr int kMostKept = 1000;
        for (int number = 1; number < kMostKept; ++number) {
            const std::filesystem::path to = folder_ / fmt::format("recovered-{}.toml", number);
            if (std::filesystem::exists(to, failed)) continue;
            std::filesystem::rename(entry.path(), to, failed);
            if (!failed) return to;
        }
        return entry.path();
    }
    return std::nullopt;
}

std::filesystem::path stateFolder() {
    const auto of = [](const char* name) -> std::filesystem::path {
        const char* value = std::getenv(name);
        return value != nullptr && value[0] == '/' ? value : "";
    };
    if (const auto state = of("XDG_STATE_HOME"); !state.empty()) return state / "halfdisk";
    if (const auto home = of("HOME"); !home.empty()) return home / ".local/state/halfdisk";
    return std::filesystem::temp_directory_path() / "halfdisk";
}

}  // namespace halfdisk
