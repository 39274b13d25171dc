// The three plots: light over the half-disk, error against N, and the histogram of contributions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/drawn_curve.h"
#include "app/goal_check.h"
#include "app/histogram.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/plot.h"
#include "app/plot_words.h"

namespace halfdisk {
namespace {

constexpr double kDegrees = 180.0 / kPi;

/// Degrees from the normal, positive to the right: what the axis shows for theta from the tangent.
double fromNormal(double theta) {
    return 90.0 - theta * kDegrees;
}

void emptyPlot(const Ui& ui, const char* name, const std::string& title, ImVec2 size, const char* why) {
    const Plot plot = beginPlot(ui, name, title, size, {}, {});
    drawText(ui, {(plot.area.min.x + plot.area.max.x) / 2, (plot.area.min.y + plot.area.max.y) / 2},
             ui.palette.inkSoft, why, Align::middle);
}

/// Why there is nothing exact about P.
const char* whyNotExact(const AppState& state) {
    if (!state.answer || !state.answer->pointComplete) return "being computed";
    if (state.answer->tooManyRays) return "too many rays";
    return state.scene->visibility ? "no exact value at this depth" : "exact for diffuse rooms only";
}

/// Events of depth 0 that the playback has passed.
template <class Function>
void forPassedEvents(const AppState& state, EventKind kind, const Function& f) {
    if (!state.answer || !state.answer->record || state.answer->pathRun) return;
    const auto& events = state.answer->record->events;
    const std::size_t end =
        state.playback.stepping ? std::min(state.playback.event, events.size()) : events.size();
    for (const std::uint32_t i : state.answer->summary.atP)
        if (i < end && events[i].kind == kind) f(events[i]);
}

}  // namespace

void integrandPlot(const Ui& ui, ImVec2 size) {
    const OnSheet drawing(ui, "integrand", size);
    const std::string title = drawingTitle(ui.state, "integrand");
    const AppState& state = ui.state;
    if (!state.answer || state.answer->integrand.empty())
        return emptyPlot(ui, "integrand", title, size, whyNotExact(state));
    const LightAnswer& answer = *state.answer;
    double top = 0.0;
    for (const IntegrandPoint& p : answer.integrand) top = std::max(top, gray(p.radiance));
    if (top <= 0.0) top = 1.0;
    std::vector<PlotKey> keys{{ui.palette.exact, "L(\u03b8)"}, {ui.palette.point, "L(\u03b8) cos\u03b8"}};
    if (asksForCurve(state)) keys.push_back({ui.palette.normal, "expected"});
    if (asksForCurve(state) && !isDrawn(state)) keys.clear();
    const Plot plot = beginPlot(ui, "integrand", title, size,
                                {-90.0, 90.0, false, "\u03b8 from the normal (degrees)", 30.0},
                                {0.0, 1.5 * top, false, "W/(m rad)", 0.0}, keys);

    if (drawnCurve(ui, plot)) return;
    std::vector<ImVec2> radiance, weighted;
    for (const IntegrandPoint& p : answer.integrand) {
        const double L = gray(p.radiance);
        radiance.push_back(plot.at(fromNormal(p.theta), L));
        weighted.push_back(plot.at(fromNormal(p.theta), L * std::sin(p.theta)));
    }
    const Pen list = penOf(ui);
    list.areaBelow(weighted, plot.area.max.y, withOpacity(ui.palette.light, 0.35f));
    plotLine(ui, plot, radiance, ui.palette.exact, 2 * ui.scale);
    plotLine(ui, plot, weighted, ui.palette.point, 2 * ui.scale);
    if (state.shows(View::rays))
        forPassedEvents(state, EventKind::sample, [&](const Event& event) {
            const float x = plot.at(fromNormal(event.theta), 0.0).x;
            list.AddLine({x, plot.area.max.y}, {x, plot.area.max.y - 8 * ui.scale}, ui.palette.sample,
                         2 * ui.scale);
        });
    if (plot.hovered()) {
        const double angle = plot.xAt(ImGui::GetIO().MousePos.x);
        const auto index = static_cast<std::size_t>(std::clamp((90.0 - angle) / 180.0, 0.0, 0.999999) *
                                                    static_cast<double>(answer.integrand.size()));
        const IntegrandPoint& p = answer.integrand[index];
        tooltip(say("\u03b8 = {:.0f}\u00b0\nL = {} W/(m rad)\nL cos\u03b8 = {}", angle, shown(p.radiance),
                    shown(p.radiance * std::sin(p.theta))));
    }
}

void errorPlot(const Ui& ui, ImVec2 size) {
    const OnSheet drawing(ui, "error", size);
    const std::string title = drawingTitle(ui.state, "error");
    const AppState& state = ui.state;
    if (!state.answer || state.answer->errors.size() < 2)
        return emptyPlot(ui, "error", title, size,
                         !state.answer || !state.answer->pointComplete ? "being measured" : "no exact value");
    const LightAnswer& answer = *state.answer;
    double low = 1e300, high = 0.0;
    for (const ErrorPoint& p : answer.errors) {
        if (p.rms <= 0.0) continue;
        low = std::min(low, p.rms);
        high = std::max(high, p.rms);
    }
    if (high <= 0.0) return emptyPlot(ui, "error", title, size, "no error: every sample brings the same");
    const double mostN = answer.errors.back().samples;
    const Plot plot =
        beginPlot(ui, "error", title, size, {0.8, 1.25 * mostN, true, "N, samples per bounce", 0.0},
                  {std::pow(10.0, std::floor(std::log10(low * 0.7))),
                   std::pow(10.0, std::ceil(std::log10(high * 1.2))), true, "rms error of E, W/m", 0.0},
                  {{ui.palette.estimate, "48 runs each"}, {ui.palette.inkSoft, "1/\u221aN"}});
    const Pen list = penOf(ui);
    // Independent samples lie along it: in the middle of the dots, for the first ones may have met no lamp at
    // all. Stratified ones fall below the line on which they begin.
    std::vector<double> ofOnes;
    for (const ErrorPoint& p : answer.errors) ofOnes.push_back(p.rms * std::sqrt(p.samples));
    std::sort(ofOnes.begin(), ofOnes.end());
    const bool independent = answer.asked.settings.sampler != Sampler::stratified;
    const double ofOne = independent ? ofOnes[ofOnes.size() / 2] : ofOnes.back();
    plotLine(ui, plot, {plot.at(1.0, ofOne), plot.at(1.25 * mostN, ofOne / std::sqrt(1.25 * mostN))},
             ui.palette.inkSoft, 1.5f * ui.scale);
    list.PushClipRect(plot.area.min, plot.area.max, true);
    for (const ErrorPoint& p : answer.errors) {
        if (p.rms <= 0.0) continue;
        const ImVec2 at = plot.at(p.samples, p.rms);
        list.AddLine(plot.at(p.samples, std::max(p.rms - p.spread, p.rms / 10)),
                     plot.at(p.samples, p.rms + p.spread), ui.palette.estimate, 1.5f * ui.scale);
        list.AddCircleFilled(at, 3.5f * ui.scale, ui.palette.estimate);
    }
    list.PopClipRect();
    const double N = state.settings.samples;
    if (N <= 1.25 * mostN) {
        const float x = plot.at(N, plot.y.from).x;
        list.AddLine({x, plot.area.min.y}, {x, plot.area.max.y}, withOpacity(ui.palette.accent, 0.5f),
                     1.5f * ui.scale);
    }
    if (plot.hovered()) {
        const double at = plot.xAt(ImGui::GetIO().MousePos.x);
        const auto nearest =
            std::min_element(answer.errors.begin(), answer.errors.end(), [&](const auto& a, const auto& b) {
                return std::abs(std::log(a.samples / at)) < std::abs(std::log(b.samples / at));
            });
        tooltip(say("N = {:.0f}: rms error {} \u00b1 {}", nearest->samples, shown(nearest->rms),
                    shown(nearest->spread)));
    }
}

void histogramPlot(const Ui& ui, ImVec2 size) {
    const OnSheet drawing(ui, "histogram", size);
    const std::string title = drawingTitle(ui.state, "histogram");
    const AppState& state = ui.state;
    if (!state.answer || state.answer->histogramOf.empty())
        return emptyPlot(ui, "histogram", title, size,
                         state.answer && state.answer->tooManyRays ? "too many rays" : "being computed");
    const Histogram histogram = histogramOf(state.answer->histogramOf);
    const double low = histogram.low, high = histogram.high, counted = histogram.counted;
    const double tallest = *std::max_element(histogram.counts.begin(), histogram.counts.end()) / counted;
    const Plot plot =
        beginPlot(ui, "histogram", title, size, {low, high, false, "contribution to E, W/m", 0.0},
                  {0.0, std::min(1.0, 1.15 * tallest) * 100.0, false, "% of samples", 0.0},
                  {{ui.palette.estimate, "their mean"}, {ui.palette.sample, "this run"}});
    const Pen list = penOf(ui);
    for (std::size_t i = 0; i < Histogram::kBins; ++i) {
        const ImVec2 a = plot.at(histogram.edge(i), 0.0);
        const ImVec2 b = plot.at(histogram.edge(i + 1), 100.0 * histogram.counts[i] / counted);
        if (histogram.counts[i] > 0)
            list.AddRectFilled({a.x, b.y}, {b.x - ui.scale, a.y}, withOpacity(ui.palette.halfDisk, 0.9f));
    }
    forPassedEvents(state, EventKind::accumulate, [&](const Event& event) {
        const float x = plot.at(gray(event.value), 0.0).x;
        list.AddLine({x, plot.area.max.y}, {x, plot.area.max.y - 8 * ui.scale}, ui.palette.sample,
                     2 * ui.scale);
    });
    const float x = plot.at(histogram.mean, 0.0).x;
    list.AddLine({x, plot.area.min.y}, {x, plot.area.max.y}, ui.palette.estimate, 2 * ui.scale);
    if (state.shows(View::samples) && plot.hovered()) {
        const std::size_t bin = histogram.binOf(plot.xAt(ImGui::GetIO().MousePos.x));
        tooltip("click: the samples of this bar in the list");
        if (ImGui::IsMouseClicked(0))
            ui.commands.push_back(FilterSamples{std::pair(histogram.edge(bin), histogram.edge(bin + 1))});
    }
}

}  // namespace halfdisk
