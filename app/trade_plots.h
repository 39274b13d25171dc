// How is a trade drawn? The front of all settings, and how their errors fall.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/trade/trade_report.h"

namespace halfdisk {

/// front and convergence, as .svg and .png, each whole or not at all; returns their names.
std::vector<std::string> writeTradePlots(const std::filesystem::path& folder, const TradeReport& report);

}  // namespace halfdisk
