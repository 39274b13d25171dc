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
#include "app/shown_pictures.h"

namespace halfdisk {
namespace {

struct Curve {
    const LightPicture* picture;
    std::string title;
    ImU32 color;
};

/// Those that have something to show.
std::vector<Curve> curvesOf(const Ui& ui) {
    std::vector<Curve> curves;
    for (const ShownPicture& shown : shownPictures(ui.state, View::profile))
        curves.push_back({shown.picture, shown.maker, shown.second ? ui.palette.exact : ui.palette.estimate});
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
    return top > 0.0 ? 1.35 * top : 1.0;
}

/// One step a bin, with a band of one standard error on both sides.
void drawCurve(const Ui& ui, const Plot& plot, const Curve& curve, double length) {
    const float scale = ui.scale;
    const PixelStatistics& bins = curve.picture->film.pixels;
    const double width = length / static_cast<double>(bins.size());
    std::vector<ImVec2> steps;
    const Pen list = penOf(ui);
    list.PushClipRect(plot.area.min, plot.area.max, true);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const Statistics bin = bins[i];
        const double from = width * static_cast<double>(i), value = gray(bin.mean),
                     error = gray(bin.standardError());
        list.AddRectFilled(plot.at(from, value + error), plot.at(from + width, value - error),
                           withOpacity(curve.color, 0.25f));
        steps.push_back(plot.at(from, value));
        steps.push_back(plot.at(from + width, value));
        if (value <= plot.y.to) continue;
        // It goes on above the frame.
        const float x = plot.at(from + width / 2, 0.0).x, y = plot.area.min.y, half = 4 * scale;
        list.AddTriangleFilled({x, y}, {x + half, y + 2 * half}, {x - half, y + 2 * half}, curve.color);
    }
    list.PopClipRect();
    plotLine(ui, plot, steps, curve.color, 2 * scale);
}

/// Through the middles of the bins.
void drawExact(const Ui& ui, const Plot& plot, const std::vector<Rgb>& bins, double length, ImU32 color) {
    const double width = length / static_cast<double>(bins.size());
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < bins.size(); ++i)
        line.push_back(plot.at(width * (static_cast<double>(i) + 0.5), gray(bins[i])));
    plotLine(ui, plot, line, color, 4 * ui.scale);
}

}  // namespace

void profilePlot(const Ui& ui, ImVec2 size) {
    const OnSheet drawing(ui, "profile", size);
    const AppState& state = ui.state;
    const std::string title = drawingTitle(state, "profile");
    const std::vector<Curve> curves = curvesOf(ui);
    const double length = state.scene->index.length(state.at.segment);
    const PlotAxis along{0.0, length, false, "place on the wall, m", 0.0};
    if (curves.empty()) {
        const Plot plot = beginPlot(ui, "profile", title, size, along, {});
        drawText(ui, {(plot.area.min.x + plot.area.max.x) / 2, (plot.area.min.y + plot.area.max.y) / 2},
                 ui.palette.inkSoft, whyEmpty(state), Align::middle);
        return;
    }
    const Plot plot =
        beginPlot(ui, "profile", title, size, along, {0.0, topOf(curves), false, "irradiance E, W/m", 0.0});
    const Pen list = penOf(ui);
    const float at = plot.at(state.at.t * length, 0.0).x;
    list.AddLine({at, plot.area.min.y}, {at, plot.area.max.y}, withOpacity(ui.palette.point, 0.5f),
                 1.5f * ui.scale);
    drawText(ui, {at + 3 * ui.scale, plot.area.max.y - ImGui::GetFontSize() - 2 * ui.scale},
             ui.palette.estimate, "P");
    const std::vector<Rgb>* exact = exactProfile(state);
    const ImU32 exactColor = curves.size() > 1 ? ui.palette.ink : ui.palette.exact;
    if (exact) drawExact(ui, plot, *exact, length, exactColor);
    int row = 0;
    for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) drawCurve(ui, plot, *curve, length);
    for (const Curve& curve : curves) plotKey(ui, plot, row++, curve.color, curve.title.c_str());
    if (exact) plotKey(ui, plot, row++, exactColor, "exactly");
    if (!plot.hovered()) return;
    const double place = plot.xAt(ImGui::GetIO().MousePos.x),
                 share = std::clamp(place / length, 0.0, 0.999999);
    std::string words = say("{:.3g} m along the wall", place);
    for (const Curve& curve : curves) {
        const PixelStatistics& bins = curve.picture->film.pixels;
        const Statistics bin = bins[static_cast<std::size_t>(share * static_cast<double>(bins.size()))];
        words +=
            say("\nE = {} \u00b1 {:.1g} W/m  {}", shown(bin.mean), gray(bin.standardError()), curve.title);
    }
    if (exact) {
        words += say("\nexactly {} W/m",
                     shown((*exact)[static_cast<std::size_t>(share * static_cast<double>(exact->size()))]));
    }
    if (!state.isUnlocked(Control::point)) return tooltip(words);
    words += fmt::format("\n{}", tr("click: P to this place"));
    tooltip(words);
    if (!ImGui::IsMouseClicked(0)) return;
    const auto bins = static_cast<double>(curves.front().picture->film.pixels.size());
    ui.commands.push_back(MovePoint{{state.at.segment, (std::floor(share * bins) + 0.5) / bins}});
}

}  // namespace halfdisk
