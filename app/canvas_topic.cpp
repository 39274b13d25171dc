// What a term that is looked up speaks of, lit up on the canvas.
#include <algorithm>

#include "app/canvas.h"

namespace halfdisk {
namespace {

/// Rays from P of one kind of event, thick.
void drawRays(const Canvas& canvas, EventKind kind, bool below) {
    const AppState& state = canvas.ui.state;
    if (!state.answer || !state.answer->record || state.answer->pathRun) return;
    const auto& events = state.answer->record->events;
    const RecordSummary& summary = state.answer->summary;
    constexpr std::size_t kMostHits = 400;
    const std::vector<std::uint32_t>& indices = below ? summary.deeper : summary.atP;
    std::size_t drawn = 0;
    for (const std::uint32_t i : indices) {
        const Event& event = events[i];
        if (event.kind != kind || drawn++ >= kMostHits) continue;
        const Vec2 to = event.missed ? canvas.farAlong(event.from, event.direction) : event.to;
        canvas.line(event.from, to, withOpacity(canvas.ui.palette.accent, 0.8f), canvas.px(3));
    }
}

void drawRing(const Canvas& canvas, Vec2 place) {
    canvas.list.AddCircle(canvas.screen(place), canvas.px(20), canvas.ui.palette.accent, 0, canvas.px(3));
}

void lightUpSources(const Canvas& canvas) {
    const Scene& scene = canvas.ui.state.scene->scene;
    for (const Segment& wall : scene.segments)
        if (isEmitter(wall)) canvas.line(wall.a, wall.b, canvas.ui.palette.accent, canvas.px(6));
    for (const DeltaLight& light : scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light)) drawRing(canvas, point->position);
}

}  // namespace

namespace {

/// All that one path, or both of a pair, flew and found.
void drawShownPath(const Canvas& canvas, const LightAnswer& answer, std::size_t passed) {
    const auto& events = answer.pathRun->record.events;
    if (passed == 0 || passed > events.size()) return;
    const auto numberOf = [&](const PathEvent& event) {
        return answer.asked.run == Run::bidirectional ? event.path / 2 : event.path;
    };
    constexpr std::size_t kMostEvents = 4000;
    const std::uint32_t number = numberOf(events[passed - 1]);
    for (std::size_t i = passed, seen = 0; i-- > 0 && seen < kMostEvents; ++seen) {
        if (numberOf(events[i]) < number) break;
        if (numberOf(events[i]) != number) continue;
        const PathEvent& event = events[i];
        const bool joins = event.kind == PathEventKind::asked || event.kind == PathEventKind::joined;
        if (event.kind != PathEventKind::fly && !(joins && event.value != Rgb(0.0))) continue;
        const Vec2 to = event.missed ? canvas.farAlong(event.from, event.to - event.from) : event.to;
        canvas.line(event.from, to, canvas.ui.palette.panel, canvas.px(joins ? 3.0f : 6.0f));
        canvas.line(event.from, to, canvas.ui.palette.accent, canvas.px(joins ? 1.6f : 4.0f));
    }
}

}  // namespace

void drawShownSample(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    if (!state.shownSample || !state.answer) return;
    if (state.answer->pathRun) return drawShownPath(canvas, *state.answer, *state.shownSample);
    if (!state.answer->record) return;
    const auto& events = state.answer->record->events;
    const std::size_t passed = *state.shownSample;
    if (passed == 0 || passed > events.size()) return;
    const Event& event = events[passed - 1];
    const Vec2 to = event.missed ? canvas.farAlong(event.from, event.to - event.from) : event.to;
    canvas.line(event.from, to, canvas.ui.palette.accent, canvas.px(4));
}

void drawTopic(const Canvas& canvas) {
    const AppState& state = canvas.ui.state;
    const Palette& palette = canvas.ui.palette;
    const Vec2 P = positionOf(state.scene->scene, state.at), N = state.scene->index.normal(state.at.segment);
    const Vec2 right{N.y, -N.x};
    const float radius = halfDiskRadius(canvas);
    const auto arrow = [&](Vec2 way) {
        const ImVec2 p = canvas.screen(P);
        canvas.list.AddLine(
            p, {p.x + radius * static_cast<float>(way.x), p.y - radius * static_cast<float>(way.y)},
            palette.accent, canvas.px(5));
    };
    switch (state.topic) {
        case Topic::none:
        case Topic::error:
            break;
        case Topic::shadowRay:
            drawRays(canvas, EventKind::light, false);
            break;
        case Topic::halfDisk:
            drawHalfDisk(canvas, P, N, 1.0f);
            drawHalfDisk(canvas, P, N, 1.0f);
            break;
        case Topic::normal:
            arrow(N);
            break;
        case Topic::tangent:
            arrow(right);
            arrow(-right);
            break;
        case Topic::sample:
        case Topic::radiance:
        case Topic::irradiance:
            drawRays(canvas, EventKind::arrival, false);
            break;
        case Topic::albedo: {
            const Segment& wall = state.scene->scene.segments[state.at.segment];
            canvas.line(wall.a, wall.b, palette.accent, canvas.px(6));
            break;
        }
        case Topic::recursion:
            drawRays(canvas, EventKind::arrival, false);
            drawRays(canvas, EventKind::arrival, true);
            break;
        case Topic::light:
            lightUpSources(canvas);
            break;
        case Topic::eye:
            if (state.scene->scene.eye) drawRing(canvas, state.scene->scene.eye->position);
            break;
    }
}

}  // namespace halfdisk
