// The run of an estimator that follows paths, on the canvas: where its paths went up to the step that is
// shown, what they found, and the step itself.
#include <algorithm>
#include <cmath>

#include "app/canvas.h"
#include "app/run_text.h"

namespace halfdisk {
namespace {

/// Of the steps before the one that is shown: the latest ones.
constexpr std::size_t kMostDrawn = 4000;

struct RunView {
    const PathRecord* record = nullptr;
    std::size_t end = 0;  // steps shown
    bool stepping = false;
};

RunView shownRun(const AppState& state) {
    if (!state.answer || !state.answer->pathRun) return {};
    const PathRecord& record = state.answer->pathRun->record;
    const std::size_t count = record.events.size();
    const bool stepping = state.playback.stepping;
    return {&record, stepping ? std::min(state.playback.event, count) : count, stepping};
}

Vec2 endOf(const Canvas& canvas, const PathEvent& event) {
    return event.missed ? canvas.farAlong(event.from, event.to - event.from) : event.to;
}

/// Of light on its way, or of a path that looks for it.
ImU32 colorOf(const Palette& palette, const PathEvent& event) {
    return event.carried == Carried::power ? palette.rayBright : palette.sample;
}

void drawPhoton(const Canvas& canvas, Vec2 at, float opacity) {
    canvas.list.AddCircleFilled(canvas.screen(at), canvas.px(3.5f),
                                withOpacity(canvas.ui.palette.light, opacity));
    canvas.list.AddCircle(canvas.screen(at), canvas.px(3.5f), withOpacity(canvas.ui.palette.ink, opacity), 0,
                          canvas.px(1));
}

/// What the look-up covers along its wall.
void drawKernel(const Canvas& canvas, const PathEvent& event, float opacity) {
    if (event.segment == kNoSegment) return;
    const Segment& wall = canvas.ui.state.scene->scene.segments[event.segment];
    const Vec2 along = glm::normalize(wall.b - wall.a);
    const auto within = [&](double by) {
        const double t =
            std::clamp(glm::dot(event.from + by * along - wall.a, along), 0.0, glm::length(wall.b - wall.a));
        return wall.a + t * along;
    };
    canvas.line(within(-event.radius), within(event.radius), withOpacity(canvas.ui.palette.halfDisk, opacity),
                canvas.px(7));
}

void drawPassed(const Canvas& canvas, const PathEvent& event, bool current) {
    const Palette& palette = canvas.ui.palette;
    const float opacity = current ? 0.95f : 0.4f / static_cast<float>(1 + event.vertex / 2);
    const float thickness = canvas.px(current ? 2.6f : 1.2f);
    switch (event.kind) {
        case PathEventKind::fly:
            canvas.line(event.from, endOf(canvas, event), withOpacity(colorOf(palette, event), opacity),
                        thickness);
            break;
        case PathEventKind::asked:
        case PathEventKind::joined: {
            const ImU32 color = event.visible ? palette.shadowRayClear : palette.shadowRayBlocked;
            // One that was asked for nothing says nothing.
            if ((event.visible && event.weight > 0.0) || current)
                canvas.line(event.from, endOf(canvas, event), withOpacity(color, 0.6f * opacity),
                            0.6f * thickness);
            break;
        }
        case PathEventKind::lookedUp:
            drawKernel(canvas, event, 0.8f * opacity);
            break;
        case PathEventKind::kept:
            drawPhoton(canvas, event.from, current ? 1.0f : 0.8f);
            break;
        default:
            break;
    }
}

void drawNow(const Canvas& canvas, const PathEvent& event) {
    const Palette& palette = canvas.ui.palette;
    switch (event.kind) {
        case PathEventKind::fly:
        case PathEventKind::met:
        case PathEventKind::asked:
        case PathEventKind::joined:
            canvas.line(event.from, endOf(canvas, event), palette.point, canvas.px(4));
            break;
        case PathEventKind::depart: {
            const ImVec2 from = canvas.screen(event.from);
            const Vec2 way = event.to - event.from;
            const ImVec2 to{from.x + canvas.px(36) * static_cast<float>(way.x),
                            from.y - canvas.px(36) * static_cast<float>(way.y)};
            canvas.list.AddLine(from, to, palette.point, canvas.px(4));
            break;
        }
        case PathEventKind::lookedUp:
            drawKernel(canvas, event, 1.0f);
            break;
        default:
            break;
    }
    const bool atEnd = event.kind == PathEventKind::fly || event.kind == PathEventKind::met;
    if (atEnd && event.missed) return;
    canvas.list.AddCircleFilled(canvas.screen(atEnd ? event.to : event.from), canvas.px(6), palette.point);
    canvas.list.AddCircle(canvas.screen(atEnd ? event.to : event.from), canvas.px(6), palette.panel, 0,
                          canvas.px(1.5f));
}

/// Paths that belong to the step: its own, and of two that are joined also the one before.
bool belongs(const AppState& state, const PathEvent& event, const PathEvent& now) {
    if (event.path == now.path) return true;
    return state.answer->asked.run == Run::bidirectional && event.path / 2 == now.path / 2;
}

}  // namespace

void drawRun(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const RunView view = shownRun(state);
    if (!view.record || !state.shows(View::rays)) return;
    const PathEvent* now = currentPathEvent(state);
    const auto& events = view.record->events;
    for (std::size_t i = view.end - std::min(view.end, kMostDrawn); i < view.end; ++i)
        if (!now || !belongs(state, events[i], *now)) drawPassed(canvas, events[i], false);
    if (!now) return;
    std::size_t first = view.end - 1;
    while (first > 0 && belongs(state, events[first - 1], *now)) --first;
    for (std::size_t i = std::max(first, view.end - std::min(view.end, kMostDrawn)); i < view.end; ++i)
        drawPassed(canvas, events[i], true);
    drawNow(canvas, *now);
}

}  // namespace halfdisk
