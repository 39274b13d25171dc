// How do the plots of a trade get into files? Drawn as in the window, without one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/trade/trade_report.h"

namespace halfdisk {

/// front and convergence, as .svg and .png, each whole or not at all; returns their names. Without OpenGL
/// (see HeadlessHost) only the .svg. Throws std::runtime_error naming a file that can't be written.
std::vector<std::string> writeTradePlots(const std::filesystem::path& folder, const TradeReport& report);

}  // namespace halfdisk
