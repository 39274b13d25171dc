// How does a folder keep what was measured, cell by cell, so that work can be shared, stopped and gone on
// with?
//
//   reference.json     the truth, with its error: see trade_reference_store.h
//   cells/0007.json    one setting, measured: question, truth in numbers, results
//   trade.csv, trade.json, front.svg, ...    what follows, written anew whenever cells are added
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "app/cli_output.h"
#include "core/trade/trade_report.h"

namespace halfdisk {

/// What is known of a trade: all that its files hold. Cells by their number among the settings.
struct TradeFolder {
    Json question;
    TradeTruth truth;
    std::string referenceWords;
    double target = 0.05;
    std::map<std::size_t, TradeCell> cells;
    /// Merged parts may have had long runs of their own, by time, for a truth: most by which the light of two
    /// differs, as a share of it. `truth` is the first part's.
    double truthSpread = 0.0;
};

/// Names of the settings of the question that no cell holds.
std::vector<std::string> missingSettings(const TradeFolder& trade);

Json cellJson(const TradeCell& cell);

/// The cells of a folder that answer this question; a folder that is not there has none. Throws InputError
/// for files that answer another question or can't be read.
std::map<std::size_t, TradeCell> readCells(const std::filesystem::path& folder, const Json& question);
void writeCell(const std::filesystem::path& folder, const TradeFolder& trade, std::size_t number);

/// All cells of several folders together. Throws InputError where they answer different questions, or none.
TradeFolder mergedFolders(const std::vector<std::filesystem::path>& folders);

}  // namespace halfdisk
