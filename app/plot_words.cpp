#include "app/plot_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/canvas_words.h"
#include "app/draw_text.h"
#include "app/exact_stages.h"
#include "app/goal_check.h"
#include "app/histogram.h"
#include "app/instrument_words.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/profile_difference.h"
#include "app/render_sensor.h"
#include "app/requirements_words.h"
#include "app/scene_words.h"
#include "app/shown_pictures.h"
#include "app/trade_words.h"

namespace halfdisk {
namespace {

constexpr double kDegreesPerRadian = 180.0 / kPi;
constexpr std::size_t kParts = 8;

/// The mean of each of so many equal parts of a row.
std::vector<double> partMeans(const std::vector<double>& values, std::size_t parts) {
    std::vector<double> means;
    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t from = part * values.size() / parts, to = (part + 1) * values.size() / parts;
        double sum = 0.0;
        for (std::size_t i = from; i < to; ++i) sum += values[i];
        means.push_back(to > from ? sum / static_cast<double>(to - from) : 0.0);
    }
    return means;
}

std::string listed(const std::vector<double>& values) {
    std::string words;
    for (const double value : values) words += fmt::format("{}{:.3g}", words.empty() ? "" : ", ", value);
    return local(words);
}

std::vector<double> graysOf(const LightPicture& picture) {
    std::vector<double> values;
    for (const Rgb& mean : picture.film.pixels.mean) values.push_back(gray(mean));
    return values;
}

std::string integrandWords(const AppState& state) {
    if (!state.answer || state.answer->integrand.empty())
        return std::string(tr("Nothing exact is known about P."));
    if (asksForCurve(state) && !isDrawn(state))
        return std::string(tr("The curve is hidden until it is drawn."));
    const auto& points = state.answer->integrand;
    const auto brighter = [](const IntegrandPoint& a, const IntegrandPoint& b) {
        return gray(a.radiance) < gray(b.radiance);
    };
    const auto [least, most] = std::minmax_element(points.begin(), points.end(), brighter);
    const auto weighted = [](const IntegrandPoint& p) { return gray(p.radiance) * std::sin(p.theta); };
    const auto heaviest = std::max_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return weighted(a) < weighted(b);
    });
    std::vector<double> values;
    for (auto p = points.rbegin(); p != points.rend(); ++p) values.push_back(gray(p->radiance));
    const auto angle = [](const IntegrandPoint& p) { return 90.0 - p.theta * kDegreesPerRadian; };
    return say(
        "Light L against the angle from the normal, -90 to 90 degrees (positive to the right): from {} to {} "
        "W/(m rad), most at {:.0f} degrees. Weighed by the cosine, most is {} at {:.0f} degrees.\n"
        "Mean of L in eight equal parts from -90 to 90 degrees: {}.",
        shown(gray(least->radiance)), shown(gray(most->radiance)), angle(*most), shown(weighted(*heaviest)),
        angle(*heaviest), listed(partMeans(values, kParts)));
}

std::string errorWords(const AppState& state) {
    if (!state.answer || state.answer->errors.size() < 2)
        return std::string(tr("Not measured, for no exact value is known."));
    const ErrorPoint &first = state.answer->errors.front(), &last = state.answer->errors.back();
    std::string words = say(
        "Root mean square error of E over 48 runs each, N doubling from {:.0f} to {:.0f}: from {} W/m down "
        "to "
        "{} W/m.",
        first.samples, last.samples, shown(first.rms), shown(last.rms));
    if (first.rms > 0.0 && last.rms > 0.0)
        words +=
            say(" That is {:.3g} times less for {:.0f} times as many samples (the square root is "
                "{:.3g}).",
                first.rms / last.rms, last.samples / first.samples, std::sqrt(last.samples / first.samples));
    return words;
}

std::string histogramWords(const AppState& state) {
    if (!state.answer || state.answer->histogramOf.empty()) return std::string(tr("Nothing was counted."));
    const Histogram histogram = histogramOf(state.answer->histogramOf);
    const auto fullest = std::max_element(histogram.counts.begin(), histogram.counts.end());
    const auto bin = static_cast<std::size_t>(fullest - histogram.counts.begin());
    const auto zeros = std::count(state.answer->histogramOf.begin(), state.answer->histogramOf.end(), 0.0);
    return say(
        "{:.0f} single samples bring from {} to {} W/m, in the mean {}. {:.3g} % bring nothing at all. The "
        "fullest of {} bins is that from {} to {} W/m, with {:.3g} %.",
        histogram.counted, shown(histogram.low), shown(histogram.high), shown(histogram.mean),
        100.0 * static_cast<double>(zeros) / std::max(1.0, histogram.counted), Histogram::kBins,
        shown(histogram.edge(bin)), shown(histogram.edge(bin + 1)), 100.0 * *fullest / histogram.counted);
}

/// `not shown: ...` of pictures that an estimator refuses to make.
std::string refusals(const AppState& state, View view) {
    std::string words;
    if (!state.answer) return words;
    for (const PictureSet* pictures : {&state.answer->pictures, &state.answer->against})
        if (const auto& picture = pictures->of(view); picture && !picture->refusal.empty())
            words += say("{}No picture: {}.", words.empty() ? "" : "\n", trMessage(picture->refusal));
    return words;
}

std::string costWords(const AppState& state, View view, const ShownPicture& one) {
    const LightPicture& picture = *one.picture;
    std::string words = say("{} rays", picture.film.counts.rays);
    if (picture.noise) words += say(", noise {:.2g} %", 100.0 * *picture.noise);
    const std::optional<double> error = errorOf(*state.answer, view, one.second ? 1 : 0);
    if (error) words += say(", {:.2g} % from the exact one", 100.0 * *error);
    if (picture.firstLook) words += fmt::format(", {}", tr("a coarse first look"));
    if (!picture.complete) words += tr(", not complete yet");
    return words;
}

/// What the picture should be, where that is asked for.
std::string exactWords(const AppState& state, View view, std::string_view unit, std::string_view ends) {
    if (!state.shows(View::difference) || (view != View::eye && view != View::profile)) return {};
    const auto& exact = state.answer->exactPictures[0].of(view);
    if (!exact) return fmt::format("\n{}", tr("The exact one is not known."));
    std::vector<double> values;
    for (const Rgb& pixel : *exact) values.push_back(gray(pixel));
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return say("\nThe exact one: from {} to {} {}.\nMean of eight equal parts {}: {}.", shown(*least),
               shown(*most), unit, ends, listed(partMeans(values, kParts)));
}

/// What `where` says of the brightest pixel, and eight parts from one end to the other.
std::string rowWords(const AppState& state, View view, std::string_view unit, std::string_view ends,
                     const auto& where) {
    std::string words;
    for (const ShownPicture& shownOne : shownPictures(state, view)) {
        const std::vector<double> values = graysOf(*shownOne.picture);
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        words += say("{}{} ({}): from {} to {} {}, most {}.\nMean of eight equal parts {}: {}.",
                     words.empty() ? "" : "\n", shownOne.maker, costWords(state, view, shownOne),
                     shown(*least), shown(*most), unit,
                     where(*shownOne.picture, static_cast<std::uint32_t>(most - values.begin())), ends,
                     listed(partMeans(values, kParts)));
    }
    words += exactWords(state, view, unit, ends);
    const std::string refused = refusals(state, view);
    if (!words.empty() && !refused.empty()) words += '\n';
    words += refused;
    return words.empty() ? std::string(tr("There is no picture yet.")) : words;
}

std::string profileWords(const AppState& state) {
    const std::string& wall = state.scene->scene.segmentNames[state.at.segment];
    return rowWords(state, View::profile, "W/m", say("from the beginning of {} to its end", wall),
                    [&](const LightPicture& picture, std::uint32_t bin) {
                        return say("{:.3g} m from the beginning",
                                   PixelPlaces(picture.sensor, state.answer->asked.scene->index).at(bin)[0]);
                    });
}

std::string differenceWords(const AppState& state) {
    std::string words;
    const auto differences = profileDifferences(state);
    for (const ShownPicture& one : shownPictures(state, View::profile)) {
        const std::vector<double>& percent = differences[one.second ? 1 : 0].percent;
        if (percent.empty()) continue;
        const auto [least, most] = std::minmax_element(percent.begin(), percent.end());
        words += say(
            "{}{}: from {:+.2g} % to {:+.2g} % of the exact mean.\nMean of eight equal parts along the wall: "
            "{}.",
            words.empty() ? "" : "\n", one.maker, *least, *most, listed(partMeans(percent, kParts)));
    }
    return words.empty() ? std::string(tr("The exact one is not known.")) : words;
}

std::string eyeStripWords(const AppState& state) {
    if (!state.scene->scene.eye) return std::string(tr("This scene has no eye."));
    return rowWords(state, View::eye, "W/(m rad)", tr("from left to right"),
                    [&](const LightPicture& picture, std::uint32_t pixel) {
                        const double degrees =
                            PixelPlaces(picture.sensor, state.answer->asked.scene->index).at(pixel)[0];
                        return degrees < 0.0 ? say("{:.0f} degrees to the left of the middle", -degrees)
                                             : say("{:.0f} degrees to the right of the middle", degrees);
                    });
}

std::string fieldWords(const AppState& state) {
    std::string words;
    for (const ShownPicture& shownOne : shownPictures(state, View::field)) {
        const Field& field = std::get<Field>(shownOne.picture->sensor);
        const std::vector<double> values = graysOf(*shownOne.picture);
        const std::uint32_t across = std::min(8u, field.width), down = std::min(4u, field.height);
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        const PixelPlaces places(shownOne.picture->sensor, state.answer->asked.scene->index);
        const auto at = places.at(static_cast<std::uint32_t>(most - values.begin()));
        words += say(
            "{}{} ({}): fluence from {} to {} W/m, most at {}. The mean in {} parts from left to right, in "
            "{} "
            "rows "
            "from the top:",
            words.empty() ? "" : "\n", shownOne.maker, costWords(state, View::field, shownOne), shown(*least),
            shown(*most), placeWords({at[0], at[1]}), across, down);
        for (std::uint32_t part = 0; part < down; ++part) {
            std::vector<double> row(field.width, 0.0);
            const std::uint32_t from = part * field.height / down, to = (part + 1) * field.height / down;
            for (std::uint32_t y = from; y < to; ++y)
                for (std::uint32_t x = 0; x < field.width; ++x)
                    row[x] += values[std::size_t{y} * field.width + x] / (to - from);
            words += say("\nrow {}: {}", part + 1, listed(partMeans(row, across)));
        }
    }
    const std::string refused = refusals(state, View::field);
    if (!words.empty() && !refused.empty()) words += '\n';
    words += refused;
    return words.empty() ? std::string(tr("There is no picture yet.")) : words;
}

std::string strategiesWords(const AppState& state) {
    const StrategyGrid* grid = state.answer ? state.answer->strategies.get() : nullptr;
    if (!grid || grid->film.whole.passes == 0) return "There is no picture yet.";
    std::string words =
        say("{} rays. Mean of all strategies with their weights: {} \u00b1 {:.1g} {}.",
            grid->film.whole.counts.rays, shown(grid->film.wholeMean.mean[0]),
            gray(grid->film.wholeMean[0].standardError()), grid->ofEye() ? "W/(m rad)" : "W/m");
    for (std::size_t at = 0; at < grid->film.table.size(); ++at) {
        if (grid->film.aloneMeans.mean[at] == Rgb(0.0)) continue;
        const Strategy strategy = grid->film.table[at];
        words += say("\ns = {}, t = {}: {:.3g} % of all light, by itself {:.3g} %.", strategy.s, strategy.t,
                     100.0 * grid->share(at, false), 100.0 * grid->share(at, true));
    }
    if (grid->hasLonger)
        words += say("\nPaths of more than {} vertices: {:.3g} %.", kGridVertices,
                     100.0 * grid->share(grid->film.table.longer(), false));
    return words;
}

}  // namespace

std::string drawingWords(const AppState& state, std::string_view name) {
    if (name == "canvas") return canvasWords(state);
    if (name == "integrand") return integrandWords(state);
    if (name == "error") return errorWords(state);
    if (name == "histogram") return histogramWords(state);
    if (name == "profile") return profileWords(state);
    if (name == "difference") return differenceWords(state);
    if (name == "eye") return eyeStripWords(state);
    if (name == "field") return fieldWords(state);
    if (name == "strategies") return strategiesWords(state);
    if (name == "extremes") return extremesWords(state);
    if (name == "trade") return tradeWords(state);
    if (name == "requirements") return requirementsWords(state);
    return {};
}

std::string drawingTitle(const AppState& state, std::string_view name) {
    if (name == "integrand") return std::string(tr("Light arriving at P"));
    if (name == "error") return std::string(tr("Error against N"));
    if (name == "histogram") return std::string(tr("What single samples bring"));
    if (name == "profile")
        return say("Light along \"{}\"", state.scene->scene.segmentNames[state.at.segment]);
    if (name == "difference") return std::string(tr("How far that is from the exact light"));
    if (name == "eye") return std::string(tr("What the eye sees"));
    if (name == "field") return std::string(tr("The field of light"));
    if (name == "strategies") return std::string(tr("All strategies (s, t)"));
    if (name == "trade") return std::string(tr("What accuracy costs here"));
    if (name == "extremes") return std::string(tr("This scene at the extremes"));
    if (name == "requirements") return std::string(tr("What this scene requires"));
    return std::string(tr("The scene"));
}

}  // namespace halfdisk
