// The light on the canvas: P with its half-disk, sample rays coloured by what they bring back, the recursion
// fading with depth.
#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/draw_text.h"
#include "app/imgui_compat.h"
#include "app/step_text.h"

namespace halfdisk {
namespace {

struct RecordView {
    const Record* record = nullptr;
    const RecordSummary* summary = nullptr;
    std::size_t end = 0;  // events shown
};

RecordView shownRecord(const AppState& state) {
    if (!state.answer || !state.answer->record || state.answer->pathRun) return {};
    const Record& record = *state.answer->record;
    const std::size_t count = record.events.size();
    return {&record, &state.answer->summary,
            state.playback.stepping ? std::min(state.playback.event, count) : count};
}

/// Calls `draw` with the events at `indices` (ascending) that are shown.
void forShown(const RecordView& view, const std::vector<std::uint32_t>& indices, const auto& draw) {
    for (const std::uint32_t i : indices) {
        if (i >= view.end) return;
        draw(view.record->events[i]);
    }
}

ImU32 mixed(ImU32 from, ImU32 to, float t) {
    ImU32 result = 0;
    for (int shift = 0; shift < 32; shift += 8) {
        const float a = static_cast<float>((from >> shift) & 255u),
                    b = static_cast<float>((to >> shift) & 255u);
        result |= static_cast<ImU32>(std::lround(a + t * (b - a))) << shift;
    }
    return result;
}

Vec2 endOf(const Canvas& canvas, const Event& event) {
    return event.missed ? canvas.farAlong(event.from, event.direction) : event.to;
}

void drawRay(const Canvas& canvas, const Event& arrival, double top, float opacity, float thickness) {
    const Palette& palette = canvas.ui.palette;
    const float share =
        top > 0.0 ? static_cast<float>(std::clamp(gray(arrival.value) / top, 0.0, 1.0)) : 0.0f;
    const float bright = std::sqrt(share);
    const ImU32 color =
        withOpacity(mixed(palette.rayDark, palette.rayBright, bright), opacity * (0.55f + 0.45f * bright));
    canvas.line(arrival.from, endOf(canvas, arrival), color, canvas.px(thickness * (1.0f + 1.5f * bright)));
}

ImVec2 onArc(const Canvas& canvas, Vec2 P, Vec2 direction) {
    const ImVec2 center = canvas.screen(P);
    const float radius = halfDiskRadius(canvas);
    return {center.x + radius * static_cast<float>(direction.x),
            center.y - radius * static_cast<float>(direction.y)};
}

/// The others are not seen.
void tellFirst(const Canvas& canvas, std::size_t drawn) {
    drawText(canvas.ui, {canvas.rect.min.x + canvas.px(8), canvas.rect.min.y + canvas.px(44)},
             canvas.ui.palette.inkSoft, "the first " + std::to_string(drawn) + " deeper rays are drawn");
}

}  // namespace

float halfDiskRadius(const Canvas& canvas) {
    return std::min(canvas.px(80), 0.2f * std::min(canvas.rect.width(), canvas.rect.height()));
}

void drawHalfDisk(const Canvas& canvas, Vec2 P, Vec2 N, float opacity) {
    const ImVec2 center = canvas.screen(P);
    const float radius = halfDiskRadius(canvas);
    const float up = std::atan2(-static_cast<float>(N.y), static_cast<float>(N.x));
    const float quarter = static_cast<float>(kPi) / 2;
    canvas.list.PathArcTo(center, radius, up - quarter, up + quarter, 48);
    canvas.list.PathFillConvex(withOpacity(canvas.ui.palette.halfDisk, 0.22f * opacity));
    canvas.list.PathArcTo(center, radius, up - quarter, up + quarter, 48);
    canvas.list.PathStroke(withOpacity(canvas.ui.palette.halfDisk, opacity), ImDrawFlags_Closed,
                           canvas.px(2));
}

void drawSamples(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const RecordView view = shownRecord(state);
    if (!view.record || !state.shows(View::rays)) return;
    const Palette& palette = canvas.ui.palette;
    const bool many = state.settings.samples > 256;
    forShown(view, view.summary->atP, [&](const Event& event) {
        if (event.kind == EventKind::arrival)
            drawRay(canvas, event, view.summary->brightest, many ? 0.5f : 1.0f, 1.2f);
        if (event.kind == EventKind::meet && event.onward)
            canvas.line(event.from, endOf(canvas, event), withOpacity(palette.rayDark, many ? 0.25f : 0.7f),
                        canvas.px(1.2f));
        if (event.kind != EventKind::light || (!event.visible && event.segment != kNoSegment)) return;
        const ImU32 color = event.visible ? palette.shadowRayClear : palette.shadowRayBlocked;
        canvas.line(event.from, endOf(canvas, event), withOpacity(color, many ? 0.25f : 0.7f),
                    canvas.px(1.2f));
    });
    if (!state.shows(View::halfdisk)) return;
    forShown(view, view.summary->atP, [&](const Event& event) {
        if (event.kind == EventKind::direction)
            canvas.list.AddCircleFilled(onArc(canvas, event.from, event.direction),
                                        canvas.px(many ? 2.0f : 3.5f), palette.sample);
    });
}

void drawTree(const Canvas& canvas) {
    const RecordView view = shownRecord(canvas.ui.state);
    if (!view.record) return;
    const std::size_t all = view.summary->deeperCount;
    const auto& cloud = canvas.ui.state.answer->tree;
    // A cloud is of the whole run.
    const bool clouded = cloud && view.end == view.record->events.size();
    if (clouded) {
        drawCloud(canvas, cloud);
        if (cloud->lines < all) tellFirst(canvas, cloud->lines);
        if (!isBlurred(canvas, *cloud)) return;
    }
    std::size_t drawn = 0;
    forShown(view, view.summary->deeper, [&](const Event& event) {
        ++drawn;
        drawRay(canvas, event, view.summary->brightest, 0.55f / static_cast<float>(event.depth), 0.8f);
    });
    if (!clouded && drawn == view.summary->deeper.size() && drawn < all) tellFirst(canvas, drawn);
}

void drawCurrentStep(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const Event* event = currentEvent(state);
    if (!event) return;
    const Palette& palette = canvas.ui.palette;
    const Record& record = *state.answer->record;

    // The way from P to the half-disk that is being gathered now.
    for (std::uint32_t call = event->call; record.calls[call].parent != kNoCall;
         call = record.calls[call].parent) {
        const Call& here = record.calls[call];
        canvas.line(record.calls[here.parent].at.P, here.at.P, palette.accent, canvas.px(3));
    }
    const Call& call = record.calls[event->call];
    if (event->depth > 0) {
        drawHalfDisk(canvas, call.at.P, call.at.N, 0.8f);
        drawPoint(canvas, call.at.P, call.at.N);
    }
    switch (event->kind) {
        case EventKind::sample: {  // not rotated yet: the angle is drawn in the local frame, shown about the
                                   // true normal
            const Vec2 local =
                frameFromNormal(call.at.N).toWorld(std::cos(event->theta), std::sin(event->theta));
            canvas.list.AddCircle(onArc(canvas, call.at.P, local), canvas.px(7), palette.point, 0,
                                  canvas.px(2.5f));
            break;
        }
        case EventKind::direction:
            canvas.list.AddLine(canvas.screen(call.at.P), onArc(canvas, call.at.P, event->direction),
                                palette.point, canvas.px(3));
            canvas.list.AddCircleFilled(onArc(canvas, call.at.P, event->direction), canvas.px(5),
                                        palette.point);
            break;
        case EventKind::light:
        case EventKind::meet:
        case EventKind::arrival:
        case EventKind::accumulate: {
            const Vec2 end =
                event->missed && event->kind == EventKind::accumulate ? event->to : endOf(canvas, *event);
            canvas.line(event->from, end, palette.point, canvas.px(3));
            if (!event->missed) canvas.list.AddCircleFilled(canvas.screen(end), canvas.px(5), palette.point);
            break;
        }
        case EventKind::enter:
        case EventKind::average:
        case EventKind::leave:
            break;
    }
}

void drawPoint(const Canvas& canvas, Vec2 P, Vec2 N) {
    const Palette& palette = canvas.ui.palette;
    const ImVec2 p = canvas.screen(P);
    const float length = halfDiskRadius(canvas) * 0.62f;
    const ImVec2 tip{p.x + length * static_cast<float>(N.x), p.y - length * static_cast<float>(N.y)};
    canvas.list.AddLine(p, tip, palette.normal, canvas.px(2.5f));
    const ImVec2 along{static_cast<float>(N.x), -static_cast<float>(N.y)};
    const float head = canvas.px(8);
    canvas.list.AddTriangleFilled({tip.x + along.x * head, tip.y + along.y * head},
                                  {tip.x - along.y * head / 2, tip.y + along.x * head / 2},
                                  {tip.x + along.y * head / 2, tip.y - along.x * head / 2}, palette.normal);
    canvas.list.AddCircleFilled(p, canvas.px(6), palette.point);
    canvas.list.AddCircle(p, canvas.px(6), palette.panel, 0, canvas.px(1.5f));
}

void drawRayLegend(const Canvas& canvas) {
    const RecordView view = shownRecord(canvas.ui.state);
    if (!view.record || !canvas.ui.state.shows(View::rays) || !(view.summary->brightest > 0.0)) return;
    const Palette& palette = canvas.ui.palette;
    const float line = ImGui::GetFontSize(), width = canvas.px(90);
    const ImVec2 at{canvas.rect.min.x + canvas.px(10), canvas.rect.max.y - line - canvas.px(6)};
    const std::string most = shown(view.summary->brightest) + " W/(m rad)";
    const float others = width + textSize(most).x + canvas.px(40);
    const bool narrow = textSize("ray brings 0").x + others > canvas.rect.width();
    const std::string_view least = narrow ? "0" : "ray brings 0";
    const float first = textSize(least).x + canvas.px(8);
    canvas.list.AddRectFilled(
        {at.x - canvas.px(6), at.y - canvas.px(3)},
        {at.x + first + width + textSize(most).x + canvas.px(14), at.y + line + canvas.px(3)},
        withOpacity(palette.background, 0.9f), canvas.px(4));
    drawText(canvas.ui, at, palette.inkSoft, least);
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i) {
        const float t = static_cast<float>(i) / (kSteps - 1),
                    x = at.x + first + width * static_cast<float>(i) / kSteps;
        canvas.list.AddLine({x, at.y + line / 2}, {x + width / kSteps, at.y + line / 2},
                            mixed(palette.rayDark, palette.rayBright, std::sqrt(t)),
                            canvas.px(1.5f + 3.5f * t));
    }
    drawText(canvas.ui, {at.x + first + width + canvas.px(8), at.y}, palette.inkSoft, most);
}

}  // namespace halfdisk
