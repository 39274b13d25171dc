// How is a trade drawn? The front of all settings, and how their errors fall; for files and for the window.
#include "app/trade_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/pen.h"

namespace halfdisk {
namespace {

constexpr double kPercent = 100.0;

/// What its passes cost in all.
double spentOf(const TradeReport& report, std::size_t cell, TradeCost cost) {
    const TradeLaw& law = report.verdicts[cell].law;
    return law.preparation[at(cost)] + static_cast<double>(report.cells[cell].passes) * law.perPass[at(cost)];
}

double costOf(const TradeChoice& choice, TradeCost cost) {
    return cost == TradeCost::rays ? choice.rays : choice.seconds;
}

double costOf(const TradeOutcome& outcome, TradeCost cost) {
    return cost == TradeCost::rays ? outcome.rays : outcome.seconds;
}

PlotAxis costAxis(const TradeReport& report, TradeCost cost, const TradeMarks& marks) {
    PlotAxis axis{1.0, 10.0, true, cost == TradeCost::rays ? "rays" : "seconds"};
    bool any = false;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!report.cells[i].measured()) continue;
        const TradeLaw& law = report.verdicts[i].law;
        const double first = law.preparation[at(cost)] + law.perPass[at(cost)],
                     last = spentOf(report, i, cost);
        if (!(first > 0.0)) continue;
        axis.from = any ? std::min(axis.from, first) : first;
        axis.to = any ? std::max(axis.to, last) : last;
        any = true;
    }
    if (const double wished = marks.choice ? costOf(*marks.choice, cost) : 0.0; any && wished > 0.0) {
        axis.from = std::min(axis.from, wished);
        axis.to = std::max(axis.to, wished / 10.0);
    }
    axis.from = std::pow(10.0, std::floor(std::log10(axis.from)));
    // Beyond the budgets the laws are told too: a decade shows who wins with more patience.
    axis.to = std::max(std::pow(10.0, std::ceil(std::log10(axis.to)) + 1.0), 10.0 * axis.from);
    return axis;
}

PlotAxis errorAxis(const TradeReport& report, const TradeMarks& marks) {
    PlotAxis axis{kPercent * kMostTradeError, kPercent * kMostTradeError, true, "error, % of the light"};
    for (std::size_t i = 0; i < report.cells.size(); ++i)
        if (report.cells[i].measured() && report.verdicts[i].relativeError > 0.0)
            axis.from = std::min(axis.from, kPercent * report.verdicts[i].relativeError / 3.0);
    if (marks.choice && marks.choice->relativeError > 0.0)
        axis.from = std::min(axis.from, kPercent * marks.choice->relativeError / 1.5);
    axis.from =
        std::pow(10.0, std::floor(std::log10(std::clamp(axis.from, kPercent * kLeastTradeError, 10.0))));
    return axis;
}

bool isShown(const Plot& plot, ImVec2 place) {
    return plot.area.contains(place);
}

/// The law's curve over the costs that are shown.
std::vector<ImVec2> curveOf(const Plot& plot, const TradeLaw& law, TradeCost cost) {
    std::vector<ImVec2> points;
    const double first = law.preparation[at(cost)] + law.perPass[at(cost)];
    constexpr int kSteps = 120;
    const double from = std::max(first, plot.x.from);
    if (!(first > 0.0) || from >= plot.x.to) return points;
    for (int i = 0; i <= kSteps; ++i) {
        const double spent = from * std::pow(plot.x.to / from, static_cast<double>(i) / kSteps);
        if (const auto error = law.errorFor(std::max(spent, first), cost))
            points.push_back(plot.at(spent, kPercent * *error));
    }
    return points;
}

std::vector<ImVec2> frontCurve(const Plot& plot, const TradeReport& report, TradeCost cost) {
    std::vector<ImVec2> points;
    std::vector<double> errors = tradeErrors();
    for (auto error = errors.rbegin(); error != errors.rend(); ++error)
        if (const auto best = cheapest(report, *error, cost))
            points.push_back(plot.at(best->cost, kPercent * *error));
    return points;
}

void drawDots(const Ui& ui, const Plot& plot, const TradeReport& report, TradeCost cost,
              const TradeMarks& marks) {
    const Pen pen = penOf(ui);
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!report.cells[i].measured()) continue;
        const ImVec2 dot = tradeDot(plot, report, i, cost);
        if (!isShown(plot, dot)) continue;
        const ImU32 color = tradeColor(ui.palette, *report.cells[i].setting.estimator);
        if (report.verdicts[i].dominated[at(cost)]) {
            pen.AddCircle(dot, 4 * ui.scale, color, 0, 1.5f * ui.scale);
        } else {
            pen.AddCircleFilled(dot, 5 * ui.scale, color);
        }
        if (marks.choice && marks.choice->cell == i)
            pen.AddCircle(dot, 9 * ui.scale, ui.palette.ink, 0, 2.5f * ui.scale);
        const float half = 12 * ui.scale;
        if (marks.onStage == i)
            addRect(pen, {dot.x - half, dot.y - half}, {dot.x + half, dot.y + half}, ui.palette.accent, 0.0f,
                    2 * ui.scale);
    }
}

/// What is wished for, where that should be, and where it was when it was done.
void drawMarks(const Ui& ui, const Plot& plot, TradeCost cost, const TradeMarks& marks) {
    const Pen pen = penOf(ui);
    const float scale = ui.scale;
    const CanvasRect& area = plot.area;
    pen.PushClipRect(area.min, area.max, true);
    if (marks.wish && marks.wish->relativeError) {
        const float y = plot.at(plot.x.from, kPercent * *marks.wish->relativeError).y;
        pen.AddLine({area.min.x, y}, {area.max.x, y}, ui.palette.accent, 1.5f * scale);
    } else if (marks.wish && marks.wish->cost == cost) {
        const float x = plot.at(marks.wish->budget, plot.y.from).x;
        pen.AddLine({x, area.min.y}, {x, area.max.y}, ui.palette.accent, 1.5f * scale);
    }
    if (marks.choice) {
        const ImVec2 to = plot.at(costOf(*marks.choice, cost), kPercent * marks.choice->relativeError);
        const float arm = 7 * scale;
        pen.AddLine({to.x - arm, to.y - arm}, {to.x + arm, to.y + arm}, ui.palette.accent, 2.5f * scale);
        pen.AddLine({to.x - arm, to.y + arm}, {to.x + arm, to.y - arm}, ui.palette.accent, 2.5f * scale);
    }
    if (marks.outcome) {
        const double spent = costOf(*marks.outcome, cost);
        const Uncertain error = marks.outcome->relativeError;
        const ImVec2 dot = plot.at(spent, kPercent * error.value);
        pen.AddLine(plot.at(spent, kPercent * std::max(error.value - error.error, 1e-9)),
                    plot.at(spent, kPercent * (error.value + error.error)), ui.palette.error, 2.5f * scale);
        pen.AddCircleFilled(dot, 4.5f * scale, ui.palette.error);
    }
    pen.PopClipRect();
}

/// RMSE as a share of the light, in percent, and its standard error.
Uncertain percentOf(const TradeLevel& level, double light) {
    const double root = std::sqrt(level.mse.value);
    return {kPercent * root / light, kPercent * 0.5 * level.mse.error / (root * light)};
}

void drawLevels(const Ui& ui, const Plot& plot, const TradeReport& report, const TradeCell& cell) {
    const Pen pen = penOf(ui);
    const ImU32 color = tradeColor(ui.palette, *cell.setting.estimator);
    std::vector<ImVec2> points;
    for (const TradeLevel& level : cell.levels) {
        if (!(level.mse.value > 0.0)) continue;
        const Uncertain error = percentOf(level, report.truth.light);
        const double rays = level.passes * cell.raysPerPass();
        const ImVec2 dot = plot.at(rays, error.value);
        points.push_back(dot);
        if (!isShown(plot, dot)) continue;
        pen.PushClipRect(plot.area.min, plot.area.max, true);
        pen.AddLine(plot.at(rays, std::max(error.value - error.error, 1e-9)),
                    plot.at(rays, error.value + error.error), color, 2 * ui.scale);
        pen.PopClipRect();
        pen.AddCircleFilled(dot, 4 * ui.scale, color);
    }
    plotLine(ui, plot, points, color, 2 * ui.scale);
}

PlotAxis levelAxis(const TradeReport& report, const std::vector<std::size_t>& cells) {
    PlotAxis axis{1.0, 10.0, true, "rays of one picture"};
    bool any = false;
    for (const std::size_t i : cells)
        for (const TradeLevel& level : report.cells[i].levels) {
            const double rays = level.passes * report.cells[i].raysPerPass();
            if (!(rays > 0.0)) continue;
            axis.from = any ? std::min(axis.from, rays) : rays;
            axis.to = any ? std::max(axis.to, rays) : rays;
            any = true;
        }
    axis.from = std::pow(10.0, std::floor(std::log10(axis.from)));
    axis.to = std::max(std::pow(10.0, std::ceil(std::log10(axis.to))), 10.0 * axis.from);
    return axis;
}

PlotAxis levelErrors(const TradeReport& report, const std::vector<std::size_t>& cells) {
    PlotAxis axis{1.0, 10.0, true, "error, % of the light"};
    bool any = false;
    for (const std::size_t i : cells)
        for (const TradeLevel& level : report.cells[i].levels) {
            if (!(level.mse.value > 0.0)) continue;
            const double error = percentOf(level, report.truth.light).value;
            axis.from = any ? std::min(axis.from, error) : error;
            axis.to = any ? std::max(axis.to, error) : error;
            any = true;
        }
    axis.from = std::pow(10.0, std::floor(std::log10(axis.from / 2.0)));  // room for the key
    axis.to = std::max(std::pow(10.0, std::ceil(std::log10(axis.to))), 10.0 * axis.from);
    return axis;
}

/// The key in the lower left corner, where no error is.
void drawKeyBelow(const Ui& ui, const Plot& plot, const std::vector<std::pair<ImU32, std::string>>& entries) {
    const Pen pen = penOf(ui);
    const float line = ImGui::GetFontSize(), gap = 4 * ui.scale, stroke = 16 * ui.scale;
    float y = plot.area.max.y - gap - static_cast<float>(entries.size()) * line;
    for (const auto& entry : entries) {
        const ImVec2 from{plot.area.min.x + 2 * gap, y};
        const ImVec2 words{from.x + stroke + gap, y};
        pen.AddRectFilled(from, {words.x + textSize(entry.second).x + gap, y + line},
                          withOpacity(ui.palette.panel, 0.85f));
        pen.AddLine({from.x, y + line / 2}, {from.x + stroke, y + line / 2}, entry.first, 3 * ui.scale);
        drawText(ui, words, ui.palette.ink, entry.second);
        y += line;
    }
}

}  // namespace

ImVec2 tradeDot(const Plot& plot, const TradeReport& report, std::size_t cell, TradeCost cost) {
    return plot.at(spentOf(report, cell, cost), kPercent * report.verdicts[cell].relativeError);
}

ImU32 tradeColor(const Palette& palette, const EstimatorInfo& info) {
    const std::array colors{palette.point,   palette.sample,           palette.light, palette.normal,
                            palette.rayDark, palette.shadowRayBlocked, palette.ink,   palette.halfDisk};
    const auto all = estimators();
    const auto place = static_cast<std::size_t>(std::find(all.begin(), all.end(), &info) - all.begin());
    return colors[place % colors.size()];
}

Plot drawTradeFront(const Ui& ui, const TradeReport& report, TradeCost cost, ImVec2 size,
                    const TradeMarks& marks) {
    std::vector<PlotKey> keys;
    for (const TradeCell& cell : report.cells) {
        const EstimatorInfo& info = *cell.setting.estimator;
        if (cell.measured() && (keys.empty() || keys.back().name != info.id))
            keys.push_back({tradeColor(ui.palette, info), std::string(info.id)});
    }
    keys.push_back({ui.palette.currentLine, std::string(tr("the cheapest"))});
    if (marks.choice) keys.push_back({ui.palette.accent, std::string(tr("wished"))});
    if (marks.outcome) keys.push_back({ui.palette.error, std::string(tr("measured"))});
    const Plot plot = beginPlot(ui, "front", std::string(tr("What accuracy costs here")), size,
                                costAxis(report, cost, marks), errorAxis(report, marks), keys);
    plotLine(ui, plot, frontCurve(plot, report, cost), ui.palette.currentLine, 12 * ui.scale);
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        const TradeCell& cell = report.cells[i];
        if (!cell.measured()) continue;
        const ImU32 color = tradeColor(ui.palette, *cell.setting.estimator);
        const bool bold = marks.choice ? marks.choice->cell == i : !report.verdicts[i].dominated[at(cost)];
        plotLine(ui, plot, curveOf(plot, report.verdicts[i].law, cost),
                 bold ? color : withOpacity(color, 0.35f), (bold ? 2.5f : 1.0f) * ui.scale);
    }
    drawDots(ui, plot, report, cost, marks);
    drawMarks(ui, plot, cost, marks);
    return plot;
}

std::optional<std::size_t> tradeCellAt(const Plot& plot, const TradeReport& report, TradeCost cost,
                                       ImVec2 place, float reach) {
    std::optional<std::size_t> nearest;
    float best = reach * reach;
    for (std::size_t i = 0; i < report.cells.size(); ++i) {
        if (!report.cells[i].measured()) continue;
        const ImVec2 dot = tradeDot(plot, report, i, cost);
        const float dx = dot.x - place.x, dy = dot.y - place.y, away = dx * dx + dy * dy;
        if (!isShown(plot, dot) || away > best) continue;
        best = away;
        nearest = i;
    }
    return nearest;
}

std::vector<std::size_t> bestCells(const TradeReport& report) {
    std::vector<std::size_t> cells;
    for (const EstimatorInfo* info : estimators()) {
        if (const auto best = cheapest(report, report.target, TradeCost::rays, info)) {
            cells.push_back(best->cell);
            continue;
        }
        std::optional<std::size_t> least;
        for (std::size_t i = 0; i < report.cells.size(); ++i)
            if (report.cells[i].measured() && report.cells[i].setting.estimator == info &&
                (!least || report.verdicts[i].relativeError < report.verdicts[*least].relativeError))
                least = i;
        if (least) cells.push_back(*least);
    }
    return cells;
}

Plot drawConvergence(const Ui& ui, const TradeReport& report, ImVec2 size) {
    const std::vector<std::size_t> cells = bestCells(report);
    const Plot plot = beginPlot(ui, "convergence", "How the error falls", size, levelAxis(report, cells),
                                levelErrors(report, cells));
    std::vector<std::pair<ImU32, std::string>> key;
    for (const std::size_t i : cells) {
        const TradeCell& cell = report.cells[i];
        if (cell.levels.empty()) continue;
        drawLevels(ui, plot, report, cell);
        const std::string power = cell.exponent ? fmt::format(": power {:.2f} \u00b1 {:.2f}",
                                                              cell.exponent->value, cell.exponent->error)
                                                : "";
        key.emplace_back(tradeColor(ui.palette, *cell.setting.estimator),
                         fmt::format("{}{}", cell.name, power));
    }
    drawKeyBelow(ui, plot, key);
    return plot;
}

}  // namespace halfdisk
