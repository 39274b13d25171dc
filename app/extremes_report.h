// How does the table of extremes read, for people and for machines?
#pragma once

#include "app/cli_output.h"
#include "core/extremes/cell.h"

namespace halfdisk {

/// A cell and what came of it. The cell outlives it.
struct ExtremeLine {
    const ExtremeCell* cell = nullptr;
    ExtremeOutcome outcome;
    bool holds = false;
    double seconds = 0.0;
};

/// "gap" of "gap:1e-5".
std::string rowOf(const ExtremeCell& cell);
/// All of them, once each, with commas.
std::string rowNames(const std::vector<ExtremeCell>& cells);

/// `asked`: how many lines there were to be.
std::string extremesText(const std::vector<ExtremeLine>& lines, std::size_t asked);
std::string listText(const std::vector<ExtremeCell>& cells);
Json extremesJson(const std::vector<ExtremeLine>& lines);

}  // namespace halfdisk
