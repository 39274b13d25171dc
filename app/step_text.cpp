#include "app/step_text.h"
#include "app/language.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/draw_text.h"
#include "app/run_text.h"

namespace halfdisk {
namespace {

std::string wallName(const AppState& state, std::uint32_t segment) {
    if (segment == kNoSegment) return std::string(tr("nothing"));
    return state.scene->scene.segmentNames[segment];
}

std::string vector(Vec2 v) {
    return local(fmt::format("({:.3f}, {:.3f})", v.x, v.y));
}

void describeLight(const AppState& state, const Event& event, StepText& text) {
    const bool emitter = event.segment != kNoSegment;
    if (emitter) text.where += say(", point {} of {}", event.n + 1, state.settings.samples);
    text.where +=
        emitter ? say(", light {}", wallName(state, event.segment)) : say(", light {}", event.light + 1);
    text.what = tr(event.visible ? "The shadow ray gets through: the light counts."
                                 : "Nothing arrives from this light.");
    text.values = say("L = {}   adds {}   directLightContrib = {}", vector(event.direction),
                      shown(event.value), shown(event.sum));
}

}  // namespace

const Event* currentEvent(const AppState& state) {
    if (!state.answer || state.answer->pathRun) return nullptr;
    const std::size_t passed = std::min(state.playback.event, state.eventCount());
    if (!state.playback.stepping || passed == 0) return nullptr;
    return &state.answer->record->events[passed - 1];
}

StepText describeStep(const AppState& state) {
    if (const PathEvent* event = currentPathEvent(state)) return describePathEvent(state, *event);
    const Event* event = currentEvent(state);
    if (!event) return {};
    constexpr double kDegrees = 180.0 / kPi;
    StepText text;
    text.where = say("depth {}", event->depth);
    const auto sample = [&] { text.where += say(", sample n = {} of {}", event->n, state.settings.samples); };
    switch (event->kind) {
        case EventKind::enter:
            text.what = "gatherLight begins: P and its normal N are known.";
            text.values = say("P = {}   on {}", vector(event->from), wallName(state, event->segment));
            break;
        case EventKind::light:
            describeLight(state, *event, text);
            break;
        case EventKind::sample:
            sample();
            text.what = "Step 1: draw an angle on the half-disk.";
            text.values = say("theta = {:.1f}\u00b0 from the tangent   pdf = {:.3f} per rad",
                              event->theta * kDegrees, event->pdfAngle);
            break;
        case EventKind::direction:
            sample();
            text.what = "Step 2: rotate it, so that up becomes N.";
            text.values = say("direction = {}", vector(event->direction));
            break;
        case EventKind::meet:
            sample();
            text.what = event->missed
                            ? std::string(tr("Step 3: cast the ray. It meets no wall."))
                            : say("Step 3: cast the ray. It meets {}.", wallName(state, event->segment));
            text.values =
                event->missed ? std::string(tr("the environment answers")) : say("at {}", vector(event->to));
            break;
        case EventKind::arrival:
            sample();
            text.what = "Step 3, done: the colour that came back along the ray.";
            text.values = say("sampleColor = {} W/(m rad)", shown(event->value));
            break;
        case EventKind::accumulate:
            sample();
            text.what = "Steps 4 and 5: weigh it like a light, and add it.";
            text.values = say("adds {}   sum so far = {}", shown(event->value), shown(event->sum));
            break;
        case EventKind::average:
            text.what = "Step 6: divide the sum by N.";
            text.values = say("mean = {} W/m", shown(event->value));
            break;
        case EventKind::leave:
            text.what = "All that arrives. Step 7, times albedo / 2, is castRay's.";
            text.values = say("E = {} W/m", shown(event->value));
            break;
    }
    text.what = tr(text.what);
    return text;
}

}  // namespace halfdisk
