// How is a trade told to machines? As JSON and CSV.
#pragma once

#include <string>

#include "app/trade_files.h"

namespace halfdisk {

/// Keys whose numbers depend on the machine have "seconds" in their names, or in that of what they are in.
Json reportJson(const TradeFolder& trade, const TradeReport& report);
std::string reportCsv(const TradeReport& report);

}  // namespace halfdisk
