#include "app/export_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "app/language.h"
#include "app/light_progress.h"
#include "app/message_words.h"
#include "app/plot_tables.h"
#include "app/plot_words.h"
#include "app/share_text.h"
#include "app/state_text.h"
#include "app/tree_json.h"
#include "lessons/atomic_file.h"

namespace halfdisk {
namespace {

namespace fs = std::filesystem;

std::string titleOf(const AppState& state, std::string_view name) {
    const std::string drawing = drawingTitle(state, name);
    if (!state.lesson) return drawing;
    return say("{} ({}, step {}: {})", drawing, state.lesson->title, state.step + 1,
               state.currentStep()->title);
}

std::string descriptionOf(const AppState& state, std::string_view name) {
    std::string words = drawingWords(state, name);
    if (name != "canvas" || !state.shows(View::field)) return words;
    words += '\n';
    words += drawingWords(state, "field");
    return words;
}

/// For a folder's name: letters, digits, '-' and '_'.
std::string nameOf(const AppState& state) {
    if (state.lesson) return fmt::format("halfdisk-{}-{}", state.lesson->slug, state.step + 1);
    std::string name;
    for (const char c : state.sceneOverride.stem().string())
        name += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ? c : '_';
    return fmt::format("halfdisk-{}", name.empty() ? "scene" : name);
}

}  // namespace

std::vector<ExportFile> exportFiles(const AppState& state, const Seen& seen) {
    std::vector<ExportFile> files{{"screen.png", encodePng(seen.screen)}};
    for (const SvgDrawing& drawing : seen.sheet.drawings)
        files.push_back({fmt::format("{}.svg", drawing.name()),
                         drawing.svg(titleOf(state, drawing.name()), descriptionOf(state, drawing.name()))});
    for (const PlotTable& plot : kPlotTables)
        if (seen.sheet.find(plot.name) || (plot.view == View::field && state.shows(View::field)))
            files.push_back({fmt::format("{}.csv", plot.name), plot.table(state)});
    files.push_back({"tree.json", treeJson(state)});
    files.push_back({"state.txt", stateText(state)});
    files.push_back({"state.halfdisk", shareText(state) + '\n'});
    return files;
}

void writeExport(const fs::path& folder, const std::vector<ExportFile>& files) {
    for (const ExportFile& file : files) writeFileAtomically(folder / file.name, file.bytes);
    // What an export of another step left here would pass for this one's.
    std::error_code none;
    const auto forget = [&](const std::string& name) {
        const auto isIt = [&](const ExportFile& file) { return file.name == name; };
        if (std::none_of(files.begin(), files.end(), isIt)) fs::remove(folder / name, none);
    };
    for (const PlotTable& plot : kPlotTables) {
        forget(fmt::format("{}.csv", plot.name));
        forget(fmt::format("{}.svg", plot.name));
    }
}

fs::path newExportFolder(const fs::path& parent, const AppState& state) {
    constexpr int kMostFolders = 10'000;
    const std::string name = nameOf(state);
    for (int number = 1; number < kMostFolders; ++number) {
        const fs::path folder = parent / (number == 1 ? name : fmt::format("{}_{}", name, number));
        std::error_code failed;
        if (fs::create_directory(folder, failed)) return folder;
        if (failed && !fs::exists(fs::symlink_status(folder)))
            throw std::runtime_error(
                fmt::format("{}: the folder cannot be made: {}", folder.string(), failed.message()));
    }
    throw std::runtime_error(fmt::format("there are too many folders {} in {}", name, parent.string()));
}

void exportIfReady(Session& session, const FrameMaker& maker, const fs::path& parent) {
    AppState& state = session.state;
    if (!state.exportWished || !lightIsComplete(state)) return;
    fs::path folder;
    try {
        const Seen seen = seenBy(session, maker);
        if (!lightIsComplete(state)) return;  // something was changed meanwhile: later
        state.exportWished = false;
        folder = newExportFolder(parent, state);
        const std::vector<ExportFile> files = exportFiles(state, seen);
        writeExport(folder, files);
        state.notice = say("{} files are written to {}", files.size(), folder.string());
    } catch (const std::exception& error) {
        state.exportWished = false;
        std::error_code none;
        if (!folder.empty()) fs::remove_all(folder, none);  // it was made just now
        state.banner = say("Nothing is exported: {}", trMessage(error.what()));
    }
}

}  // namespace halfdisk
