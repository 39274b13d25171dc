// Which files hold what is seen, and how do they get into a folder?
//
//   screen.png                the whole screen
//   canvas.svg, PLOT.svg      integrand, error, histogram, profile, eye, strategies: those that are shown
//   PLOT.csv, field.csv       their numbers
//   tree.json                 the recorded run: see tree_json.h
//   state.txt                 all of it in words
//   state.halfdisk            the state as a text that brings it back: see share_text.h
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/seen.h"

namespace halfdisk {

struct ExportFile {
    std::string name, bytes;
};

/// The same state and picture give the same bytes.
std::vector<ExportFile> exportFiles(const AppState& state, const Seen& seen);

/// Each whole or not at all. The folder is there. Throws std::runtime_error naming the file.
void writeExport(const std::filesystem::path& folder, const std::vector<ExportFile>& files);

/// Makes `halfdisk-SLUG-STEP` in `parent`, with a number at its end if there is one already. Throws
/// std::runtime_error.
std::filesystem::path newExportFolder(const std::filesystem::path& parent, const AppState& state);

/// Between two frames of a window: does what was wished for if the light is complete, and tells in the
/// state's notice or banner.
void exportIfReady(Session& session, const FrameMaker& maker, const std::filesystem::path& parent);

}  // namespace halfdisk
