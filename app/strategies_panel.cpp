// Which strategy (s, t) finds which light? All of them in one picture: a row for each length of path, a small
// strip for each strategy (Veach 1997, figure 10.3), with its share of the light.
#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/panels.h"
#include "app/pen.h"
#include "app/plot_words.h"

namespace halfdisk {
namespace {

constexpr const char* kAlone = "each by itself";

std::string percent(double share) {
    const double number = 100.0 * share;
    return fmt::format("{:.{}f} %", number, number > 0.0 && number < 9.95 ? 1 : 0);
}

/// Of what has found light, as short as it can be read from far away.
std::string wholePercent(double share) {
    return share < 0.005 ? "<1%" : fmt::format("{:.0f}%", 100.0 * share);
}

const char* unitOf(const StrategyGrid& grid) {
    return grid.ofEye() ? "W/(m rad)" : "W/m";
}

/// Where a strategy's share stands as a number.
enum class NumberAt : std::uint8_t { below, beside, nowhere };

/// Where the cells stand (pixels).
struct Cells {
    ImVec2 origin;     ///< left upper corner of the one for s = 0, of the shortest paths
    float width, row;  ///< from one to the next
    float gap;
    NumberAt number;
    float widestNumber;
    bool brief;  ///< "1, 2" instead of "s=1 t=2"

    ImVec2 at(Strategy strategy) const {
        return {std::round(origin.x + static_cast<float>(strategy.s) * width),
                std::round(origin.y + static_cast<float>(strategy.vertices() - 2) * row)};
    }
    float inner() const { return std::round(width - 2 * gap); }
};

/// The maker that shows this strategy on its own; already shown: all of them again.
Maker makerShowing(const AppState& state, Strategy strategy, bool chosen) {
    const bool has = state.makers.first && state.makers.first->estimator == "bidirectional";
    Maker maker = has ? *state.makers.first : makerOf("bidirectional");
    const EstimatorInfo& info = *findEstimator(maker.estimator);
    const auto set = [&](std::string_view name, double value) {
        for (std::size_t i = 0; i < info.params.size(); ++i)
            if (info.params[i].name == name) maker.params[i] = value;
    };
    set("s", chosen ? -1.0 : strategy.s);
    set("t", chosen ? -1.0 : strategy.t);
    set("weights", chosen || !state.strategiesAlone ? 1.0 : 0.0);
    return maker;
}

/// Whether the pictures' maker is this strategy.
bool isChosen(const AppState& state, Strategy strategy) {
    const auto& maker = state.makers.first;
    return maker && maker->estimator == "bidirectional" && maker->params[0] == strategy.s &&
           maker->params[1] == strategy.t;
}

/// Whether a click may make the pictures another way. A field is not made by both ends.
bool mayChoose(const AppState& state) {
    const bool has = state.makers.first && state.makers.first->estimator == "bidirectional";
    return state.isUnlocked(Control::params) && (has || state.isUnlocked(Control::estimator)) &&
           !state.shows(View::field);
}

std::string_view howOf(Strategy strategy) {
    if (strategy.s == 0) return "the sensor's path meets a light by luck";
    if (strategy.t == 0) return "the light's path meets the sensor by itself";
    if (strategy.s == 1) return "the last wall of the sensor's path asks a light";
    if (strategy.t == 1) return "the last wall of the light's path is joined to the sensor";
    return "the last walls of both paths are joined";
}

std::string tooltipOf(const AppState& state, const StrategyGrid& grid, std::size_t place,
                      std::uint32_t pixel) {
    const Strategy strategy = grid.film.table[place];
    const char* unit = unitOf(grid);
    const auto line = [&](std::string_view what, bool alone) {
        const Statistics mean = grid.means(alone)[place];
        return fmt::format("\n{}: {} \u00b1 {} {}, {}", tr(what), shown(mean.mean),
                           local(fmt::format("{:.1g}", gray(mean.standardError()))), unit,
                           percent(grid.share(place, alone)));
    };
    std::string words = fmt::format("s = {}, t = {}: {}", strategy.s, strategy.t, tr(howOf(strategy)));
    if (grid.film.aloneMeans.mean[place] == Rgb(0.0)) {
        words += '\n';
        words += tr("it has found no light");
        return words;
    }
    words += line("weighted", false) + line(kAlone, true);
    const PixelStatistics& pixels = state.strategiesAlone ? grid.film.alone : grid.film.weighted;
    const Statistics here = pixels[place * grid.film.pixels() + pixel];
    words += say("\nhere: {} \u00b1 {:.1g} {}", shown(here.mean), gray(here.standardError()), unit);
    if (mayChoose(state)) {
        words += '\n';
        words += tr(isChosen(state, strategy) ? "click: all strategies again"
                                              : "click: this strategy makes the pictures");
    }
    return words;
}

void drawStrip(const Ui& ui, const StrategyGrid& grid, std::size_t place, ImVec2 min, ImVec2 max) {
    const Pen list = penOf(ui);
    const std::size_t count = grid.film.pixels();
    const auto& all = grid.colors(ui.state.strategiesAlone);
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(place * count);
    const std::vector<std::uint32_t> colors(from, from + static_cast<std::ptrdiff_t>(count));
    if (list.drawing) list.drawing->cells(min, max, colors, static_cast<std::uint32_t>(count), 1.0f);
    const auto edge = [&](std::size_t pixel) {
        return std::round(min.x + (max.x - min.x) * static_cast<float>(pixel) / static_cast<float>(count));
    };
    for (std::size_t i = 0; i < count; ++i)
        list.screen.AddRectFilled({edge(i), min.y}, {edge(i + 1), max.y}, colors[i]);
}

std::string labelOf(Strategy strategy, bool brief) {
    return brief ? fmt::format("{}, {}", strategy.s, strategy.t)
                 : fmt::format("s={} t={}", strategy.s, strategy.t);
}

float heightBelow(const Ui& ui, const Cells& cells) {
    return cells.number == NumberAt::below ? ImGui::GetFontSize() : std::round(4 * ui.scale);
}

/// A bar and a number, below the strip of a cell from `min` to `max`.
void drawShare(const Ui& ui, const Cells& cells, float share, ImVec2 min, ImVec2 max) {
    const float least = 20 * ui.scale, line = ImGui::GetFontSize();
    float left = min.x, right = max.x, top = max.y - heightBelow(ui, cells), bottom = max.y;
    if (cells.number != NumberAt::nowhere)
        drawText(ui, {max.x, cells.number == NumberAt::below ? top : min.y}, ui.palette.estimate,
                 wholePercent(share), Align::right);
    if (cells.number == NumberAt::below) {
        right -= cells.widestNumber + 4 * ui.scale;
        top = std::round(top + 0.3f * line);
        bottom = std::round(bottom - 0.25f * line);
    }
    if (right - left < least) return;  // the number says it
    const Pen list = penOf(ui);
    list.AddRectFilled({left, top}, {right, bottom}, ui.palette.grid);
    list.AddRectFilled({left, top}, {left + std::clamp(share, 0.0f, 1.0f) * (right - left), bottom},
                       ui.palette.estimate);
}

void drawCell(const Ui& ui, const StrategyGrid& grid, const Cells& cells, std::size_t place) {
    const AppState& state = ui.state;
    const Strategy strategy = grid.film.table[place];
    const float scale = ui.scale, line = ImGui::GetFontSize();
    const ImVec2 at = cells.at(strategy), end{at.x + cells.inner(), at.y + cells.row - 2 * cells.gap};
    ImGui::SetCursorScreenPos(at);
    const std::string name = fmt::format("strategy {}, {}", strategy.s, strategy.t);
    const bool clicked = ImGui::InvisibleButton(name.c_str(), {end.x - at.x, end.y - at.y});
    const bool hovered = ImGui::IsItemHovered(), chosen = isChosen(state, strategy);
    markItem(ui.widgets, name);
    const float share = static_cast<float>(grid.share(place, state.strategiesAlone));
    const bool nothing = grid.film.aloneMeans.mean[place] == Rgb(0.0);
    if (hovered) {
        const float x = (ImGui::GetIO().MousePos.x - at.x) / (end.x - at.x);
        const auto count = static_cast<float>(grid.film.pixels());
        tooltip(tooltipOf(state, grid, place,
                          static_cast<std::uint32_t>(std::clamp(x * count, 0.0f, count - 1.0f))));
    }
    if (clicked && mayChoose(state))
        ui.commands.push_back(SetMakers{{makerShowing(state, strategy, chosen), state.makers.second}});

    drawText(ui, at, nothing ? ui.palette.inkSoft : ui.palette.ink, labelOf(strategy, cells.brief));

    const Pen list = penOf(ui);
    const ImVec2 max{end.x, end.y - heightBelow(ui, cells) - scale},
        min{at.x, std::min(std::round(at.y + line + scale), max.y - 2 * scale)};
    if (nothing) {
        list.AddRect(min, max, ui.palette.grid);
    } else {
        drawStrip(ui, grid, place, min, max);
        list.AddRect(min, max, ui.palette.wallBack);
        drawShare(ui, cells, share, at, end);
    }
    if (chosen || (hovered && mayChoose(state)))
        list.AddRect({min.x - 2 * scale, min.y - 2 * scale}, {max.x + 2 * scale, max.y + 2 * scale},
                     ui.palette.accent, 0.0f, ImDrawFlags_None, 2 * scale);
}

/// What the percents and shades mean, line by line, in the corner where there are no strategies.
void drawLegend(const Ui& ui, const StrategyGrid& grid, const Cells& cells, float right) {
    const float line = ImGui::GetFontSize();
    std::vector<std::pair<std::string, std::string>> lines;
    if (ui.state.strategiesAlone)
        lines.push_back(
            {say("each by itself: light is counted several times"), say("counted several times")});
    else if (grid.white > 0.0)
        lines.push_back({say("shares of all light: together 100 %"), say("together 100 %")});
    const std::string white = grid.white > 0.0 ? say("white: \u2265 {} {}", shown(grid.white), unitOf(grid))
                                               : std::string(tr("all black"));
    lines.push_back({white, grid.white > 0.0 ? say("white: \u2265 {}", shown(grid.white)) : white});
    if (grid.hasLonger) {
        const std::string share = percent(grid.share(grid.film.table.longer(), false));
        lines.push_back(
            {say("more than {} vertices, not shown: {}", kGridVertices, share), say("longer: {}", share)});
    }
    float y = cells.origin.y;
    for (const auto& [full, brief] : lines) {
        const auto row = static_cast<float>(std::floor((y + line - cells.origin.y) / cells.row));
        // Paths of n vertices have n + 1 strategies, or n.
        const float left = cells.origin.x + (row + (grid.ofEye() ? 2.0f : 3.0f)) * cells.width;
        drawText(ui, {right, y}, ui.palette.inkSoft, firstThatFits({full, brief}, right - left),
                 Align::right);
        y += line;
    }
}

/// The rows' names, and how large all is.
Cells layOut(const Ui& ui, const StrategyGrid& grid, ImVec2 min, ImVec2 max) {
    const float scale = ui.scale, line = ImGui::GetFontSize();
    constexpr float kLeastColumns = 6, kMostRow = 84;
    const float head = textSize("6").x + 8 * scale;
    const auto rows = static_cast<float>(grid.longest - 1);
    const float columns = std::max(kLeastColumns, static_cast<float>(grid.longest + (grid.ofEye() ? 0 : 1)));
    Cells cells;
    cells.origin = {min.x + head, min.y};
    cells.gap = 3 * scale;
    cells.width = (max.x - min.x - head + 2 * cells.gap) / columns;
    cells.row = std::min((max.y - min.y + 2 * cells.gap) / rows, kMostRow * scale);
    float widest = 0.0f;
    for (std::size_t place = 0; place < grid.film.table.size(); ++place)
        widest = std::max(widest, textSize(wholePercent(grid.share(place, ui.state.strategiesAlone))).x);
    const auto fit = [&](bool brief, float more) {
        return textSize(labelOf({0, 6}, brief)).x + more <= cells.inner();
    };
    const bool below = cells.row > 2 * line + 14 * scale, beside = fit(true, widest + 4 * scale);
    cells.number = below ? NumberAt::below : beside ? NumberAt::beside : NumberAt::nowhere;
    cells.widestNumber = widest;
    cells.brief = !fit(false, cells.number == NumberAt::beside ? widest + 4 * scale : 0.0f);
    for (std::uint32_t n = 2; n <= grid.longest; ++n)
        drawText(ui, {min.x, cells.at({0, n}).y}, ui.palette.inkSoft, fmt::format("{}", n));
    return cells;
}

std::string titleOf(const Ui& ui, const StrategyGrid* grid, float width) {
    const std::string brief = drawingTitle(ui.state, "strategies");
    const char* full = !grid           ? brief.c_str()
                       : grid->ofEye() ? "k = s + t vertices: s from the light, t from the eye"
                                       : "k = s + t vertices: s from the light, t from P's wall";
    return firstThatFits({full, brief, "Strategies"}, width, ui.fonts.strong);
}

}  // namespace

void strategiesPanel(const Ui& ui, ImVec2 size) {
    const OnSheet drawing(ui, "strategies", size);
    const AppState& state = ui.state;
    const ImVec2 origin = ImGui::GetCursorScreenPos(), end{origin.x + size.x, origin.y + size.y};
    mark(ui.widgets, "strategies", origin, end);
    const StrategyGrid* grid = state.answer ? state.answer->strategies.get() : nullptr;
    const float head = ImGui::GetFrameHeight(), line = ImGui::GetFontSize(),
                toggled = textSize(kAlone).x + 2 * ImGui::GetStyle().FramePadding.x;
    drawText(ui, {origin.x, origin.y + (head - line) / 2}, ui.palette.ink,
             titleOf(ui, grid, size.x - toggled - 8 * ui.scale), Align::left, ui.fonts.strong);
    ImGui::SetCursorScreenPos({end.x - toggled, origin.y});
    bool alone = state.strategiesAlone;
    if (toggle(ui.widgets, kAlone, alone, {toggled, 0})) ui.commands.push_back(WeighStrategies{alone});
    tooltip("each strategy counts whole, as if there were no other; else by its weight");
    const ImVec2 min{origin.x, origin.y + head + 4 * ui.scale};
    if (grid && grid->film.whole.passes > 0) {
        const Cells cells = layOut(ui, *grid, min, end);
        for (std::size_t place = 0; place < grid->film.table.size(); ++place)
            if (grid->canBe(grid->film.table[place])) drawCell(ui, *grid, cells, place);
        drawLegend(ui, *grid, cells, end.x);
    } else {
        drawText(ui, {(origin.x + end.x) / 2, (origin.y + end.y) / 2}, ui.palette.inkSoft,
                 grid && !grid->refusal.empty() ? std::string_view(grid->refusal) : "being computed",
                 Align::middle);
    }
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy(size);
}

}  // namespace halfdisk
