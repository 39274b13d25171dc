#include "app/doable.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/edit_commands.h"
#include "app/fuzzy.h"
#include "app/key_help.h"
#include "app/picture_stages.h"
#include "lessons/scene_keys.h"

namespace halfdisk {
namespace {

constexpr std::size_t kMostWalls = 64, kMostThings = 200;  // of a scene, by name

/// Adds what may be done to a list.
struct Offer {
    const AppState& state;
    std::vector<Doable> all;

    void add(std::string name, std::string_view key, Command command) {
        if (!isForbidden(state, command)) all.push_back({std::move(name), key, std::move(command)});
    }
    void addIf(bool there, std::string name, std::string_view key, Command command) {
        if (there) add(std::move(name), key, std::move(command));
    }
};

/// As the key takes it: after the last one the first.
void nextLesson(Offer& offer) {
    const AppState& state = offer.state;
    if (state.lessons.empty()) return;
    const LessonEntry& next = state.lessons[nextLessonIndex(state)];
    offer.addIf(next.error.empty(), fmt::format("Next lesson: {}", next.title), keyOf(KeyRow::nextLesson),
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
    offer.add(playback.playing ? "Pause" : "Play castRay step by step", keyOf(KeyRow::play), TogglePlay{});
    offer.add("One step of castRay forward", keyOf(KeyRow::alongRun), StepEvents{1});
    offer.add("One step of castRay back", keyOf(KeyRow::alongRun, 1), StepEvents{-1});
    offer.add("First step of castRay", keyOf(KeyRow::ends), SetEvent{0});
    offer.add("Last step of castRay", keyOf(KeyRow::ends, 1), SetEvent{count});
    offer.addIf(playback.stepping, "Show the whole run", keyOf(KeyRow::wholeRun), ShowWholeRun{});
}

void editing(Offer& offer) {
    const AppState& state = offer.state;
    const Editing& editing = state.editing;
    offer.add(editing.on ? "Done with changing the scene" : "Edit the scene", keyOf(KeyRow::edit),
              SetEditing{!editing.on});
    offer.add("Open a file ...", keyOf(KeyRow::files, 1), ShowFiles{true});
    if (!editing.on) return;
    offer.addIf(!editing.history.past.empty(), "Undo", keyOf(KeyRow::history), Undo{});
    offer.addIf(!editing.history.future.empty(), "Redo", keyOf(KeyRow::history, 1), Redo{});
    offer.add(fmt::format("Save the scene as {}", editing.path), keyOf(KeyRow::files),
              SaveScene{editing.path});
    for (const Named<EditAct>& act : kEditActs) {
        const std::string_view key = act.value == EditAct::copy     ? keyOf(KeyRow::selected)
                                     : act.value == EditAct::remove ? keyOf(KeyRow::selected, 1)
                                                                    : std::string_view();
        offer.addIf(serves(act.value, editing.selected), fmt::format("{} what is selected", act.name), key,
                    ActOnSelected{act.value});
    }
    for (const Named<Tool>& tool : kTools)
        offer.addIf(editing.tool != tool.value, fmt::format("Tool: {}", tool.name), {}, SetTool{tool.value});
    // Without a pointer: in the middle of what is seen.
    const Vec2 middle = state.camera.center;
    const double half = 60.0 / state.camera.pixelsPerMeter;
    for (const Named<Tool>& tool : kTools) {
        const Vec2 way(half, tool.value == Tool::box ? half : 0.0);
        offer.addIf(tool.value != Tool::select, fmt::format("Add in the middle: {}", tool.name), {},
                    AddNew{tool.value, middle - way, middle + way});
    }
    offer.add(editing.snap ? "Do not snap" : "Snap to ends and grid", {}, SetSnap{!editing.snap});
    const SceneDescription& scene = state.scene->description;
    const Selection things = everything(scene);
    offer.addIf(things.size() > editing.selected.size(), "Select all", keyOf(KeyRow::choosing),
                SelectThings{things});
    offer.addIf(!editing.selected.empty(), "Select nothing", state.banner.empty() ? "Escape" : "",
                SelectThings{});
    if (things.size() <= kMostThings) {
        const std::vector<std::string> names = namesOf(scene);
        for (std::size_t i = 0; i < things.size(); ++i)
            offer.addIf(editing.selected.single() != things.things[i], fmt::format("Select {}", names[i]), {},
                        SelectThings{things.things[i]});
    }
    if (!serves(EditAct::flip, editing.selected)) return;  // no shape
    offer.add("Material: default", {}, SetMaterial{});
    for (const NamedMaterial& material : scene.materials)
        if (material.name != kDefaultMaterial)
            offer.add(fmt::format("Material: {}", material.name), {}, SetMaterial{material.name});
    for (const Named<std::size_t>& type : kMaterialTypes)
        offer.add(fmt::format("New material: {}", type.name), {}, AddMaterial{type.value});
}

template <class Enum, std::size_t Count>
void choices(Offer& offer, std::string_view what, Enum Settings::*value,
             const std::array<Named<Enum>, Count>& table, std::string_view key) {
    Enum next = table[0].value;
    for (std::size_t i = 0; i < Count; ++i)
        if (table[i].value == offer.state.settings.*value) next = table[(i + 1) % Count].value;
    for (const Named<Enum>& choice : table) {
        Settings settings = offer.state.settings;
        if (settings.*value == choice.value) continue;
        settings.*value = choice.value;
        offer.add(fmt::format("{}: {}", what, choice.name), choice.value == next ? key : "",
                  SetSettings{settings});
    }
}

void settings(Offer& offer) {
    const AppState& state = offer.state;
    const Settings& now = state.settings;
    const auto change = [&](bool there, std::string name, std::string_view key, const auto& how) {
        Settings settings = now;
        how(settings);
        offer.addIf(there, std::move(name), key, SetSettings{settings});
    };
    if (state.isUnlocked(Control::samples)) {
        change(now.samples < kMostLessonSamples, "Double N", keyOf(KeyRow::samples),
               [](Settings& s) { s.samples = std::min<std::uint32_t>(2 * s.samples, kMostLessonSamples); });
        change(now.samples > 1, "Halve N", keyOf(KeyRow::samples, 1),
               [](Settings& s) { s.samples = std::max(s.samples / 2, 1u); });
    }
    if (state.isUnlocked(Control::depth)) {
        change(now.maxDepth < kMostLessonDepth, "One scattering more", keyOf(KeyRow::depth),
               [](Settings& s) { ++s.maxDepth; });
        change(now.maxDepth > 0, "One scattering fewer", keyOf(KeyRow::depth, 1),
               [](Settings& s) { --s.maxDepth; });
    }
    if (state.isUnlocked(Control::seed))
        change(true, "Next seed", keyOf(KeyRow::seed), [](Settings& s) { ++s.seed; });
    if (state.isUnlocked(Control::sampler))
        choices(offer, "Sampler", &Settings::sampler, kSamplers, keyOf(KeyRow::samplerEmitters));
    if (state.isUnlocked(Control::emitters))
        choices(offer, "Emitters", &Settings::emitters, kEmitters, keyOf(KeyRow::samplerEmitters, 1));
    if (!state.isUnlocked(Control::defects)) return;
    constexpr std::string_view kDigits = "1234567";
    static_assert(kDigits.size() == kDefects.size());
    for (std::size_t i = 0; i < kDefects.size(); ++i) {
        const Defect defect = kDefects[i].value;
        const bool on = now.defects.has(defect);
        change(true, fmt::format("Defect {}: {}", kDefects[i].name, on ? "off" : "on"), kDigits.substr(i, 1),
               [&](Settings& s) { s.defects.set(defect, !on); });
    }
    const bool printed = now.defects == DefectSet::all();
    change(!printed, "All defects: as printed", keyOf(KeyRow::defects, 1),
           [](Settings& s) { s.defects = DefectSet::all(); });
    change(now.defects != DefectSet{}, "No defects", printed ? keyOf(KeyRow::defects, 1) : "",
           [](Settings& s) { s.defects = {}; });
}

/// Whether keys or switches change this view now.
bool isOffered(const AppState& state, View view) {
    if (state.rules.hidden.has(view)) return false;
    if (view == View::grid || view == View::eye || view == View::field) return true;  // keys do
    const Step* step = state.currentStep();
    const bool ofStep = step && (step->show & kPictureSet) != ViewSet{} && kPictureSet.has(view);
    return !state.rules.kiosk && (!step || state.unlockAll || ofStep);
}

void views(Offer& offer) {
    for (const Named<View>& view : kViews) {
        if (!isOffered(offer.state, view.value)) continue;
        const std::string_view key = view.value == View::grid    ? keyOf(KeyRow::grid)
                                     : view.value == View::eye   ? keyOf(KeyRow::pictures)
                                     : view.value == View::field ? keyOf(KeyRow::pictures, 1)
                                                                 : std::string_view();
        const bool on = offer.state.shows(view.value);
        offer.add(fmt::format("{} {}: {}", on ? "Hide" : "Show", view.name, view.meaning), key,
                  SetView{view.value, !on});
    }
}

/// Parameters with named choices; the others are numbers, which are typed.
void paramChoices(Offer& offer, const Makers& now) {
    const EstimatorInfo& info = *findEstimator(now.first->estimator);
    for (std::size_t i = 0; i < info.params.size(); ++i)
        for (std::size_t k = 0; k < info.params[i].choices.size(); ++k) {
            Makers makers = now;
            makers.first->params[i] = static_cast<double>(k);
            offer.addIf(now.first->params[i] != static_cast<double>(k),
                        fmt::format("{}: {} {}", info.id, info.params[i].name, info.params[i].choices[k]), {},
                        SetMakers{makers});
        }
}

void estimatorChoices(Offer& offer) {
    const AppState& state = offer.state;
    const std::optional<View> view = state.mainPicture();
    if (!view) return;
    const Makers now{state.makers.first ? *state.makers.first : usualMaker(*view), state.makers.second};
    if (state.isUnlocked(Control::params)) paramChoices(offer, now);
    if (!state.isUnlocked(Control::estimator)) return;
    for (const EstimatorInfo* info : estimators())
        offer.addIf(now.first->estimator != info->id, fmt::format("Estimator: {}", info->id), {},
                    SetMakers{{makerOf(info->id), now.second}});
    offer.add(now.second ? "Compare: one estimator again" : "Compare with a second estimator", {},
              SetMakers{{now.first, now.second ? std::nullopt : std::optional(usualMaker(*view))}});
    if (!now.second) return;
    for (const EstimatorInfo* info : estimators())
        offer.addIf(now.second->estimator != info->id, fmt::format("Second estimator: {}", info->id), {},
                    SetMakers{{now.first, makerOf(info->id)}});
}

void screen(Offer& offer) {
    const AppState& state = offer.state;
    offer.add("Copy all that is seen as a text", keyOf(KeyRow::share), CopyState{});
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
        offer.add(fmt::format("Lesson {}: {}", entry.number, entry.title), {}, GoTo{entry.slug, 0});
        for (std::size_t step = 0; step < entry.stepTitles.size(); ++step)
            offer.add(fmt::format("{}.{} {} \u203a {}", entry.number, step + 1, entry.title,
                                  entry.stepTitles[step]),
                      {}, GoTo{entry.slug, step});
    }
    for (const std::filesystem::path& file : offer.state.recent)
        offer.add(fmt::format("Open {}", file.string()), {}, OpenFile{file});
}

/// P on other walls, which only the pointer could reach else.
void walls(Offer& offer) {
    const AppState& state = offer.state;
    if (!state.isUnlocked(Control::point)) return;
    const std::vector<std::string>& names = state.scene->scene.segmentNames;
    for (std::uint32_t i = 0; i < std::min(names.size(), kMostWalls); ++i)
        offer.addIf(i != state.at.segment, fmt::format("P onto {}", names[i]), {}, MovePoint{{i, 0.5}});
}

}  // namespace

std::vector<Doable> doables(const AppState& state) {
    Offer offer{state, {}};
    lessonNow(offer);
    nextLesson(offer);
    editing(offer);
    run(offer);
    settings(offer);
    views(offer);
    estimatorChoices(offer);
    screen(offer);
    lessons(offer);
    walls(offer);
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
