// Which numbers does each plot show? As tables: a row for each of its points, the unit of every column in its
// name.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "app/app_state.h"
#include "app/instrument_words.h"
#include "app/requirements_words.h"
#include "app/trade_words.h"

namespace halfdisk {

/// All are CSV (see csv_text.h), with no rows below the header where there is nothing to show. Light is in
/// red, green and blue.
std::string integrandTable(const AppState& state);
std::string errorTable(const AppState& state);
std::string histogramTable(const AppState& state);
/// Mean and, where it is known, standard error of every pixel; with two makers the second's rows follow.
std::string profileTable(const AppState& state);
/// Of each maker's profile from the exact one; no rows unless that is shown.
std::string differenceTable(const AppState& state);
std::string eyeTable(const AppState& state);
std::string fieldTable(const AppState& state);
/// Of each strategy (s, t) its mean over all pixels, where no place is named, then every pixel.
std::string strategiesTable(const AppState& state);

struct PlotTable {
    std::string_view name;  ///< of the drawing, as of the file
    View view;
    std::string (*table)(const AppState& state);
};

inline constexpr std::array<PlotTable, 11> kPlotTables{{
    {"integrand", View::integrand, integrandTable},
    {"error", View::error, errorTable},
    {"histogram", View::histogram, histogramTable},
    {"profile", View::profile, profileTable},
    {"difference", View::difference, differenceTable},
    {"eye", View::eye, eyeTable},
    {"field", View::field, fieldTable},
    {"strategies", View::strategies, strategiesTable},
    {"extremes", View::extremes, extremesTable},
    {"trade", View::trade, tradeTable},
    {"requirements", View::requirements, requirementsTable},
}};

}  // namespace halfdisk
