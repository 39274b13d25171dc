#include "app/run_text.h"
#include "app/language.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"

namespace halfdisk {
namespace {

std::string wallName(const AppState& state, std::uint32_t segment) {
    return state.scene->scene.segmentNames[segment];
}

std::string place(Vec2 v) {
    // So that nothing is -0.000.
    const auto rounded = [](double x) { return std::round(1e3 * x) / 1e3 + 0.0; };
    return local(fmt::format("({:.3f}, {:.3f})", rounded(v.x), rounded(v.y)));
}

/// `throughput 0.8` or `power 0.05 W`.
std::string carried(const PathEvent& event) {
    return event.carried == Carried::radiance ? say("throughput {}", shown(event.throughput))
                                              : say("power {} W", shown(event.throughput));
}

/// P, or the eye of a pixel.
std::string sensorName(const AppState& state) {
    return std::string(pixelOf(*state.answer) ? tr("the eye") : "P");
}

std::string added(const AppState& state, const PathEvent& event) {
    const std::uint32_t N = state.answer->pathRun->divisor;
    if (N == 1) return say("adds {}   sum so far = {}", shown(event.value), shown(event.sum));
    return say("adds {}   sum so far = {}, / {} = {}", shown(event.value), shown(event.sum), N,
               shown(event.sum / static_cast<double>(N)));
}

/// Which path, as the run counts them.
std::string whichPath(const AppState& state, const PathEvent& event) {
    const bool fromP = event.carried == Carried::radiance;
    const Run run = state.answer->asked.run;
    if (run == Run::bidirectional)
        return event.kind == PathEventKind::joined ? say("pair {}, joined", event.path / 2 + 1)
               : fromP ? say("pair {}, from {}", event.path / 2 + 1, sensorName(state))
                       : say("pair {}, from the light", event.path / 2 + 1);
    if (run == Run::light && event.path == 0) return std::string(tr("straight from the lights"));
    if (run == Run::light) return say("path {}", event.path);
    if (run == Run::photonMap)
        return fromP ? say("the look from {}", sensorName(state)) : say("photon {}", event.path + 1);
    return say("path {}", event.path + 1);
}

/// The lamp, the sky, or a light that has no wall.
std::string lampName(const AppState& state, const PathEvent& event) {
    if (event.segment != kNoSegment) return wallName(state, event.segment);
    return std::string(tr(event.missed ? "a light infinitely far away" : "a light"));
}

std::string shareOf(const PathEvent& event) {
    if (event.weight == 1.0) return std::string(tr("It counts whole."));
    return say("This way of finding it counts {:.0f} %.", 100.0 * event.weight);
}

std::string started(const AppState& state, const PathEvent& event) {
    if (event.carried == Carried::radiance) return "A path sets out, against the light.";
    if (event.throughput == Rgb(0.0))
        return say("First what comes to {} straight from a light.", sensorName(state));
    if (event.segment == kNoSegment) return "A path of light sets out.";
    return say("A path of light sets out from {}.", wallName(state, event.segment));
}

std::string joinedHow(const AppState& state, const PathEvent& event) {
    const std::string_view way = tr(event.visible ? "the way is free" : "something is in the way");
    if (state.answer->asked.run == Run::light)
        return say("The wall is joined to {}: {}.", sensorName(state), way);
    const std::string strategy = say("Strategy s = {}, t = {}: ", event.s, event.t);
    if (event.s == 0)
        return strategy + (event.from == event.to
                               ? say("{}'s path met the lamp by itself.", sensorName(state))
                               : say("{}'s path met the sky by itself.", sensorName(state)));
    return strategy + say("{} from the light, {} from {}; {}.", event.s, event.t, sensorName(state), way);
}

std::string ended(Ending why) {
    switch (why) {
        case Ending::back:
            return "It met the black back of a wall: it ends.";
        case Ending::visitor:
        case Ending::absorbed:
            return "The wall sends nothing on: it ends.";
        case Ending::scatterings:
            return "It was scattered as often as maxDepth allows: it ends.";
        case Ending::speculars:
            return "Too many mirrors and glass skins in a row: it is cut off.";
        case Ending::roulette:
            return "Russian roulette ends it; survivors carry its share.";
    }
    return {};
}

}  // namespace

const PathEvent* currentPathEvent(const AppState& state) {
    if (!state.answer || !state.answer->pathRun) return nullptr;
    const std::size_t passed = std::min(state.playback.event, state.eventCount());
    if (!state.playback.stepping || passed == 0) return nullptr;
    return &state.answer->pathRun->record.events[passed - 1];
}

StepText describePathEvent(const AppState& state, const PathEvent& event) {
    StepText text;
    text.where = whichPath(state, event);
    if (event.vertex > 0) text.where += say(", wall {}", event.vertex);
    switch (event.kind) {
        case PathEventKind::start:
            text.what = started(state, event);
            text.values = say("at {}   {}", place(event.from), carried(event));
            break;
        case PathEventKind::fly:
            text.what = event.missed ? "It flies out of the scene." : "It flies to the next wall.";
            text.values = event.missed ? carried(event) : say("to {}   {}", place(event.to), carried(event));
            break;
        case PathEventKind::arrive:
            text.what = say("It arrives at {}.", wallName(state, event.segment));
            text.values = carried(event);
            break;
        case PathEventKind::escape:
            text.what = event.carried == Carried::radiance ? "It met no wall: the sky answers."
                                                           : "It met no wall: this light is lost.";
            text.values = carried(event);
            break;
        case PathEventKind::depart:
            text.what = event.delta ? "It goes on where mirror or glass sends it."
                                    : "It goes on: a direction is drawn as the wall scatters.";
            text.values = event.delta ? say("times {}", shown(event.throughput))
                                      : say("pdf = {:.3f} per rad   BRDF cos / pdf = {}", event.pdfAngle,
                                            shown(event.throughput));
            break;
        case PathEventKind::end:
            text.what = ended(event.ending);
            text.values = say("sum so far = {}", shown(event.sum));
            break;
        case PathEventKind::met:
            text.what =
                say("It met {} by chance. {}",
                    event.segment == kNoSegment ? std::string(tr("the sky")) : wallName(state, event.segment),
                    shareOf(event));
            text.values = added(state, event);
            break;
        case PathEventKind::asked:
            text.what = event.visible
                            ? say("{} is asked; the way is free. {}", lampName(state, event), shareOf(event))
                            : say("{} is asked: nothing arrives from there.", lampName(state, event));
            text.values = added(state, event);
            break;
        case PathEventKind::joined:
            text.what = joinedHow(state, event);
            text.values = event.visible ? say("weight {:.3g}   {}", event.weight, added(state, event))
                                        : added(state, event);
            break;
        case PathEventKind::kept:
            text.what = say("The photon is kept on {}.", wallName(state, event.segment));
            text.values = carried(event);
            break;
        case PathEventKind::lookedUp:
            text.what = event.photons == 1
                            ? say("Look-up: 1 photon within {:g} m of here.", event.radius)
                            : say("Look-up: {} photons within {:g} m of here.", event.photons, event.radius);
            text.values = added(state, event);
            break;
    }
    text.what = tr(text.what);
    return text;
}

}  // namespace halfdisk
