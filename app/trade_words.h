// What does the trade tell, in words and in a table? What was chosen and why, what then happened, and how
// each setting stands.
#pragma once

#include <string>

#include "app/app_state.h"

namespace halfdisk {

/// Null: not wanted, or not begun.
const TradeSoFar* tradeOf(const AppState& state);

/// What the wish picks of what is measured so far.
std::optional<TradeChoice> choiceOf(const AppState& state, const TradeSoFar& trade);

/// What then happened; null: not known, or that of an older wish.
const TradeCheck* checkOf(const TradeSoFar& trade, const TradeChoice& choice);

/// What makes the stage's pictures as a setting does; nothing if the stage cannot show it. It follows as many
/// mirrors and skins of glass as the stage does, for so many the trade was measured.
std::optional<Maker> makerOf(const TradeSetting& setting, std::uint32_t askedDepth,
                             std::optional<std::uint32_t> stageSpecular = std::nullopt);

/// Of a cell, for the stage as it is.
std::optional<Maker> makerOf(const AppState& state, const TradeSoFar& trade, std::size_t cell);

/// The cell whose setting makes the pictures now.
std::optional<std::size_t> cellOnStage(const AppState& state, const TradeSoFar& trade);

/// Why there is nothing to choose from, or how many settings are measured; empty: all of them.
std::string tradeProgress(const TradeSoFar& trade);

/// What is chosen, and why; or that nothing can be.
std::string choiceWords(const AppState& state, const TradeSoFar& trade);

/// What the settings are held against, and how well that is known; empty: not known yet.
std::string truthWords(const TradeSoFar& trade);

/// Predicted beside measured.
std::string checkWords(const AppState& state, const TradeSoFar& trade);

/// Of one setting, line by line: rays, error, bias, and why it is on the front or is not.
std::string cellWords(const TradeReport& report, std::size_t cell);

std::string tradeWords(const AppState& state);
/// CSV: see plot_tables.h.
std::string tradeTable(const AppState& state);

}  // namespace halfdisk
