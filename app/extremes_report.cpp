#include "app/extremes_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfdisk {
namespace {

/// `2.2e-16`; `0` is exactly right.
std::string errorText(double error) {
    if (error == 0.0) return "0";
    if (std::isnan(error)) return "NaN";  // of either sign
    return std::isfinite(error) ? fmt::format("{:.1e}", error) : fmt::format("{}", error);
}

/// Nothing of a side that was not asked.
std::string errorText(const ExtremeSide& side) {
    return side.asked ? errorText(side.error) : std::string("-");
}

constexpr std::size_t kTextWidth = 112, kTextIndent = 6;

/// In lines that fit, each below the cell's id.
std::string indented(std::string_view words) {
    std::string text;
    while (!words.empty()) {
        std::size_t end = words.size();
        if (end > kTextWidth - kTextIndent) {
            end = words.rfind(' ', kTextWidth - kTextIndent);
            if (end == std::string_view::npos) end = kTextWidth - kTextIndent;
        }
        text += fmt::format("{:<{}}{}\n", "", kTextIndent, words.substr(0, end));
        words.remove_prefix(std::min(words.size(), end + 1));
    }
    return text;
}

/// `12/3/0`, or nothing where no ray was asked.
std::string faultsText(const ExtremeCounts& counts) {
    if (counts.rays == 0 && counts.faults() == 0) return "-";
    return fmt::format("{}/{}/{}", counts.leaks, counts.selfHits, counts.nonFinite);
}

Json sideJson(const ExtremeSide& side) {
    if (!side.asked) return nullptr;
    return Json{{"error", jsonOf(side.error)},        {"rays", side.counts.rays},
                {"leaks", side.counts.leaks},         {"selfHits", side.counts.selfHits},
                {"nonFinite", side.counts.nonFinite}, {"early", side.counts.early},
                {"place", jsonOf(side.counts.place)}};
}

}  // namespace

std::string rowOf(const ExtremeCell& cell) {
    return cell.id.substr(0, cell.id.find(':'));
}

std::string rowNames(const std::vector<ExtremeCell>& cells) {
    std::string names, last;
    for (const ExtremeCell& cell : cells) {
        const std::string row = rowOf(cell);
        if (row != last) names += fmt::format("{}{}", names.empty() ? "" : ", ", row);
        last = row;
    }
    return names;
}

std::string extremesText(const std::vector<ExtremeLine>& lines, std::size_t asked) {
    std::string text =
        fmt::format("{:<5} {:<22} {:>8} {:>8} | {:>13} {:>8} | {:>13} {:>8} | {:>13}\n", "", "", "error",
                    "bound", "leak/self/NaN", "float", "leak/self/NaN", "double", "leak/self/NaN");
    std::size_t held = 0, single = 0, twice = 0;
    double seconds = 0.0;
    for (const ExtremeLine& line : lines) {
        const auto& [ours, naiveFloat, naiveDouble, words, fault] = line.outcome;
        text += fmt::format("{:<5} {:<22} {:>8} {:>8} | {:>13} {:>8} | {:>13} {:>8} | {:>13}\n",
                            line.holds ? "ok" : "FAILS", line.cell->id, errorText(ours),
                            errorText(line.cell->bound), faultsText(ours.counts), errorText(naiveFloat),
                            faultsText(naiveFloat.counts), errorText(naiveDouble),
                            faultsText(naiveDouble.counts));
        text += indented(words);
        if (!fault.empty()) text += indented(fmt::format("FAULT: {}", fault));
        held += line.holds ? 1 : 0;
        single += naiveFloat.asked && holds(*line.cell, naiveFloat) ? 1 : 0;
        twice += naiveDouble.asked && holds(*line.cell, naiveDouble) ? 1 : 0;
        seconds += line.seconds;
    }
    text += fmt::format("{} of {} hold; of the naive program {} in float, {} in double; {:.1f} s\n", held,
                        lines.size(), single, twice, seconds);
    if (lines.size() < asked) text += fmt::format("stopped: {} are left\n", asked - lines.size());
    return text;
}

std::string listText(const std::vector<ExtremeCell>& cells) {
    std::string text;
    for (const ExtremeCell& cell : cells)
        text += fmt::format("{:<22} {}\n{:<22} {}: at most {}; {}\n", cell.id, cell.title, "", cell.unit,
                            errorText(cell.bound), cell.why);
    return text;
}

Json extremesJson(const std::vector<ExtremeLine>& lines) {
    Json cells = Json::array();
    std::size_t held = 0;
    for (const ExtremeLine& line : lines) {
        held += line.holds ? 1 : 0;
        cells.push_back(Json{{"id", line.cell->id},
                             {"title", line.cell->title},
                             {"unit", line.cell->unit},
                             {"bound", jsonOf(line.cell->bound)},
                             {"why", line.cell->why},
                             {"holds", line.holds},
                             {"ours", sideJson(line.outcome.ours)},
                             {"naiveFloat", sideJson(line.outcome.naiveFloat)},
                             {"naiveDouble", sideJson(line.outcome.naiveDouble)},
                             {"naiveFloatHolds", holds(*line.cell, line.outcome.naiveFloat)},
                             {"naiveDoubleHolds", holds(*line.cell, line.outcome.naiveDouble)},
                             {"words", line.outcome.words},
                             {"fault", line.outcome.fault},
                             {"seconds", jsonOf(line.seconds)}});
    }
    return Json{{"held", held}, {"cells", cells}};
}

}  // namespace halfdisk
