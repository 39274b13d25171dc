#include "core/extremes/rows.h"
namespace halfdisk {
void addMeetingRows(std::vector<ExtremeCell>&) {}
void addLightRows(std::vector<ExtremeCell>&) {}
void addSampleRows(std::vector<ExtremeCell>&) {}
void addGlassRows(std::vector<ExtremeCell>&) {}
void addLobeRows(std::vector<ExtremeCell>&) {}
void addRadianceRows(std::vector<ExtremeCell>&) {}
void addSparseRows(std::vector<ExtremeCell>&) {}
std::vector<ExtremeCell> extremeCellsOf(const Scene&) {
    return {};
}
}  // namespace halfdisk
