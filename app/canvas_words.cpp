// What does the canvas show, in words? Its layers, where the rays go, and what they bring.
#include "app/canvas_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/scene_words.h"

namespace halfdisk {
namespace {

/// Where the rays of P's own samples end, and what they bring.
std::string raysWords(const AppState& state) {
    if (!state.answer || !state.answer->record) return {};
    const Record& record = *state.answer->record;
    const std::size_t end =
        state.playback.stepping ? std::min(state.playback.event, record.events.size()) : record.events.size();
    std::map<std::string, std::size_t> met;
    std::size_t rays = 0, dark = 0, shadowRays = 0, clear = 0;
    const Event* brightest = nullptr;
    for (const std::uint32_t i : state.answer->summary.atP) {
        if (i >= end) break;
        const Event& event = record.events[i];
        if (event.kind == EventKind::light) {
            ++shadowRays;
            clear += event.visible ? 1 : 0;
        }
        if (event.kind != EventKind::arrival) continue;
        ++rays;
        dark += gray(event.value) == 0.0 ? 1 : 0;
        ++met[event.missed ? std::string(tr("no wall")) : state.scene->scene.segmentNames[event.segment]];
        if (!brightest || gray(event.value) > gray(brightest->value)) brightest = &event;
    }
    std::string words;
    if (rays > 0) {
        std::vector<std::pair<std::string, std::size_t>> most(met.begin(), met.end());
        std::stable_sort(most.begin(), most.end(),
                         [](const auto& a, const auto& b) { return a.second > b.second; });
        constexpr std::size_t kMostWalls = 8;
        words = say("Rays from P: {}. They meet", rays);
        for (std::size_t i = 0; i < std::min(most.size(), kMostWalls); ++i)
            words += fmt::format("{} {} ({})", i > 0 ? "," : "", most[i].first, most[i].second);
        if (most.size() > kMostWalls) words += say(" and {} other walls", most.size() - kMostWalls);
        words += say(". Of these bring nothing: {}.", dark);
        if (gray(brightest->value) > 0.0)
            words += say(" The brightest brings {} W/(m rad) along the direction {}.",
                         shown(brightest->value), placeWords(brightest->direction));
    }
    if (shadowRays > 0)
        words += say("{}Shadow rays to lights: {}; of these free: {}.", words.empty() ? "" : "\n", shadowRays,
                     clear);
    return words;
}

}  // namespace

std::string canvasWords(const AppState& state) {
    std::string words(tr("The scene with its walls and lights"));
    const bool paths = state.answer && state.answer->pathRun;
    if (state.shows(View::halfdisk)) words += tr(", the half-disk over P");
    if (state.shows(View::rays)) words += tr(paths ? ", the paths of the run" : ", the rays of P's samples");
    if (state.shows(View::tree)) words += tr(", the rays of the recursion");
    if (state.shows(View::field)) words += tr(", the field of light behind it");
    if (state.shows(View::paths)) words += tr(", ways that light takes");
    if (state.shows(View::grid)) words += tr(", a grid");
    words += '.';
    const bool tree = state.shows(View::tree) && state.answer && state.answer->tree;
    if (tree && state.answer->tree->lines < state.answer->summary.deeperCount)
        words += say("\nOf {} deeper rays the first {} are drawn, as a cloud.",
                     state.answer->summary.deeperCount, state.answer->tree->lines);
    else if (tree)
        words += say("\nAll {} deeper rays are drawn, as a cloud.", state.answer->tree->lines);
    const std::string rays = state.shows(View::rays) && !paths ? raysWords(state) : std::string();
    if (!rays.empty()) words += '\n';
    words += rays;
    if (state.shows(View::paths) && state.answer && state.answer->ways) {
        words +=
            say("\n{} paths of light were followed; all are drawn as a cloud, the first {} as lines",
                state.answer->ways->size(), std::min<std::size_t>(kWaysDrawn, state.answer->ways->size()));
        if (state.answer->throughPupil)
            words += say("; {} pass the eye's pupil", *state.answer->throughPupil);
        words += '.';
    }
    return words;
}

}  // namespace halfdisk
