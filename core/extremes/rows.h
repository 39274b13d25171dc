// Which rows has the table of extremes? One function for each subject.
#pragma once

#include "core/extremes/cell.h"

namespace halfdisk {

/// Of one operation in double, relative: h = 2^-53.
inline constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2.0;

void addPlacingRows(std::vector<ExtremeCell>& cells);   ///< scale, offset
void addWallRows(std::vector<ExtremeCell>& cells);      ///< lengths, angles, gaps, corners
void addMeetingRows(std::vector<ExtremeCell>& cells);   ///< walls on each other, crossing, a million of them
void addLightRows(std::vector<ExtremeCell>& cells);     ///< lamps in a wall's plane, touching it
void addSeriesRows(std::vector<ExtremeCell>& cells);    ///< albedo, depth
void addSampleRows(std::vector<ExtremeCell>& cells);    ///< N
void addGlassRows(std::vector<ExtremeCell>& cells);     ///< index of refraction, critical angle
void addChainRows(std::vector<ExtremeCell>& cells);     ///< total reflections in a row
void addLobeRows(std::vector<ExtremeCell>& cells);      ///< roughness
void addRadianceRows(std::vector<ExtremeCell>& cells);  ///< from faint to bright
void addSparseRows(std::vector<ExtremeCell>& cells);    ///< one segment, none, no light

/// `1e-05` as `1e-5`: for ids and titles.
std::string powerText(double value);
/// Three digits.
std::string shortText(double value);

}  // namespace halfdisk
