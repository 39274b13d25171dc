// How much light arrives along P's wall? A curve for each maker, with what chance still does to it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/plot.h"
#include "app/plot_words.h"
#include "app/profile_difference.h"
#include "app/shown_pictures.h"

namespace halfdisk {
namespace {

struct Curve {
    const LightPicture* picture;
    std::string title;
    ImU32 color;
    bool second;
};

/// Those that have something to show.
std::vector<Curve> curvesOf(const Ui& ui) {
    std::vector<Curve> curves;
    for (const ShownPicture& shown : shownPictures(ui.state, View::profile))
        curves.push_back({shown.picture, shown.maker, shown.second ? ui.palette.exact : ui.palette.estimate,
                          shown.second});
    return curves;
}

/// Null unless differences are to be seen.
const std::vector<Rgb>* exactProfile(const AppState& state) {
    if (!state.shows(View::difference) || !state.answer) return nullptr;
    return state.answer->exactPictures[0].profile.get();
}

std::string whyEmpty(const AppState& state) {
    if (state.answer)
        for (const auto* picture : {&state.answer->pictures.profile, &state.answer->against.profile})
            if (*picture && !(*picture)->refusal.empty()) return trMessage((*picture)->refusal);
    return "being computed";
}

/// A little above nearly all of the light, so that one wild bin does not flatten the rest.
double topOf(const std::vector<Curve>& curves) {
    double top = 0.0;
    for (const Curve& curve : curves) {
        std::vector<double> values;
        for (const Rgb& mean : curve.picture->film.pixels.mean) values.push_back(gray(mean));
        std::sort(values.begin(), values.end());
        const double most = values.back(), usual = values[values.size() - 1 - values.size() / 32];
        top = std::max(top, most < 3.0 * usual ? most : std::max(usual, most / 3.0));
    }
    return top > 0.0 ? 1.15 * top : 1.0;
}

/// What goes on beyond the frame, above it or below.
void drawArrow(const Ui& ui, const Plot& plot, double place, bool up, ImU32 color) {
    const float x = plot.at(place, 0.0).x, y = up ? plot.area.min.y : plot.area.max.y, half = 4 * ui.scale;
    const float in = up ? 2 * half : -2 * half;
    penOf(ui).AddTriangleFilled({x, y}, {x + half, y + in}, {x - half, y + in}, color);
}

struct Bin {
    double value, error;
};

/// One step a bin, with a band of one standard error on both sides.
void drawSteps(const Ui& ui, const Plot& plot, const std::vector<Bin>& bins, double length, ImU32 color) {
    const double width = length / static_cast<double>(bins.size());
    std::vector<ImVec2> steps;
    const Pen list = penOf(ui);
    list.PushClipRect(plot.area.min, plot.area.max, true);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const double from = width * static_cast<double>(i);
        const auto& [value, error] = bins[i];
        list.AddRectFilled(plot.at(from, value + error), plot.at(from + width, value - error),
                           withOpacity(color, 0.25f));
        steps.push_back(plot.at(from, value));
        steps.push_back(plot.at(from + width, value));
        if (value > plot.y.to || value < plot.y.from)
            drawArrow(ui, plot, from + width / 2, value > plot.y.to, color);
    }
    list.PopClipRect();
    plotLine(ui, plot, steps, color, 2 * ui.scale);
}

void drawCurve(const Ui& ui, const Plot& plot, const Curve& curve, double length) {
    std::vector<Bin> bins;
    for (std::size_t i = 0; i < curve.picture->film.pixels.size(); ++i) {
        const Statistics bin = curve.picture->film.pixels[i];
        bins.push_back({gray(bin.mean), gray(bin.standardError())});
    }
    drawSteps(ui, plot, bins, length, curve.color);
}

/// Through the middles of the bins.
void drawExact(const Ui& ui, const Plot& plot, const std::vector<Rgb>& bins, double length, ImU32 color) {
    const double width = length / static_cast<double>(bins.size());
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < bins.size(); ++i)
        line.push_back(plot.at(width * (static_cast<double>(i) + 0.5), gray(bins[i])));
    plotLine(ui, plot, line, color, 4 * ui.scale);
}

std::size_t binAt(double place, double length, std::size_t count) {
    const double share = std::clamp(place / length, 0.0, 0.999999);
    return static_cast<std::size_t>(share * static_cast<double>(count));
}

void drawPlace(const Ui& ui, const Plot& plot, double length) {
    const float at = plot.at(ui.state.at.t * length, 0.0).x;
    penOf(ui).AddLine({at, plot.area.min.y}, {at, plot.area.max.y}, withOpacity(ui.palette.point, 0.5f),
                      1.5f * ui.scale);
    drawText(ui, {at + 3 * ui.scale, plot.area.max.y - ImGui::GetFontSize() - 2 * ui.scale},
             ui.palette.estimate, "P");
}

/// What the pointer reads there; a click brings P there, where it may be moved.
void point(const Ui& ui, double place, double length, std::size_t count, std::string words) {
    if (!ui.state.isUnlocked(Control::point)) return tooltip(words);
    words += fmt::format("\n{}", tr("click: P to this place"));
    tooltip(words);
    if (!ImGui::IsMouseClicked(0)) return;
    const auto bin = static_cast<double>(binAt(place, length, count));
    ui.commands.push_back(MovePoint{{ui.state.at.segment, (bin + 0.5) / static_cast<double>(count)}});
}

/// On a scale of its own: what is too small to be seen in the light itself.
void differencePlot(const Ui& ui, ImVec2 size, double length) {
    const OnSheet drawing(ui, "difference", size);
    const AppState& state = ui.state;
    const std::vector<Curve> curves = curvesOf(ui);
    const std::array<ProfileDifference, 2> differences = profileDifferences(state);
    const double reach = reachOf(differences);
    std::vector<PlotKey> keys;
    for (const Curve& curve : curves) keys.push_back({curve.color, curve.title});
    const Plot plot = beginPlot(ui, "difference", drawingTitle(state, "difference"), size,
                                {0.0, length, false, "place on the wall, m", 0.0},
                                {-reach, reach, false, "difference, % of the exact mean", reach}, keys);
    const Pen list = penOf(ui);
    list.AddLine(plot.at(0.0, 0.0), plot.at(length, 0.0), ui.palette.ink, 3 * ui.scale);
    drawPlace(ui, plot, length);
    for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) {
        const ProfileDifference& one = differences[curve->second ? 1 : 0];
        if (one.percent.empty()) continue;
        std::vector<Bin> bins;
        for (std::size_t i = 0; i < one.percent.size(); ++i) bins.push_back({one.percent[i], one.error[i]});
        drawSteps(ui, plot, bins, length, curve->color);
    }
    if (!plot.hovered() || curves.empty()) return;
    const double place = plot.xAt(ImGui::GetIO().MousePos.x);
    std::string words = say("{:.3g} m along the wall", place);
    for (const Curve& curve : curves) {
        const ProfileDifference& one = differences[curve.second ? 1 : 0];
        if (one.percent.empty()) continue;
        const std::size_t bin = binAt(place, length, one.percent.size());
        words += say("\n{:+.2g} % \u00b1 {:.1g} %  {}", one.percent[bin], one.error[bin], curve.title);
    }
    point(ui, place, length, curves.front().picture->film.pixels.size(), words);
}

/// `withPlaces`: the axis below says what it is; else another plot on the same axis follows.
void valuePlot(const Ui& ui, ImVec2 size, double length, bool withPlaces) {
    const OnSheet drawing(ui, "profile", size);
    const AppState& state = ui.state;
    const std::string title = drawingTitle(state, "profile");
    const std::vector<Curve> curves = curvesOf(ui);
    const PlotAxis along{0.0, length, false, withPlaces ? "place on the wall, m" : "", 0.0};
    if (curves.empty()) {
        const Plot plot = beginPlot(ui, "profile", title, size, along, {});
        drawText(ui, {(plot.area.min.x + plot.area.max.x) / 2, (plot.area.min.y + plot.area.max.y) / 2},
                 ui.palette.inkSoft, whyEmpty(state), Align::middle);
        return;
    }
    const std::vector<Rgb>* exact = exactProfile(state);
    const ImU32 exactColor = curves.size() > 1 ? ui.palette.ink : ui.palette.exact;
    std::vector<PlotKey> keys;
    for (const Curve& curve : curves) keys.push_back({curve.color, curve.title});
    if (exact) keys.push_back({exactColor, "exactly"});
    const Plot plot = beginPlot(ui, "profile", title, size, along,
                                {0.0, topOf(curves), false, "irradiance E, W/m", 0.0}, keys);
    drawPlace(ui, plot, length);
    if (exact) drawExact(ui, plot, *exact, length, exactColor);
    for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) drawCurve(ui, plot, *curve, length);
    if (!plot.hovered()) return;
    const double place = plot.xAt(ImGui::GetIO().MousePos.x);
    std::string words = say("{:.3g} m along the wall", place);
    for (const Curve& curve : curves) {
        const PixelStatistics& bins = curve.picture->film.pixels;
        const Statistics bin = bins[binAt(place, length, bins.size())];
        words +=
            say("\nE = {} \u00b1 {:.1g} W/m  {}", shown(bin.mean), gray(bin.standardError()), curve.title);
    }
    if (exact) words += say("\nexactly {} W/m", shown((*exact)[binAt(place, length, exact->size())]));
    point(ui, place, length, curves.front().picture->film.pixels.size(), words);
}

/// Design pixels: less is no plot.
constexpr float kLeastHeight = 130, kLeastWidth = 230;

}  // namespace

void profilePlot(const Ui& ui, ImVec2 size) {
    const double length = ui.state.scene->index.length(ui.state.at.segment);
    const ImVec2 gap = ImGui::GetStyle().ItemSpacing;
    const ImVec2 half{std::floor((size.x - gap.x) / 2), std::floor((size.y - gap.y) / 2)};
    const bool below = half.y >= kLeastHeight * ui.scale, beside = half.x >= kLeastWidth * ui.scale;
    if (!plotsDifference(ui.state) || (!below && !beside)) return valuePlot(ui, size, length, true);
    // The difference is what is to be seen, and it has the axis' words as well.
    const float more = below ? std::floor(ImGui::GetFontSize()) : 0.0f;
    const ImVec2 part = below ? ImVec2{size.x, half.y} : ImVec2{half.x, size.y};
    valuePlot(ui, {part.x, part.y - more}, length, !below);
    if (!below) ImGui::SameLine();
    differencePlot(ui, {part.x, part.y + more}, length);
}

}  // namespace halfdisk
