#include "app/doable.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/fuzzy.h"
#include "app/key_help.h"
#include "app/language.h"
#include "app/offer.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostWalls = 64;  // of a scene, by name

/// As the key takes it: after the last one the first.
void nextLesson(Offer& offer) {
    const AppState& state = offer.state;
    if (state.lessons.empty()) return;
    const LessonEntry& next = state.lessons[nextLessonIndex(state)];
    offer.addIf(next.error.empty(), say("Next lesson: {}", next.title), keyOf(KeyRow::nextLesson),
                GoTo{next.slug, 0});
}

void lessonNow(Offer& offer) {
    const AppState& state = offer.state;
    if (!state.lesson) return;
    offer.addIf(state.step + 1 < state.lesson->steps.size(), "Next step", keyOf(KeyRow::nextStep),
                NextStep{});
    offer.addIf(state.step > 0, "Previous step", keyOf(KeyRow::previousStep), PreviousStep{});
    offer.add("Reset the step", keyOf(KeyRow::reset), ResetStep{});
    offer.addIf(state.currentStep()->question && !state.answerShown, "Show the answer", keyOf(KeyRow::answer),
                RevealAnswer{});
    offer.add(state.unlockAll ? "Lock the controls again" : "Unlock all controls", keyOf(KeyRow::unlock),
              UnlockAll{!state.unlockAll});
}

void run(Offer& offer) {
    const std::size_t count = offer.state.eventCount();
    if (count == 0) return;
    const Playback& playback = offer.state.playback;
    offer.add(playback.playing ? "Pause" : "Play the run step by step", keyOf(KeyRow::play), TogglePlay{});
    offer.add("One step of the run forward", keyOf(KeyRow::alongRun), StepEvents{1});
    offer.add("One step of the run back", keyOf(KeyRow::alongRun, 1), StepEvents{-1});
    offer.add("First step of the run", keyOf(KeyRow::ends), SetEvent{0});
    offer.add("Last step of the run", keyOf(KeyRow::ends, 1), SetEvent{count});
    for (const Named<Run>& other : kRuns)
        offer.addIf(offer.state.isUnlocked(Control::step) && other.value != offer.state.run,
                    say("Run of {}", other.name), {}, SetRun{other.value});
    offer.addIf(playback.stepping, "Show the whole run", keyOf(KeyRow::wholeRun), ShowWholeRun{});
}

void screen(Offer& offer) {
    const AppState& state = offer.state;
    offer.add("Copy all that is seen as a text", keyOf(KeyRow::share), CopyState{});
    offer.add("Export what is seen", keyOf(KeyRow::exporting), ExportSeen{});
    offer.add("Fit the scene into the canvas", keyOf(KeyRow::fit), FitCamera{});
    offer.add("Everything larger", keyOf(KeyRow::size), SetUiScale{state.uiScale * 1.25f});
    offer.add("Everything smaller", keyOf(KeyRow::size, 1), SetUiScale{state.uiScale / 1.25f});
    offer.addIf(state.uiScale != 1.0f, "Letters as they were", "Ctrl 0", SetUiScale{1.0f});
    offer.add(state.canvasHidden ? "Low screen: the canvas" : "Low screen: code or plot for the canvas",
              keyOf(KeyRow::panes, 1), HideCanvas{!state.canvasHidden});
    for (const auto& [pane, name] : {std::pair{Pane::lesson, "Small screen: the lesson"},
                                     std::pair{Pane::stage, "Small screen: the stage"},
                                     std::pair{Pane::controls, "Small screen: the controls"}})
        offer.addIf(state.pane != pane, name, {}, ShowPane{pane});
    offer.addIf(!state.banner.empty(), "Dismiss the message", "Escape", DismissBanner{});
    offer.add("Help: all keys", "F1", ToggleHelp{});
}

void lessons(Offer& offer) {
    for (const LessonEntry& entry : offer.state.lessons) {
        if (!entry.error.empty()) continue;
        offer.add(say("Lesson {}: {}", entry.number, entry.title), {}, GoTo{entry.slug, 0});
        for (std::size_t step = 0; step < entry.stepTitles.size(); ++step)
            offer.add(fmt::format("{}.{} {} \u203a {}", entry.number, step + 1, entry.title,
                                  entry.stepTitles[step]),
                      {}, GoTo{entry.slug, step});
    }
    for (const std::filesystem::path& file : offer.state.recent)
        offer.add(say("Open {}", file.string()), {}, OpenFile{file});
}

/// P on other walls, which only the pointer could reach else.
void walls(Offer& offer) {
    const AppState& state = offer.state;
    if (!state.isUnlocked(Control::point)) return;
    const std::vector<std::string>& names = state.scene->scene.segmentNames;
    for (std::uint32_t i = 0; i < std::min(names.size(), kMostWalls); ++i)
        offer.addIf(i != state.at.segment, say("P onto {}", names[i]), {}, MovePoint{{i, 0.5}});
}

}  // namespace

std::vector<Doable> doables(const AppState& state) {
    Offer offer{state, {}};
    lessonNow(offer);
    nextLesson(offer);
    offerEditing(offer);
    run(offer);
    offerSettings(offer);
    offerViews(offer);
    offerEstimators(offer);
    screen(offer);
    lessons(offer);
    walls(offer);
    offerPixels(offer);
    return std::move(offer.all);
}

std::vector<Doable> found(std::vector<Doable> all, std::string_view query) {
    struct Rank {
        int score;
        std::size_t length, index;
    };
    std::vector<Rank> ranks;
    const FuzzyQuery wanted(query);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const auto score = fuzzyScore(wanted, all[i].name))
            ranks.push_back({*score, query.empty() ? 0 : all[i].name.size(), i});
    std::sort(ranks.begin(), ranks.end(), [](const Rank& a, const Rank& b) {
        return std::tie(b.score, a.length, a.index) < std::tie(a.score, b.length, b.index);
    });
    std::vector<Doable> best;
    for (const Rank& rank : ranks) best.push_back(std::move(all[rank.index]));
    return best;
}

}  // namespace halfdisk
