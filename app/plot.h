// How does a plot get its axes? A frame, ticks with numbers, a title and units; the curves are drawn by those
// who know them.
#pragma once

#include <string>
#include <vector>

#include "app/camera.h"
#include "app/frame.h"

namespace halfdisk {

struct PlotAxis {
    double from = 0.0, to = 1.0;  ///< from < to; both > 0 on a logarithmic axis
    bool logarithmic = false;
    std::string label;  ///< with its unit
    double step = 0.0;  ///< between ticks; 0: chosen
};

/// Where a tick stands and what it says.
struct Tick {
    double value;
    std::string label;
};
std::vector<Tick> ticksOf(const PlotAxis& axis, int about);

struct Plot {
    CanvasRect area;  ///< inside the axes, pixels
    PlotAxis x, y;

    ImVec2 at(double xValue, double yValue) const;
    double xAt(float pixel) const;  ///< back from the screen
    bool hovered() const;
};

/// Which curve is which: a stroke in its colour, and its name.
struct PlotKey {
    ImU32 color;
    std::string name;
};

/// Reserves `size` in the current window and draws everything but the curves. The keys stand above the frame,
/// so that they cover none of them.
Plot beginPlot(const Ui& ui, const char* name, const std::string& title, ImVec2 size, const PlotAxis& x,
               const PlotAxis& y, const std::vector<PlotKey>& keys = {});

/// A line of `points` (pixels) clipped to the plot.
void plotLine(const Ui& ui, const Plot& plot, const std::vector<ImVec2>& points, ImU32 color,
              float thickness);

}  // namespace halfdisk
