// The pictures that belong to the canvas: the field behind the scene with its legend, and where the eye
// looks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/cloud_stages.h"
#include "app/draw_text.h"
#include "app/false_color.h"
#include "app/language.h"
#include "app/message_words.h"
#include "app/picture_stages.h"
#include "app/shown_pictures.h"
#include "app/tone.h"
#include "core/surface.h"

namespace halfdisk {
namespace {

/// Less than 1: dark places stay lighter than ink, so that lines and words on them can be read.
constexpr float kOpacity = 0.85f;

/// The one whose scale the legend tells; two have the same.
const LightPicture* shownField(const AppState& state) {
    if (!state.shows(View::field) || !state.answer) return nullptr;
    const LightPicture *first = state.answer->pictures.field.get(),
                       *second = state.answer->against.field.get();
    return second && !second->colors.empty() && (!first || first->colors.empty()) ? second : first;
}

/// The picture's colours as they are asked for.
const std::vector<std::uint32_t>& colorsOf(const AppState& state, const LightPicture& field) {
    if (state.scale == FieldScale::logarithm) return field.logColors;
    return state.scale == FieldScale::noise ? field.noiseColors : field.colors;
}

/// Under the left end of the legend's scale.
std::string rangeStart(const AppState& state, const LightPicture& field) {
    const double least = std::pow(10.0, -kScaleDecades);
    if (state.scale == FieldScale::noise) return say("noise {:g} %", 100.0 * least);
    if (state.scale == FieldScale::logarithm) return say("fluence {}", shown(least * field.white));
    return std::string(tr("fluence 0"));
}

std::string rangeEnd(const AppState& state, const LightPicture& field) {
    if (state.scale == FieldScale::noise) return "\u2265 100 %";
    return field.white > 0.0 ? fmt::format("\u2265 {} W/m", shown(field.white))
                             : std::string(tr("no light at all"));
}

/// So low that words would lie on each other.
bool isTiny(const Canvas& canvas) {
    const float line = ImGui::GetFontSize();
    return canvas.rect.height() < cornerHeight(canvas.ui.state, canvas.rect.width()) + 7 * line;
}

/// In the colours of the picture, from black to white. Returns its width.
void drawScale(const Canvas& canvas, ImVec2 min, ImVec2 max) {
    constexpr int kSteps = 32;
    const float step = (max.x - min.x) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const std::uint8_t byte = srgbByte((i + 0.5) / kSteps);
        const float x = min.x + step * static_cast<float>(i);
        const bool plain = canvas.ui.state.scale == FieldScale::light;
        canvas.list.AddRectFilled({x, min.y}, {x + step, max.y},
                                  plain ? packed(byte, byte, byte) : falseColor((i + 0.5) / kSteps));
    }
    canvas.list.AddRect(min, max, canvas.ui.palette.wallBack);
    if (canvas.ui.state.scale == FieldScale::light) return;
    // One for each power of ten.
    for (int decade = 1; decade < static_cast<int>(kScaleDecades); ++decade) {
        const float x = std::round(min.x + (max.x - min.x) * static_cast<float>(decade / kScaleDecades));
        canvas.list.AddLine({x, min.y}, {x, max.y}, canvas.ui.palette.panel, canvas.px(1.5f));
    }
}

}  // namespace

namespace {

void drawOneField(const Canvas& canvas, const LightPicture& picture) {
    const Field& field = std::get<Field>(picture.sensor);
    const std::vector<std::uint32_t>& all = colorsOf(canvas.ui.state, picture);
    if (all.size() != picture.colors.size()) return;
    const Vec2 cell = (field.max - field.min) / Vec2(field.width, field.height);
    const auto left = [&](std::uint32_t column) {
        return std::round(canvas.screen({field.min.x + column * cell.x, 0.0}).x);
    };
    const auto top = [&](std::uint32_t row) {
        return std::round(canvas.screen({0.0, field.max.y - row * cell.y}).y);
    };
    // On the screen runs of one colour, to the sheet a picture.
    if (canvas.list.drawing)
        canvas.list.drawing->cells({left(0), top(0)}, {left(field.width), top(field.height)}, all,
                                   field.width, kOpacity);
    for (std::uint32_t row = 0; row < field.height; ++row) {
        const float high = top(row), low = top(row + 1);
        if (low <= canvas.rect.min.y || high >= canvas.rect.max.y) continue;
        const std::uint32_t* colors = all.data() + std::size_t{row} * field.width;
        for (std::uint32_t begin = 0, end = 0; begin < field.width; begin = end) {
            while (end < field.width && colors[end] == colors[begin]) ++end;
            canvas.list.screen.AddRectFilled({left(begin), high}, {left(end), low},
                                             withOpacity(colors[begin], kOpacity));
        }
    }
}

/// Who made a half, at its upper end.
void drawHalfTitle(const Canvas& canvas, std::string_view title, const char* side, float x, Align align) {
    const Ui& ui = canvas.ui;
    const float room = align == Align::right ? x - canvas.rect.min.x : canvas.rect.max.x - x;
    const std::string words =
        firstThatFits({fmt::format("{}: {}", side, title), side, ""}, room - canvas.px(8), ui.fonts.strong);
    if (words.empty() || isTiny(canvas)) return;
    const ImVec2 size = textSize(words, ui.fonts.strong);
    const float y = canvas.rect.min.y + cornerHeight(ui.state, canvas.rect.width()) + canvas.px(8);
    const float left = align == Align::right ? x - size.x : x;
    canvas.list.AddRectFilled({left - canvas.px(5), y - canvas.px(3)},
                              {left + size.x + canvas.px(5), y + size.y + canvas.px(3)},
                              withOpacity(ui.palette.background, 0.9f), canvas.px(4));
    drawText(ui, {left, y}, ui.palette.ink, words, Align::left, ui.fonts.strong);
}

}  // namespace

bool hasSplit(const AppState& state) {
    return state.shows(View::field) && state.makers.second;
}

float splitAt(const Canvas& canvas) {
    return std::round(canvas.rect.min.x + canvas.ui.state.split * canvas.rect.width());
}

void drawField(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    if (!state.shows(View::field) || !state.answer) return;
    const PictureSet &first = state.answer->pictures, &second = state.answer->against;
    const auto draw = [&](const std::shared_ptr<const LightPicture>& picture, float from, float to) {
        if (!picture || picture->colors.empty()) return;
        canvas.list.PushClipRect({from, canvas.rect.min.y}, {to, canvas.rect.max.y}, true);
        drawOneField(canvas, *picture);
        canvas.list.PopClipRect();
    };
    const float split = hasSplit(state) ? splitAt(canvas) : canvas.rect.max.x;
    draw(first.field, canvas.rect.min.x, split);
    if (split < canvas.rect.max.x) draw(second.field, split, canvas.rect.max.x);
}

void drawSplit(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    if (!hasSplit(state)) return;
    const float x = splitAt(canvas), middle = canvas.rect.center().y;
    const ImU32 color = canvas.ui.palette.accent;
    canvas.list.AddLine({x, canvas.rect.min.y}, {x, canvas.rect.max.y}, canvas.ui.palette.panel,
                        canvas.px(4));
    canvas.list.AddLine({x, canvas.rect.min.y}, {x, canvas.rect.max.y}, color, canvas.px(2));
    canvas.list.AddCircleFilled({x, middle}, canvas.px(9), canvas.ui.palette.panel);
    canvas.list.AddCircle({x, middle}, canvas.px(9), color, 0, canvas.px(2));
    const Maker first = state.makers.first ? *state.makers.first : usualMaker(View::field);
    const float gap = canvas.px(14);
    drawHalfTitle(canvas, makerTitle(first, &*state.makers.second), "A", x - gap, Align::right);
    drawHalfTitle(canvas, makerTitle(*state.makers.second, &first), "B", x + gap, Align::left);
}

void drawCloud(const Canvas& canvas, const std::shared_ptr<const RayCloud>& cloud) {
    const Vec2 min = cloud->area.min, max = cloud->area.max;
    canvas.list.AddPicture({cloud, &cloud->picture}, canvas.screen({min.x, max.y}),
                           canvas.screen({max.x, min.y}));
}

bool isBlurred(const Canvas& canvas, const RayCloud& cloud) {
    const double cell = cloud.area.size().x / std::max(cloud.picture.width, 1);
    return cell * canvas.camera.pixelsPerMeter > static_cast<double>(canvas.px(4));
}

void drawWays(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    if (!state.shows(View::paths) || !state.answer || !state.answer->ways) return;
    const std::vector<LightWay>& ways = *state.answer->ways;
    const Palette& palette = canvas.ui.palette;
    const auto& cloud = state.answer->wayCloud;
    if (cloud) drawCloud(canvas, cloud);
    constexpr std::size_t kWaysDrawnNear = 400;
    const std::size_t lines = cloud && isBlurred(canvas, *cloud) ? kWaysDrawnNear : kWaysDrawn;
    for (std::size_t w = 0; w < std::min(ways.size(), lines); ++w) {
        const LightWay& way = ways[w];
        for (std::size_t i = 1; i < way.corners.size(); ++i) {
            const WayLook look = lookOf(way, i);
            canvas.line(way.corners[i - 1], way.corners[i],
                        withOpacity(look.scattered ? palette.sample : palette.rayBright, look.opacity),
                        canvas.px(1.3f));
        }
    }
}

bool fieldIsSeen(const Canvas& canvas) {
    const LightPicture* picture = shownField(canvas.ui.state);
    return picture && !picture->colors.empty();
}

void drawFieldLegend(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    if (!state.shows(View::field) || isTiny(canvas)) return;
    const Palette& palette = canvas.ui.palette;
    const LightPicture* picture = shownField(state);
    const float line = ImGui::GetFontSize(), gap = canvas.px(8);
    const ImVec2 at{canvas.rect.min.x + canvas.px(10), legendRow(canvas, state.shows(View::rays) ? 1 : 0)};
    const auto plate = [&](float width) {
        canvas.list.AddRectFilled({at.x - canvas.px(6), at.y - canvas.px(3)},
                                  {at.x + width + canvas.px(6), at.y + line + canvas.px(3)},
                                  withOpacity(palette.background, 0.9f), canvas.px(4));
    };
    if (!picture || picture->colors.empty()) {
        const bool refused = picture && !picture->refusal.empty();
        const std::string words = firstThatFits(
            {refused ? say("no field: {}", trMessage(picture->refusal)) : "the field is being computed",
             refused ? "no field by this estimator" : "computing"},
            canvas.rect.width() - canvas.px(24));
        plate(textSize(words).x);
        drawText(canvas.ui, at, palette.inkSoft, words);
        return;
    }
    const std::string most = rangeEnd(state, *picture), start = rangeStart(state, *picture);
    const float scale = canvas.px(90), others = scale + textSize(most).x + canvas.px(40);
    const std::string_view least =
        textSize(start).x + others > canvas.rect.width() ? "" : std::string_view(start);
    const float first = textSize(least).x + gap;
    plate(first + scale + gap + textSize(most).x);
    drawText(canvas.ui, at, palette.inkSoft, least);
    drawScale(canvas, {at.x + first, at.y + canvas.px(2)},
              {at.x + first + scale, at.y + line - canvas.px(1)});
    drawText(canvas.ui, {at.x + first + scale + gap, at.y}, palette.inkSoft, most);
}

float legendRow(const Canvas& canvas, int row) {
    const float line = ImGui::GetFontSize() + canvas.px(8);
    return canvas.rect.max.y - line * static_cast<float>(row + 1) + canvas.px(2);
}

void drawGaze(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    // A pinned pixel's own paths say it, where they are drawn.
    const auto pixel = state.eyePixel || state.shows(View::rays) ? state.eyePixel : state.pinnedPixel;
    if (!state.shows(View::eye) || !pixel || !state.answer || !state.answer->pictures.eye) return;
    const SegmentIndex& index = state.scene->index;
    const Sensor& strip = state.answer->pictures.eye->sensor;
    if (*pixel >= pixelCount(strip)) return;
    Ray ray = sightFrom(Receivers(strip, index).draw(*pixel, 0.5, 0.5), index, 0.5).ray;
    // On by mirrors and through glass, to what is really seen. Of glass, what it lets through.
    constexpr std::uint32_t kMostSpeculars = 16;
    for (std::uint32_t speculars = 0; speculars <= kMostSpeculars; ++speculars) {
        const Hit hit = index.closestHit(ray);
        const Vec2 end =
            hit ? ray.origin + hit.t * ray.direction : canvas.farAlong(ray.origin, ray.direction);
        canvas.line(ray.origin, end, canvas.ui.palette.panel, canvas.px(4.5f));
        canvas.line(ray.origin, end, canvas.ui.palette.accent, canvas.px(2.5f));
        if (!hit) return;
        const SurfacePoint at = surfaceAt(index, ray, hit);
        if (!isSpecular(*at.material)) {
            canvas.list.AddCircleFilled(canvas.screen(end), canvas.px(5), canvas.ui.palette.accent);
            return;
        }
        constexpr double kThrough = 1.0 - 1e-9;
        const auto onward = sampleSurface(at, Carried::radiance, {kThrough, 0.5, 0.5});
        if (!onward) return;
        ray = leave(index, at, *onward, speculars + 1);
    }
}

}  // namespace halfdisk
