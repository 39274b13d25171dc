#include "app/opening.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/edit_commands.h"
#include "app/language.h"
#include "app/share_text.h"
#include "lessons/lesson_file.h"
#include "lessons/translation.h"

namespace halfdisk {
namespace {

/// In the state's language.
Lesson readLesson(const AppState& state, const std::filesystem::path& file) {
    Lesson lesson = loadLesson(file);
    translateLesson(lesson, state.language);
    return lesson;
}

void listAgain(AppState& state, const std::filesystem::path& folder) {
    std::vector<LessonEntry> lessons = listLessons(folder);
    for (LessonEntry& entry : lessons)
        if (auto titles = translatedTitles(entry.path, state.language)) {
            entry.title = titles->lesson;
            if (titles->steps.size() == entry.stepTitles.size()) entry.stepTitles = std::move(titles->steps);
        }
    state.lessonsFolder = folder;
    state.lessons = std::move(lessons);
}

void showScene(AppState& state, SceneDescription description, const std::filesystem::path& file) {
    auto prepared = std::make_shared<const PreparedScene>(std::move(description));
    if (prepared->scene.segments.empty())
        throw InputError(file.string(), "the scene has no walls to stand on, expected at least one");
    replaceScene(state, std::move(prepared));
    state.fitCamera = true;
}

void showLesson(AppState& state, Lesson lesson, std::size_t step) {
    const bool sameScene =
        state.scene && state.sceneOverride.empty() && state.scene->description == lesson.scene;
    if (!sameScene && state.sceneOverride.empty()) showScene(state, lesson.scene, lesson.scenePath);
    state.lesson = std::move(lesson);
    enterStep(state, std::min(step, state.lesson->steps.size() - 1));
}

void showDescribed(AppState& state, SceneDescription scene, const std::filesystem::path& file) {
    showScene(state, std::move(scene), file);
    state.lesson.reset();
    state.step = 0;
    state.sceneOverride = file;
    state.at = WallPoint{0, 0.5};
    state.show = {};
    for (const View view : {View::halfdisk, View::rays, View::integrand, View::error, View::histogram,
                            View::exact, View::numbers})
        state.show.set(view, true);
    state.show = state.show - state.rules.hidden;
    state.makers = {};
    state.run = Run::castRay;
    state.scale = FieldScale::light;
    state.pickedTrade.reset();
    state.beforePick.reset();
    state.strategiesAlone = false;
    askAnew(state);
    state.playback.stepping = false;
}

/// What the class may not change stays as it is here.
void keepLocked(const AppState& here, AppState& shared) {
    const ClassRules& rules = here.rules;
    Settings& settings = shared.settings;
    if (rules.isLocked(Control::samples)) settings.samples = here.settings.samples;
    if (rules.isLocked(Control::depth)) settings.maxDepth = here.settings.maxDepth;
    if (rules.isLocked(Control::seed)) settings.seed = here.settings.seed;
    if (rules.isLocked(Control::sampler)) settings.sampler = here.settings.sampler;
    if (rules.isLocked(Control::emitters)) settings.emitters = here.settings.emitters;
    if (rules.isLocked(Control::defects)) settings.defects = here.settings.defects;
    if (rules.isLocked(Control::estimator) || rules.isLocked(Control::params)) shared.makers = here.makers;
    StepValues values{
        .settings = settings, .at = shared.at, .makers = shared.makers, .instruments = shared.instruments};
    obey(rules, shared.scene->scene, values);
    shared.settings = values.settings;
    shared.at = values.at;
    shared.makers = values.makers;
}

/// Another scene has no such eye, and rules may hide the strip.
void pinIfPossible(AppState& state, std::optional<std::uint32_t> pixel, Side side) {
    state.pinnedPixel = pixel && canPin(state, *pixel) ? pixel : std::nullopt;
    state.pinnedSide = state.pinnedPixel && state.makers.second ? side : Side::first;
}

}  // namespace

void askAnew(AppState& state) {
    ++state.questionId;
    state.playback.playing = false;
    state.playback.event = 0;
}

void enterStep(AppState& state, std::size_t step) {
    state.notice.clear();
    const Step& entered = state.lesson->steps[step];
    if (state.sceneOverride.empty() && !(state.scene->description == state.lesson->scene))
        showScene(state, state.lesson->scene, state.lesson->scenePath);
    StepValues values = entered.values;
    obey(state.rules, state.scene->scene, values);
    state.step = step;
    state.show = entered.show - state.rules.hidden;
    state.answerShown = false;
    state.chosenLine = 0;
    state.drawn.clear();
    state.drawing = false;
    state.litLine = 0;
    state.grip = Grip::none;
    state.eyePixel.reset();
    if (state.sceneOverride.empty()) {
        state.at = values.at;
    } else {
        state.at = WallPoint{0, 0.5};
    }
    state.settings = values.settings;
    state.makers = values.makers;
    state.run = values.run;
    state.scale = values.scale;
    state.instruments = values.instruments;
    state.pickedTrade.reset();
    state.beforePick.reset();
    state.strategiesAlone = false;
    state.sampleRange.reset();
    state.largestFirst = false;
    pinIfPossible(state, values.pixel, values.pixelOf);
    if (values.pixel && !state.scene->scene.eye)
        state.notice = tr("This step looks into a pixel of the eye's strip, but the scene has no eye.");
    state.split = 0.5f;
    askAnew(state);
    const bool stepping = entered.unlock == Control::step || entered.values.event > 0;
    state.playback = {stepping, entered.values.event, false, 0.0f};
}

void goTo(AppState& state, const LessonRef& ref) {
    const LessonEntry& entry = findLesson(state.lessons, ref);
    Lesson lesson = readLesson(state, entry.path);
    const std::size_t step = stepIndex(lesson, ref);
    showLesson(state, std::move(lesson), step);
}

void showSceneAlone(AppState& state, const std::filesystem::path& file) {
    showDescribed(state, loadScene(file), file);
}

/// What somebody else saw. The window, and what the class may do, stay as they are.
void showShared(AppState& state, const std::string& text) {
    AppState shared = openShared(state.lessonsFolder, text);
    keepLocked(state, shared);
    replaceScene(state, shared.scene);
    state.editing.clean = shared.editing.clean;
    state.editing.neverSaved = shared.editing.neverSaved;
    state.lesson = std::move(shared.lesson);
    if (state.lesson) translateLesson(*state.lesson, state.language);
    state.step = shared.step;
    state.sceneOverride = shared.sceneOverride;
    state.settings = shared.settings;
    state.at = shared.at;
    state.show = shared.show - state.rules.hidden;
    state.makers = shared.makers;
    state.run = shared.run;
    state.scale = shared.scale;
    state.instruments = shared.instruments;
    state.pickedTrade.reset();
    state.beforePick.reset();
    state.strategiesAlone = shared.strategiesAlone;
    pinIfPossible(state, shared.pinnedPixel, shared.pinnedSide);
    askAnew(state);
    state.playback = shared.playback;
    state.fitCamera = true;
}

void openAny(AppState& state, const std::filesystem::path& file) {
    if (!parseLessonFileName(file)) return showSceneAlone(state, file);
    state.sceneOverride.clear();
    showLesson(state, readLesson(state, file), 0);
}

void setLanguage(AppState& state, const std::string& code) {
    state.language = code;
    listAgain(state, state.lessonsFolder);
    if (!state.lesson) return;
    Lesson lesson = readLesson(state, state.lesson->file);
    state.step = std::min(state.step, lesson.steps.size() - 1);
    state.lesson = std::move(lesson);
}

void reload(AppState& state) {
    listAgain(state, state.lessonsFolder);
    if (!state.sceneOverride.empty()) {
        const WallPoint at = state.at;
        if (isEdited(state))
            throw std::runtime_error(
                say("{} has changed on the disk. It is not read: the scene here has unsaved changes",
                    state.sceneOverride.string()));
        SceneDescription onDisk = loadScene(state.sceneOverride);
        if (!(onDisk == state.scene->description)) {  // else it is what was saved here
            showScene(state, std::move(onDisk), state.sceneOverride);
            state.at = at.segment < state.scene->scene.segments.size() ? at : WallPoint{0, 0.5};
            askAnew(state);
        }
    }
    state.banner.clear();
    if (!state.lesson) return;
    Lesson lesson = readLesson(state, state.lesson->file);
    if (lesson == *state.lesson) return;  // something else in the folder has changed
    // A scene that was changed by hand stays, whatever becomes of the text about it.
    const bool byHand = state.sceneOverride.empty() && !(state.scene->description == state.lesson->scene);
    if (!byHand) return showLesson(state, std::move(lesson), state.step);
    state.step = std::min(state.step, lesson.steps.size() - 1);
    state.lesson = std::move(lesson);
}

AppState openLesson(const std::filesystem::path& lessonsFolder, const std::optional<LessonRef>& ref,
                    const std::filesystem::path& scene) {
    AppState state;
    listAgain(state, lessonsFolder);
    if (!scene.empty()) {
        showScene(state, loadScene(scene), scene);
        state.sceneOverride = scene;
    }
    if (ref) {
        goTo(state, *ref);
        return state;
    }
    for (const LessonEntry& entry : state.lessons) {
        if (!entry.error.empty()) continue;
        goTo(state, {entry.slug, 1});
        return state;
    }
    throw InputError(lessonsFolder.string(), "no lesson that can be read, expected files NN-name.toml");
}

AppState openDescribed(const std::filesystem::path& lessonsFolder, const SceneDescription& scene) {
    AppState state;
    listAgain(state, lessonsFolder);
    showDescribed(state, scene, {});
    state.editing.neverSaved = true;
    return state;
}

AppState openRequested(const OpeningRequest& request) {
    AppState state = [&] {
        if (request.shared) return openShared(request.lessonsFolder, *request.shared);
        if (request.scene && !request.lesson) return openScene(request.lessonsFolder, *request.scene);
        return openLesson(request.lessonsFolder, request.lesson,
                          request.scene.value_or(std::filesystem::path()));
    }();
    setLanguage(state, request.language);
    return state;
}

void setRules(AppState& state, const ClassRules& rules, bool asTheStepBegins) {
    state.rules = rules;
    if (state.lesson && asTheStepBegins) return enterStep(state, state.step);
    StepValues values{
        .settings = state.settings, .at = state.at, .makers = state.makers, .instruments = state.instruments};
    obey(rules, state.scene->scene, values);
    state.settings = values.settings;
    state.at = values.at;
    state.makers = values.makers;
    state.show = state.show - rules.hidden;
    pinIfPossible(state, state.pinnedPixel, state.pinnedSide);
}

AppState openScene(const std::filesystem::path& lessonsFolder, const std::filesystem::path& scene) {
    AppState state;
    listAgain(state, lessonsFolder);
    showSceneAlone(state, scene);
    return state;
}

}  // namespace halfdisk
