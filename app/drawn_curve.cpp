#include "app/drawn_curve.h"

#include <algorithm>

#include "app/draw_text.h"
#include "app/goal_check.h"

namespace halfdisk {
namespace {

/// From the plot's degrees from the normal, positive to the right, to theta from the tangent.
double thetaAt(const Plot& plot, float x) {
    return std::clamp((90.0 - plot.xAt(x)) / 180.0, 0.0, 1.0) * kPi;
}

double valueAt(const Plot& plot, float y) {
    const double share = (plot.area.max.y - y) / plot.area.height();
    return plot.y.from + std::clamp(share, 0.0, 1.0) * (plot.y.to - plot.y.from);
}

void takeStroke(const Ui& ui, const Plot& plot) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool down = ImGui::IsMouseDown(0);
    if (!down && ui.state.drawing) ui.commands.push_back(EndStroke{});
    if (!down || (!ui.state.drawing && !plot.hovered())) return;
    const ImVec2 to = io.MousePos;
    const ImVec2 from = ui.state.drawing ? ImVec2{to.x - io.MouseDelta.x, to.y - io.MouseDelta.y} : to;
    ui.commands.push_back(
        DrawCurve{thetaAt(plot, from.x), thetaAt(plot, to.x), valueAt(plot, from.y), valueAt(plot, to.y)});
}

}  // namespace

bool drawnCurve(const Ui& ui, const Plot& plot) {
    const AppState& state = ui.state;
    if (!asksForCurve(state)) return false;
    takeStroke(ui, plot);
    std::vector<ImVec2> stroke;
    for (std::size_t bin = 0; bin <= state.drawn.size(); ++bin) {
        const bool there = bin < state.drawn.size() && state.drawn[bin] >= 0.0f;
        if (there) {
            const double theta = kPi * (static_cast<double>(bin) + 0.5) / kDrawnBins;
            stroke.push_back(plot.at(90.0 - theta * 180.0 / kPi, state.drawn[bin]));
            continue;
        }
        plotLine(ui, plot, stroke, ui.palette.normal, 3 * ui.scale);
        stroke.clear();
    }
    if (isDrawn(state)) return false;
    if (state.drawn.empty())
        drawText(ui, {(plot.area.min.x + plot.area.max.x) / 2, (plot.area.min.y + plot.area.max.y) / 2},
                 ui.palette.inkSoft, "draw L(\u03b8) here", Align::middle);
    return true;
}

}  // namespace halfdisk
