#include "app/commands.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "app/edit_commands.h"
#include "app/goal_check.h"
#include "app/opening.h"
#include "app/share_text.h"
#include "core/overload.h"

namespace halfdisk {

Command::Command(const Command& other) = default;
Command::Command(Command&& other) noexcept = default;
Command& Command::operator=(const Command& other) = default;
Command& Command::operator=(Command&& other) noexcept = default;
Command::~Command() = default;
namespace {

void stepEvents(AppState& state, int by) {
    const std::size_t count = state.eventCount();
    Playback& playback = state.playback;
    if (!playback.stepping) {  // begin at the end that is nearer to where the step goes
        playback.stepping = true;
        playback.event = by > 0 ? 0 : count;
    }
    const auto moved = static_cast<std::ptrdiff_t>(std::min(playback.event, count)) + by;
    playback.event =
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(moved, 0, static_cast<std::ptrdiff_t>(count)));
}

void jumpToLine(AppState& state, int line) {
    state.chosenLine = line;
    const std::size_t count = state.eventCount();
    if (count == 0 || state.answer->pathRun) return;
    const std::size_t start = state.playback.stepping ? state.playback.event : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = (start + i) % count;
        if (listingLine(state.answer->record->events[k].kind) != line) continue;
        state.playback = {true, k + 1, false, 0.0f};
        return;
    }
}

void jumpToSource(AppState& state, const JumpToSource& jump) {
    const std::size_t count = state.eventCount();
    if (!state.answer || !state.answer->pathRun) return;
    const std::size_t start = state.playback.stepping ? state.playback.event : 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t k = (start + i) % count;
        const SourceLine& where = state.answer->pathRun->record.events[k].where;
        if (!where.file.ends_with(jump.from.file) || where.line < jump.from.line ||
            where.line >= jump.to.line)
            continue;
        state.playback = {true, k + 1, false, 0.0f};
        return;
    }
}

/// The list comes with it, and goes again where the step has none.
void pinPixel(AppState& state, const PinPixel& pin) {
    const Side side = pin.pixel && state.makers.second ? pin.side : Side::first;
    if (pin.pixel == state.pinnedPixel && side == state.pinnedSide) return;
    if (pin.pixel && !canPin(state, *pin.pixel)) return;
    const bool otherStrip = pin.pixel && (!state.pinnedPixel || side != state.pinnedSide);
    state.pinnedPixel = pin.pixel;
    state.pinnedSide = side;
    // A strip that is looked into tells its own run; within it another one may be chosen.
    if (otherStrip && state.makers.second && state.run != Run::castRay)
        if (const auto& maker = state.pinnedMaker())
            if (const auto own = valueOf(kRuns, std::string_view(maker->estimator))) state.run = *own;
    state.sampleRange.reset();
    const Step* step = state.currentStep();
    const bool listed = !step || state.unlockAll || step->show.has(View::samples);
    if (pin.pixel || !listed)
        state.show.set(View::samples, pin.pixel && !state.rules.hidden.has(View::samples));
    askAnew(state);
}

void setView(AppState& state, const SetView& set) {
    if (set.on && state.rules.hidden.has(set.view)) return;
    // Also the cloud of the recursion's rays is made only where it is seen.
    const bool picture = kPictureSet.has(set.view) || kInstrumentSet.has(set.view) || set.view == View::tree;
    if (picture && set.on && !state.shows(set.view)) ++state.questionId;  // the run and its playback stay
    if (set.view == View::eye) state.eyePixel.reset();
    if (set.view == View::eye && !set.on) pinPixel(state, {});
    state.show.set(set.view, set.on);
}

void drawCurve(AppState& state, const DrawCurve& stroke) {
    for (const double number : {stroke.fromTheta, stroke.toTheta, stroke.from, stroke.to})
        if (!std::isfinite(number)) return;
    state.drawing = true;
    if (state.drawn.empty()) state.drawn.assign(kDrawnBins, -1.0f);
    const auto binOf = [](double theta) {
        return static_cast<int>(std::clamp(theta / kPi * kDrawnBins, 0.0, kDrawnBins - 1.0));
    };
    const int first = binOf(stroke.fromTheta), last = binOf(stroke.toTheta), by = last < first ? -1 : 1;
    for (int bin = first;; bin += by) {
        const double t = last == first ? 1.0 : static_cast<double>(bin - first) / (last - first);
        const double value = stroke.from + t * (stroke.to - stroke.from);
        constexpr double kMost = 1e30;
        state.drawn[static_cast<std::size_t>(bin)] = static_cast<float>(std::clamp(value, 0.0, kMost));
        if (bin == last) return;
    }
}

/// Does all of `change` or, if it throws, none of it.
void attempt(AppState& state, const auto& change) {
    AppState next = state;
    change(next);
    if (next.editing.on) nameFile(next);  // what is saved now shall not replace another scene's file
    state = std::move(next);
}

void applyUnchecked(AppState& state, const Command& command) {
    if (isForbidden(state, command)) return;
    std::visit(
        Overload{
            [&](const GoTo& c) {
                attempt(state, [&](AppState& next) {
                    next.sceneOverride.clear();
                    goTo(next, {c.lesson, static_cast<int>(c.step) + 1});
                });
            },
            [&](NextStep) {
                if (state.lesson && state.step + 1 < state.lesson->steps.size())
                    enterStep(state, state.step + 1);
            },
            [&](PreviousStep) {
                if (state.lesson && state.step > 0) enterStep(state, state.step - 1);
            },
            [&](ResetStep) {
                if (state.lesson) enterStep(state, state.step);
                state.fitCamera = true;
            },
            [&](const OpenScene& c) {
                attempt(state, [&](AppState& next) { showSceneAlone(next, c.file); });
            },
            [&](const OpenFile& c) {
                attempt(state, [&](AppState& next) {
                    openAny(next, c.file);
                    remember(next.recent, c.file);
                    next.files.shown = false;
                });
            },
            [&](const OpenShared& c) { attempt(state, [&](AppState& next) { showShared(next, c.text); }); },
            [&](CopyState) { state.toClipboard = shareText(state); },
            [&](Reload) { attempt(state, reload); },
            [&](const SetSettings& c) {
                if (state.settings == c.settings) return;
                state.settings = c.settings;
                askAnew(state);
            },
            [&](const DrawCurve& c) { drawCurve(state, c); },
            [&](EndStroke) { state.drawing = false; },
            [&](LightTopic c) { state.topic = c.topic; },
            [&](const SetLanguage& c) { attempt(state, [&](AppState& next) { setLanguage(next, c.code); }); },
            [&](SetFieldScale c) { state.scale = c.scale; },
            [&](const SetInstruments& c) {
                const InstrumentSettings settings = withinLimits(c.settings);
                if (state.instruments == settings) return;
                // What is only wished for of the trade leaves the run and its playback as they are.
                InstrumentSettings measured = settings;
                measured.wish = state.instruments.wish;
                measured.wishedError = state.instruments.wishedError;
                measured.wishedMilliseconds = state.instruments.wishedMilliseconds;
                measured.tradeCost = state.instruments.tradeCost;
                const bool anew = !(measured == state.instruments);
                state.instruments = settings;
                if (anew) return askAnew(state);
                if (state.shows(View::trade)) ++state.questionId;
            },
            [&](const PickTrade& c) {
                if (c.cell && state.makers.first == c.maker) return;
                if (!state.pickedTrade) state.beforePick = state.makers.first;
                state.makers.first = c.cell ? std::optional(c.maker) : state.beforePick;
                state.pickedTrade = c.cell;
                ++state.questionId;  // the run and its playback stay
            },
            [&](ShowSample c) { state.shownSample = c.event; },
            [&](const FilterSamples& c) { state.sampleRange = c.range; },
            [&](SetRun c) {
                if (state.run == c.run) return;
                state.run = c.run;
                askAnew(state);
            },
            [&](SortSamples c) { state.largestFirst = c.largestFirst; },
            [&](const SetMakers& c) {
                if (state.makers == c.makers) return;
                const Run before = state.shownRun();
                state.makers = c.makers;
                if (!state.makers.second) state.pinnedSide = Side::first;
                if (state.shownRun() != before) askAnew(state);
                ++state.questionId;  // the run and its playback stay
            },
            [&](WeighStrategies c) { state.strategiesAlone = c.alone; },
            [&](SetSplit c) { state.split = std::clamp(c.split, 0.0f, 1.0f); },
            [&](SetEditing c) { setEditing(state, c.on); },
            [&](SetTool c) { state.editing.tool = c.tool; },
            [&](SetSnap c) { state.editing.snap = c.on; },
            [&](const SelectThings& c) {
                state.editing.selected = existing(state.scene->description, c.things);
                state.editing.message.clear();
            },
            [&](ActOnSelected c) { actOnSelected(state, c.act); },
            [&](const AddNew& c) { addNew(state, c); },
            [&](const MoveSelected& c) { moveSelected(state, c); },
            [&](const SetMaterial& c) { setMaterialOfSelected(state, c.name); },
            [&](AddMaterial c) { addMaterialToSelected(state, c.kind); },
            [&](const ChooseSkyImage& c) { chooseSkyImage(state, c.image); },
            [&](const BeginGesture& c) { beginGesture(state, c); },
            [&](const EditScene& c) { editScene(state, c); },
            [&](Undo) { undo(state); },
            [&](Redo) { redo(state); },
            [&](const SetScenePath& c) {
                state.editing.path = c.path;
                state.editing.confirmed = false;
            },
            [&](const SaveScene& c) { saveEdited(state, c); },
            [&](const MovePoint& c) {
                if (state.at == c.at || c.at.segment >= state.scene->scene.segments.size()) return;
                state.at = {c.at.segment, std::clamp(c.at.t, 0.0, 1.0)};
                pinPixel(state, {});  // who moves P wants to see it
                askAnew(state);
            },
            [&](SetEvent c) {
                state.playback = {true, std::min(c.event, state.eventCount()), false, 0.0f};
            },
            [&](StepEvents c) { stepEvents(state, c.by); },
            [&](JumpToLine c) { jumpToLine(state, c.line); },
            [&](const JumpToSource& c) { jumpToSource(state, c); },
            [&](ShowWholeRun) { state.playback = {}; },
            [&](SetSpeed c) { state.speed = c.speed; },
            [&](TogglePlay) {
                Playback& playback = state.playback;
                playback.playing = !playback.playing;
                if (playback.playing && (!playback.stepping || playback.event >= state.eventCount()))
                    playback.event = 0;
                playback.stepping = true;
            },
            [&](const SetCamera& c) {
                state.camera = c.camera;
                state.fitCamera = c.fitted;
            },
            [&](FitCamera) { state.fitCamera = true; },
            [&](ScrolledTo c) { state.litLine = c.line; },
            [&](SetGrip c) {
                state.grip = c.grip;
                if (c.grip != Grip::edit && c.grip != Grip::band) state.editing.start.reset();
            },
            [&](SetUiScale c) { state.uiScale = std::clamp(c.scale, 0.5f, 4.0f); },
            [&](SetView c) { setView(state, c); },
            [&](LookAlong c) { state.eyePixel = c.pixel; },
            [&](const PinPixel& c) { pinPixel(state, c); },
            [&](ShowPane c) { state.pane = c.pane; },
            [&](HideCanvas c) { state.canvasHidden = c.hidden; },
            [&](RevealAnswer) { state.answerShown = true; },
            [&](UnlockAll c) { state.unlockAll = c.on; },
            [&](ToggleHelp) { state.helpShown = !state.helpShown; },
            [&](ShowPalette c) {
                state.palette = {c.shown, {}, 0};
            },
            [&](const SetQuery& c) {
                state.palette.query = c.query;
                state.palette.selected = 0;
            },
            [&](SelectEntry c) { state.palette.selected = c.index; },
            [&](ShowFiles c) {
                state.files.shown = c.shown;
                if (c.shown) openChooser(state.files, usualFolder(state), state.recent);
            },
            [&](const SetFilePath& c) { setChooserPath(state.files, c.path); },
            [&](SelectFile c) { state.files.selected = c.index; },
            [&](DismissBanner) { state.banner.clear(); },
            [&](ExportSeen) {
                state.exportWished = true;
                state.notice.clear();
            },
            [&](DismissNotice) {
                state.exportWished = false;
                state.notice.clear();
            },
        },
        command);
}

}  // namespace

bool canPin(const AppState& state, std::uint32_t pixel) {
    return state.shows(View::eye) && state.scene->scene.eye && pixel < kEyeStripPixels;
}

bool isForbidden(const AppState& state, const Command& command) {
    if (!state.rules.kiosk) return false;
    const auto isAny = [&]<class... Forbidden>(std::type_identity<Forbidden>...) {
        return (... || std::holds_alternative<Forbidden>(command));
    };
    if (const auto* go = std::get_if<GoTo>(&command))
        return !state.lesson || go->lesson != state.lesson->slug;
    if (const auto* files = std::get_if<ShowFiles>(&command)) return files->shown;
    return isAny(std::type_identity<OpenScene>{}, std::type_identity<OpenShared>{},
                 std::type_identity<OpenFile>{}, std::type_identity<SetEditing>{},
                 std::type_identity<EditScene>{}, std::type_identity<SaveScene>{},
                 std::type_identity<ActOnSelected>{}, std::type_identity<AddNew>{},
                 std::type_identity<MoveSelected>{}, std::type_identity<SetMaterial>{},
                 std::type_identity<AddMaterial>{}, std::type_identity<ChooseSkyImage>{},
                 std::type_identity<UnlockAll>{}, std::type_identity<ExportSeen>{});
}

void apply(AppState& state, const Command& command) {
    try {
        applyUnchecked(state, command);
    } catch (const std::exception& error) {
        state.banner = error.what();
    }
}

}  // namespace halfdisk
