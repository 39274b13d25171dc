// The pictures that belong to the canvas: the field behind the scene with its legend, and where the eye
// looks.
#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/draw_text.h"
#include "app/tone.h"
#include "core/surface.h"

namespace halfdisk {
namespace {

/// Less than 1: dark places stay lighter than ink, so that lines and words on them can be read.
constexpr float kOpacity = 0.85f;

const LightPicture* shownField(const AppState& state) {
    const bool there = state.shows(View::field) && state.answer && state.answer->field;
    return there ? state.answer->field.get() : nullptr;
}

std::string rangeEnd(const LightPicture& field) {
    return "\u2265 " + shown(field.white) + " W/m";
}

/// In the colours of the picture, from black to white. Returns its width.
void drawScale(const Canvas& canvas, ImVec2 min, ImVec2 max) {
    constexpr int kSteps = 32;
    const float step = (max.x - min.x) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const int byte = srgbByte((i + 0.5) / kSteps);
        const float x = min.x + step * static_cast<float>(i);
        canvas.list.AddRectFilled({x, min.y}, {x + step, max.y}, IM_COL32(byte, byte, byte, 255));
    }
    canvas.list.AddRect(min, max, canvas.ui.palette.wallBack);
}

}  // namespace

void drawField(const Canvas& canvas) {
    const LightPicture* picture = shownField(canvas.ui.state);
    if (!picture || picture->colors.empty()) return;
    const Field& field = std::get<Field>(picture->sensor);
    const Vec2 cell = (field.max - field.min) / Vec2(field.width, field.height);
    const auto left = [&](std::uint32_t column) {
        return std::round(canvas.screen({field.min.x + column * cell.x, 0.0}).x);
    };
    const auto top = [&](std::uint32_t row) {
        return std::round(canvas.screen({0.0, field.max.y - row * cell.y}).y);
    };
    for (std::uint32_t row = 0; row < field.height; ++row) {
        const float high = top(row), low = top(row + 1);
        if (low <= canvas.rect.min.y || high >= canvas.rect.max.y) continue;
        const std::uint32_t* colors = picture->colors.data() + std::size_t{row} * field.width;
        for (std::uint32_t begin = 0, end = 0; begin < field.width; begin = end) {
            while (end < field.width && colors[end] == colors[begin]) ++end;
            canvas.list.AddRectFilled({left(begin), high}, {left(end), low},
                                      withOpacity(colors[begin], kOpacity));
        }
    }
}

bool fieldIsSeen(const Canvas& canvas) {
    const LightPicture* picture = shownField(canvas.ui.state);
    return picture && !picture->colors.empty();
}

void drawFieldLegend(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    if (!state.shows(View::field)) return;
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
        const std::string words = picture && !picture->refusal.empty() ? "no field: " + picture->refusal
                                                                       : "the field is being computed";
        plate(textSize(words).x);
        drawText(canvas.ui, at, palette.inkSoft, words);
        return;
    }
    const std::string most = rangeEnd(*picture);
    const float scale = canvas.px(90), others = scale + textSize(most).x + canvas.px(40);
    const std::string_view least = textSize("fluence 0").x + others > canvas.rect.width() ? "0" : "fluence 0";
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
    if (!state.shows(View::eye) || !state.eyePixel || !state.answer || !state.answer->eye) return;
    const SegmentIndex& index = state.scene->index;
    const Sensor& strip = state.answer->eye->sensor;
    if (*state.eyePixel >= pixelCount(strip)) return;
    Ray ray = sightFrom(startOf(strip, index, *state.eyePixel, 0.5, 0.5), index, 0.5).ray;
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
