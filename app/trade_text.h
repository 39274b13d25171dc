// How is a trade told: to people as a table, to machines as CSV and JSON?
#pragma once

#include <string>

#include "app/trade_files.h"

namespace halfdisk {

/// All measured cells, by number, judged.
TradeReport reportOf(const TradeFolder& trade);

/// Keys whose numbers depend on the machine have "seconds" in their names.
Json reportJson(const TradeFolder& trade, const TradeReport& report);
std::string reportCsv(const TradeReport& report);

/// The table, best first, then fronts, crossings and what nobody should choose.
std::string reportText(const TradeFolder& trade, const TradeReport& report);

/// What a verdict says in a few words: `on the front`, `nobody`, `biased` ...
std::string verdictWords(const TradeReport& report, std::size_t cell);

}  // namespace halfdisk
