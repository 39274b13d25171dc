#include "app/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/pen.h"

namespace halfdisk {
namespace {

double fractionOf(const PlotAxis& axis, double value) {
    if (!axis.logarithmic) return (value - axis.from) / (axis.to - axis.from);
    return std::log(std::max(value, 1e-300) / axis.from) / std::log(axis.to / axis.from);
}

/// The smallest of 1, 2, 5 times a power of ten that is at least x.
double niceStep(double x) {
    const double power = std::pow(10.0, std::floor(std::log10(x)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= x * (1 - 1e-9)) return factor * power;
    return 10.0 * power;
}

std::vector<Tick> linearTicks(const PlotAxis& axis, int about) {
    const double step = axis.step > 0.0 ? axis.step : niceStep((axis.to - axis.from) / std::max(1, about));
    std::vector<Tick> ticks;
    const double first = std::ceil(axis.from / step - 1e-9);
    constexpr int kMostTicks = 40;
    for (int i = 0; i < kMostTicks; ++i) {
        const double value = (first + i) * step;
        if (value > axis.to + 1e-9 * step) break;
        ticks.push_back({value, value == 0.0 ? "0" : local(fmt::format("{:.6g}", value))});
    }
    return ticks;
}

std::vector<Tick> logarithmicTicks(const PlotAxis& axis, int about) {
    const int low = static_cast<int>(std::ceil(std::log10(axis.from) - 1e-9));
    const int high = static_cast<int>(std::floor(std::log10(axis.to) + 1e-9));
    const int every = 1 + (high - low) / std::max(1, about + 1);
    std::vector<Tick> ticks;
    for (int power = low; power <= high; power += every) {
        const double value = std::pow(10.0, power);
        ticks.push_back({value, local(fmt::format("{:g}", value))});
    }
    return ticks;
}

/// Whether a plot is what the term that is looked up is about.
bool speaksOf(std::string_view plot, Topic topic) {
    if (plot == "integrand")
        return topic == Topic::radiance || topic == Topic::irradiance || topic == Topic::sample;
    if (plot == "profile") return topic == Topic::irradiance;
    return topic == Topic::error && (plot == "error" || plot == "histogram");
}

/// Right aligned, in as many rows as they need, from `top` on; the first row leaves room on its left.
class KeyRows {
 public:
    KeyRows(const Ui& ui, const std::vector<PlotKey>& keys, float width, float leftOfFirst)
        : ui_(ui), gap_(4 * ui.scale), stroke_(16 * ui.scale) {
        for (const PlotKey& key : keys) {
            const std::string words = firstThatFits({key.name}, width - stroke_ - gap_);
            const float needed = textSize(words).x + stroke_ + gap_;
            const auto between = [&] { return rows_.back().keys.empty() ? 0.0f : 3 * gap_; };
            const float room = width - (rows_.size() == 1 ? leftOfFirst : 0.0f);
            if (rows_.back().width + between() + needed > room) rows_.emplace_back();
            Row& row = rows_.back();
            row.width += between() + needed;
            row.keys.push_back({key.color, words});
        }
    }
    /// Below the first one, which stands beside other words.
    std::size_t further() const { return rows_.size() - 1; }

    void draw(float right, float top) const {
        const Pen list = penOf(ui_);
        const float line = ImGui::GetFontSize();
        for (const Row& row : rows_) {
            float x = right - row.width;
            for (const PlotKey& key : row.keys) {
                list.AddLine({x, top + line / 2}, {x + stroke_, top + line / 2}, key.color, 3 * ui_.scale);
                x += stroke_ + gap_;
                x += drawText(ui_, {x, top}, ui_.palette.ink, key.name).x + 3 * gap_;
            }
            top += line;
        }
    }

 private:
    struct Row {
        std::vector<PlotKey> keys;
        float width = 0.0f;
    };
    const Ui& ui_;
    float gap_, stroke_;
    std::vector<Row> rows_{1};
};

}  // namespace

std::vector<Tick> ticksOf(const PlotAxis& axis, int about) {
    return axis.logarithmic ? logarithmicTicks(axis, about) : linearTicks(axis, about);
}

ImVec2 Plot::at(double xValue, double yValue) const {
    const double u = std::clamp(fractionOf(x, xValue), -10.0, 10.0),
                 v = std::clamp(fractionOf(y, yValue), -10.0, 10.0);
    return {area.min.x + static_cast<float>(u) * area.width(),
            area.max.y - static_cast<float>(v) * area.height()};
}

double Plot::xAt(float pixel) const {
    const double u = (pixel - area.min.x) / area.width();
    return x.logarithmic ? x.from * std::pow(x.to / x.from, u) : x.from + u * (x.to - x.from);
}

bool Plot::hovered() const {
    return ImGui::IsWindowHovered() && area.contains(ImGui::GetIO().MousePos);
}

Plot beginPlot(const Ui& ui, const char* name, const std::string& title, ImVec2 size, const PlotAxis& x,
               const PlotAxis& y, const std::vector<PlotKey>& keys) {
    const Palette& palette = ui.palette;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    mark(ui.widgets, name, origin, {origin.x + size.x, origin.y + size.y});
    const Pen list = penOf(ui);
    const float line = ImGui::GetFontSize(), gap = 4 * ui.scale;

    Plot plot;
    plot.x = x;
    plot.y = y;
    const float titleHeight = drawText(ui, origin, palette.ink, title, Align::left, ui.fonts.strong).y;
    const KeyRows rowsOfKeys(ui, keys, size.x - 3 * gap, textSize(y.label).x + 4 * gap);
    const float top = origin.y + titleHeight + line * static_cast<float>(1 + rowsOfKeys.further()) + 2 * gap,
                bottom = origin.y + size.y - (x.label.empty() ? 1.2f : 2.4f) * line - 2 * gap;
    const int rows = std::max(2, static_cast<int>((bottom - top) / (2.2f * line)));
    const std::vector<Tick> yTicks = ticksOf(y, rows);
    float widest = 0.0f;
    for (const Tick& tick : yTicks) widest = std::max(widest, textSize(tick.label).x);
    plot.area = {{origin.x + widest + 3 * gap, top}, {origin.x + size.x - 3 * gap, bottom}};

    drawText(ui, {origin.x, origin.y + titleHeight + gap / 2}, palette.inkSoft, y.label);
    rowsOfKeys.draw(plot.area.max.x, origin.y + titleHeight + gap / 2);
    list.AddRectFilled(plot.area.min, plot.area.max, palette.panel);
    float lastMiddle = -1e9f;
    for (const Tick& tick : yTicks) {
        const ImVec2 p = plot.at(x.from, tick.value);
        list.AddLine(p, {plot.area.max.x, p.y}, palette.grid, 1.0f);
        if (std::abs(p.y - lastMiddle) < line) continue;
        lastMiddle = p.y;
        drawText(ui, {p.x - gap, p.y - line / 2}, palette.inkSoft, tick.label, Align::right);
    }
    float lastRight = -1e9f;
    for (const Tick& tick : ticksOf(x, std::max(2, static_cast<int>(plot.area.width() / (3.0f * line))))) {
        const ImVec2 p = plot.at(tick.value, y.from);
        list.AddLine({p.x, plot.area.min.y}, {p.x, plot.area.max.y}, palette.grid, 1.0f);
        const float half = textSize(tick.label).x / 2;
        if (p.x - half < lastRight + gap || p.x + half > origin.x + size.x) continue;
        lastRight = p.x + half;
        drawText(ui, {p.x, plot.area.max.y + 0.55f * line}, palette.inkSoft, tick.label, Align::middle);
    }
    addRect(list, plot.area.min, plot.area.max, palette.inkSoft, 0.0f, 1.0f);
    if (speaksOf(name, ui.state.topic))
        addRect(list, plot.area.min, plot.area.max, palette.accent, 0.0f, 3 * ui.scale);
    drawText(ui, {(plot.area.min.x + plot.area.max.x) / 2, plot.area.max.y + gap + 1.4f * line},
             palette.inkSoft, x.label, Align::middle);
    return plot;
}

void plotLine(const Ui& ui, const Plot& plot, const std::vector<ImVec2>& points, ImU32 color,
              float thickness) {
    if (points.size() < 2) return;
    const Pen list = penOf(ui);
    list.PushClipRect(plot.area.min, plot.area.max, true);
    addPolyline(list, points, color, false, thickness);
    list.PopClipRect();
}

}  // namespace halfdisk
