// How is a trade told to people? As a table, and what follows from it.
#pragma once

#include <string>

#include "app/trade_files.h"

namespace halfdisk {

/// All measured cells, by number, judged.
TradeReport reportOf(const TradeFolder& trade);

/// The table, best first, then fronts, crossings and what nobody should choose.
std::string reportText(const TradeFolder& trade, const TradeReport& report);

/// Empty, or the settings that no cell holds.
std::string missingText(const TradeFolder& trade);

/// What a verdict says in a few words: `on the front`, `nobody`, `biased` ...
std::string verdictWords(const TradeReport& report, std::size_t cell);

}  // namespace halfdisk
