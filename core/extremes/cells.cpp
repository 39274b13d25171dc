#include <cstdio>

#include "core/extremes/rows.h"

namespace halfdisk {

std::vector<ExtremeCell> extremeCells() {
    std::vector<ExtremeCell> cells;
    for (const auto& add :
         {addPlacingRows, addWallRows, addMeetingRows, addLightRows, addSeriesRows, addSampleRows,
          addGlassRows, addChainRows, addLobeRows, addRadianceRows, addSparseRows})
        add(cells);
    return cells;
}

std::string shortText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string powerText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", value);
    std::string said(text);
    const std::size_t e = said.find('e');
    const int power = std::atoi(said.c_str() + e + 1);
    return said.substr(0, e) + "e" + std::to_string(power);
}

}  // namespace halfdisk
