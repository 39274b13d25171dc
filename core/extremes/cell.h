// What is one line of the table of extremes? A question with a known answer, and the error that three answers
// may have: the product's, and those of a naive twin in float and in double.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/extremes/survey.h"

namespace halfdisk {

struct ExtremeSide {
    double error = 0.0;  ///< in the cell's unit; NaN and infinity are possible
    ExtremeCounts counts{};
    bool asked = true;  ///< false: there is nothing that a naive twin would do otherwise
};

struct ExtremeOutcome {
    ExtremeSide ours, naiveFloat, naiveDouble;
    std::string words;  ///< what else there is to tell
    std::string fault;  ///< what is wrong besides the error; empty: nothing
};

struct ExtremeCell {
    std::string id;      ///< row:value, like "gap:1e-5"
    std::string title;   ///< like "walls 1e-5 apart"
    std::string unit;    ///< of what the errors are
    double bound = 0.0;  ///< most that the product's error may be
    std::string why;     ///< where the bound comes from
    std::function<ExtremeOutcome(const StopQuestion&)> run;
};

/// The product keeps the bound, loses no ray, and says nothing that is wrong.
inline bool holds(const ExtremeCell& cell, const ExtremeOutcome& outcome) {
    return outcome.ours.error <= cell.bound && outcome.ours.counts.faults() == 0 && outcome.fault.empty();
}

/// The same of a naive twin: what makes the cell worth its line.
inline bool holds(const ExtremeCell& cell, const ExtremeSide& naive) {
    return naive.error <= cell.bound && naive.counts.faults() == 0;
}

/// All of them, in the order of the table.
std::vector<ExtremeCell> extremeCells();

/// Those that a scene of one's own can be put through. The scene is copied.
std::vector<ExtremeCell> extremeCellsOf(const Scene& scene);

}  // namespace halfdisk
