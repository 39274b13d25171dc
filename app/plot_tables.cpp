#include "app/plot_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/csv_text.h"
#include "app/goal_check.h"
#include "app/histogram.h"
#include "app/profile_difference.h"
#include "app/render_result.h"
#include "app/shown_pictures.h"

namespace halfdisk {
namespace {

constexpr double kDegrees = 180.0 / kPi;

/// Six cells; the last three are empty where one sample alone has no error.
void addWithError(CsvText& table, const Statistics& value) {
    table.cell(value.mean);
    if (hasError(value))
        table.cell(value.standardError());
    else
        table.empty(3);
}

/// What the pixels of the first maker should be; without errors.
void addExact(CsvText& table, const AppState& state, View view) {
    if (!state.answer || view == View::field) return;
    const auto& picture = state.answer->pictures.of(view);
    const auto& exact = state.answer->exactPictures[0].of(view);
    if (!picture || !exact) return;
    const PixelPlaces places(picture->sensor, state.answer->asked.scene->index);
    const std::size_t coordinates = placeColumns(picture->sensor).size();
    for (std::uint32_t pixel = 0; pixel < exact->size(); ++pixel) {
        table.cell(std::string_view("exact"));
        const std::array<double, 2> place = places.at(pixel);
        for (std::size_t i = 0; i < coordinates; ++i) table.cell(place[i]);
        table.cell((*exact)[pixel]).empty(3).endRow();
    }
}

void addPixels(CsvText& table, const AppState& state, View view) {
    for (const ShownPicture& shown : shownPictures(state, view)) {
        const Sensor& sensor = shown.picture->sensor;
        const PixelPlaces places(sensor, state.answer->asked.scene->index);
        const PixelStatistics& pixels = shown.picture->film.pixels;
        const std::size_t coordinates = placeColumns(sensor).size();
        for (std::uint32_t pixel = 0; pixel < pixels.size(); ++pixel) {
            const Statistics value = pixels[pixel];
            table.cell(std::string_view(shown.maker));
            const std::array<double, 2> place = places.at(pixel);
            for (std::size_t i = 0; i < coordinates; ++i) table.cell(place[i]);
            addWithError(table, value);
            table.endRow();
        }
    }
    if (state.shows(View::difference)) addExact(table, state, view);
}

}  // namespace

std::string integrandTable(const AppState& state) {
    CsvText table{"thetaFromNormal (degrees)", "LR (W/(m rad))",    "LG (W/(m rad))",   "LB (W/(m rad))",
                  "LcosR (W/(m rad))",         "LcosG (W/(m rad))", "LcosB (W/(m rad))"};
    if (!state.answer || (asksForCurve(state) && !isDrawn(state))) return table.text();
    for (const IntegrandPoint& point : state.answer->integrand) {
        table.cell(90.0 - point.theta * kDegrees).cell(point.radiance);
        table.cell(point.radiance * std::sin(point.theta));
        table.endRow();
    }
    return table.text();
}

std::string errorTable(const AppState& state) {
    CsvText table{"N", "rmsError (W/m)", "standardErrorOfIt (W/m)"};
    if (!state.answer) return table.text();
    for (const ErrorPoint& point : state.answer->errors)
        table.cell(point.samples).cell(point.rms).cell(point.spread).endRow();
    return table.text();
}

std::string histogramTable(const AppState& state) {
    CsvText table{"from (W/m)", "to (W/m)", "samples", "share (%)", "ofThisRun"};
    if (!state.answer || state.answer->histogramOf.empty()) return table.text();
    const Histogram histogram = histogramOf(state.answer->histogramOf);
    std::array<double, Histogram::kBins> ofRun{};
    for (const Rgb& value : state.answer->contributions) {
        const double light = gray(value);
        if (light >= histogram.low && light <= histogram.high) ++ofRun[histogram.binOf(light)];
    }
    for (std::size_t bin = 0; bin < Histogram::kBins; ++bin) {
        table.cell(histogram.edge(bin)).cell(histogram.edge(bin + 1)).cell(histogram.counts[bin]);
        table.cell(100.0 * histogram.counts[bin] / histogram.counted).cell(ofRun[bin]).endRow();
    }
    return table.text();
}

std::string profileTable(const AppState& state) {
    CsvText table{"maker",    "place (m)",    "ER (W/m)",     "EG (W/m)",
                  "EB (W/m)", "errorR (W/m)", "errorG (W/m)", "errorB (W/m)"};
    addPixels(table, state, View::profile);
    return table.text();
}

std::string differenceTable(const AppState& state) {
    CsvText table{"maker", "place (m)", "difference (% of the exact mean)",
                  "errorOfIt (% of the exact mean)"};
    if (!plotsDifference(state)) return table.text();
    const auto differences = profileDifferences(state);
    for (const ShownPicture& shown : shownPictures(state, View::profile)) {
        const ProfileDifference& one = differences[shown.second ? 1 : 0];
        const PixelPlaces places(shown.picture->sensor, state.answer->asked.scene->index);
        for (std::uint32_t bin = 0; bin < one.percent.size(); ++bin)
            table.cell(std::string_view(shown.maker))
                .cell(places.at(bin)[0])
                .cell(one.percent[bin])
                .cell(one.error[bin])
                .endRow();
    }
    return table.text();
}

std::string eyeTable(const AppState& state) {
    CsvText table{"maker",          "angle (degrees)",    "LR (W/(m rad))",     "LG (W/(m rad))",
                  "LB (W/(m rad))", "errorR (W/(m rad))", "errorG (W/(m rad))", "errorB (W/(m rad))"};
    addPixels(table, state, View::eye);
    return table.text();
}

std::string fieldTable(const AppState& state) {
    CsvText table{"maker",          "x (m)",        "y (m)",        "fluenceR (W/m)", "fluenceG (W/m)",
                  "fluenceB (W/m)", "errorR (W/m)", "errorG (W/m)", "errorB (W/m)"};
    addPixels(table, state, View::field);
    return table.text();
}

std::string strategiesTable(const AppState& state) {
    const StrategyGrid* grid = state.answer ? state.answer->strategies.get() : nullptr;
    const bool ofEye = grid ? grid->ofEye() : state.shows(View::eye);
    const char* const unit = ofEye ? "W/(m rad)" : "W/m";
    CsvText table;
    for (const char* const name : {"s", "t", ofEye ? "place (degrees)" : "place (m)", "share (%)"})
        table.cell(std::string_view(name));
    for (const char* const kind : {"", "error", "alone", "errorAlone"})
        for (const char channel : {'R', 'G', 'B'}) {
            const std::string name = fmt::format("{}{} ({})", kind, channel, unit);
            table.cell(std::string_view(name));
        }
    table.endRow();
    if (!grid || grid->film.whole.passes == 0) return table.text();
    const PixelPlaces places(grid->sensor, state.answer->asked.scene->index);
    const auto numbers = [&](const Statistics& weighted, const Statistics& alone) {
        for (const Statistics& value : {weighted, alone}) addWithError(table, value);
        table.endRow();
    };
    const StrategyFilm& film = grid->film;
    for (std::size_t at = 0; at < film.table.size(); ++at) {
        const Strategy strategy = film.table[at];
        if (!grid->canBe(strategy)) continue;
        table.cell(double(strategy.s)).cell(double(strategy.t)).empty().cell(100.0 * grid->share(at, false));
        numbers(film.weightedMeans[at], film.aloneMeans[at]);
        const PixelStatistics weighted = film.pictureOf(film.weighted, at),
                              alone = film.pictureOf(film.alone, at);
        for (std::uint32_t pixel = 0; pixel < weighted.size(); ++pixel) {
            table.cell(double(strategy.s)).cell(double(strategy.t)).cell(places.at(pixel)[0]).empty();
            numbers(weighted[pixel], alone[pixel]);
        }
    }
    return table.text();
}

}  // namespace halfdisk
