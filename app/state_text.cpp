#include "app/state_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/goal_check.h"
#include "app/light_progress.h"
#include "app/number_words.h"
#include "app/picture_stages.h"
#include "app/plot_words.h"
#include "app/run_text.h"
#include "app/sample_words.h"
#include "app/scene_words.h"
#include "app/step_text.h"
#include "app/tree_json.h"
#include "app/words_page.h"

namespace halfdisk {
namespace {

std::string titleOf(const AppState& state) {
    if (state.lesson)
        return fmt::format("Halfdisk: {}, step {} of {}: {}", state.lesson->title, state.step + 1,
                           state.lesson->steps.size(), state.currentStep()->title);
    const std::string& title = state.scene->scene.title;
    return fmt::format("Halfdisk: {}", title.empty() ? "a scene without a lesson" : title);
}

/// Those of the lesson's words that the step explains on hover.
void addTerms(WordsPage& page, const Lesson& lesson, const Step& step) {
    std::vector<bool> used(lesson.terms.size());
    for (const Paragraph& paragraph : step.prose)
        for (const Span& span : paragraph.spans)
            if (span.style == SpanStyle::term) used[span.term] = true;
    if (std::find(used.begin(), used.end(), true) == used.end()) return;
    page.heading("Words");
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) page.fact(lesson.terms[i].name, lesson.terms[i].meaning);
}

void addGoal(WordsPage& page, const AppState& state, const Goal& goal) {
    const std::optional<double> value = valueOf(goal, state);
    page.heading(value && isReached(goal, *value) ? "Reached" : "To try");
    page.paragraph(goal.says);
    const bool percent = goal.quantity == GoalQuantity::relativeError;
    const auto number = [&](double x) { return percent ? fmt::format("{} %", shown(100.0 * x)) : shown(x); };
    page.fact("now", value ? number(*value) : "not known");
    page.fact("wanted", fmt::format("{} {}", goal.relation == Relation::atMost ? "at most" : "at least",
                                    number(goal.number)));
}

void addLesson(WordsPage& page, const AppState& state) {
    const Step* step = state.currentStep();
    if (!step) return;
    page.paragraph(fmt::format("Lesson {}, {}. It teaches, of the published one: {}.", state.lesson->number,
                               state.lesson->slug, state.lesson->section));
    page.heading("What the lesson says");
    page.prose(plainText(step->prose));
    addTerms(page, *state.lesson, *step);
    if (step->goal) addGoal(page, state, *step->goal);
    if (!step->question) return;
    page.heading("Question");
    page.paragraph(plainText(step->question->ask));
    if (state.answerShown) page.fact("Answer", plainText(step->question->answer));
}

void addSettings(WordsPage& page, const AppState& state) {
    const Settings& settings = state.settings;
    page.heading("Settings");
    page.fact("N, samples per bounce", std::to_string(settings.samples));
    page.fact("maxDepth", std::to_string(settings.maxDepth));
    page.fact("seed", std::to_string(settings.seed));
    for (const auto& sampler : kSamplers)
        if (sampler.value == settings.sampler)
            page.fact("sampler", fmt::format("{}: {}", sampler.name, sampler.meaning));
    for (const auto& emitters : kEmitters)
        if (emitters.value == settings.emitters)
            page.fact("emitters", fmt::format("{}: {}", emitters.name, emitters.meaning));
    if (settings.defects == DefectSet{}) page.fact("code", "the corrected castRay");
    for (const auto& defect : kDefects)
        if (settings.defects.has(defect.value))
            page.fact("as printed", fmt::format("{}: {}", defect.name, defect.meaning));
    if (const Step* step = state.currentStep(); step && step->unlock)
        for (const auto& control : kControls)
            if (control.value == *step->unlock)
                page.fact("this step unlocks", fmt::format("{}: {}", control.name, control.meaning));
}

/// What makes the pictures, with its parameters.
void addMakers(WordsPage& page, const AppState& state) {
    const auto add = [&](std::string_view name, const Maker& maker) {
        const EstimatorInfo& info = *findEstimator(maker.estimator);
        std::string words = fmt::format("{}: {}", info.id, info.meaning);
        for (std::size_t i = 0; i < info.params.size(); ++i) {
            const ParamInfo& param = info.params[i];
            const double value = maker.params[i];
            words += fmt::format("{} {} ", i == 0 ? ";" : ",", param.name);
            words += param.choices.empty() ? shown(value)
                                           : std::string(param.choices[static_cast<std::size_t>(value)]);
        }
        if (maker.depth) words += fmt::format("; depth {}", *maker.depth);
        page.fact(name, words);
    };
    if (state.makers.second) {
        if (state.makers.first) add("estimator A of the pictures", *state.makers.first);
        add("estimator B of the pictures", *state.makers.second);
        return;
    }
    if (state.makers.first) return add("estimator of the pictures", *state.makers.first);
    for (const View view : kPictureViews)
        if (state.shows(view))
            add(fmt::format("estimator of the {}", nameOf(kViews, view)), usualMaker(view));
}

void addScene(WordsPage& page, const AppState& state) {
    const SceneDescription& scene = state.scene->description;
    page.heading(scene.title.empty() ? "Scene" : fmt::format("Scene: {}", scene.title));
    page.paragraph("Places are in metres, x to the right and y up.");
    for (const std::string& wall : wallWords(scene)) page.item(wall);
    page.paragraph("Materials:");
    for (const std::string& material : materialWords(scene)) page.item(material);
    page.paragraph("Lights that are no walls, and the sky:");
    for (const std::string& light : lightWords(scene)) page.item(light);
    page.paragraph(eyeWords(scene));
    const Vec2 P = positionOf(state.scene->scene, state.at), N = state.scene->index.normal(state.at.segment);
    page.paragraph(fmt::format("P is at {}, {:.4g} of the way along {}. Its normal is {}.", placeWords(P),
                               state.at.t, state.scene->scene.segmentNames[state.at.segment], placeWords(N)));
}

/// How often each kind of step occurs.
template <class Events, class Kinds>
std::string kindsOf(const Events& events, const Kinds& table) {
    std::string kinds;
    for (const auto& kind : table) {
        const auto count = std::count_if(events.begin(), events.end(),
                                         [&](const auto& event) { return event.kind == kind.value; });
        kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", kind.name, count);
    }
    return kinds;
}

void addPathRun(WordsPage& page, const AppState& state, const PathRun& run) {
    const LightAnswer& answer = *state.answer;
    const auto pixel = pixelOf(answer);
    page.heading(fmt::format("The recorded run of {}{}", nameOf(kRuns, answer.asked.run),
                             pixel ? fmt::format(", for pixel {} of the eye's strip", *pixel) : ""));
    if (!run.refusal.empty()) return page.paragraph(fmt::format("There is none: {}.", run.refusal));
    page.paragraph(fmt::format("{} steps of {} paths; {} rays. It says {} = {} {}.{}",
                               run.record.events.size(), run.record.paths, run.counts.rays, pixel ? "L" : "E",
                               shown(run.estimate), unitOf(answer),
                               run.record.truncated ? " Later paths were left out of the record." : ""));
    page.fact("steps by kind", kindsOf(run.record.events, kPathEventKinds));
    if (pixel) page.paragraph(pixelSumWords(answer));
    if (pixel) page.paragraph(pixelSumMeaning(answer));
    if (!state.playback.stepping) return page.paragraph("The whole run is shown.");
    page.paragraph(fmt::format("Shown up to step {} of {}.",
                               std::min(state.playback.event, state.eventCount()), state.eventCount()));
    if (!currentPathEvent(state)) return;
    const StepText words = describeStep(state);
    page.paragraph(fmt::format("{}: {} ({})", words.where, words.what, words.values));
}

void addRun(WordsPage& page, const AppState& state) {
    if (state.answer && state.answer->pathRun) return addPathRun(page, state, *state.answer->pathRun);
    page.heading("The recorded run of castRay");
    const LightAnswer* answer = state.answer.get();
    if (answer && answer->tooManyRays)
        return page.paragraph(
            fmt::format("It was not begun: it would cast about {:.3g} rays. Lower N or maxDepth.",
                        static_cast<double>(answer->rays)));
    if (!answer || !answer->record) return page.paragraph("It is not known yet.");
    const Record& record = *answer->record;
    std::uint32_t deepest = 0;
    for (const Call& call : record.calls) deepest = std::max(deepest, call.depth);
    page.paragraph(fmt::format("{} steps in {} half-disk{}, down to depth {}; {} rays.{}",
                               record.events.size(), record.calls.size(), record.calls.size() == 1 ? "" : "s",
                               deepest, record.rays,
                               record.truncated ? " Deeper steps were left out of the record." : ""));
    page.fact("steps by kind", kindsOf(record.events, kEventKinds));
    if (!state.playback.stepping) return page.paragraph("The whole run is shown.");
    page.paragraph(fmt::format("Shown up to step {} of {}.",
                               std::min(state.playback.event, state.eventCount()), state.eventCount()));
    if (const Event* event = currentEvent(state)) {
        const StepText words = describeStep(state);
        page.paragraph(fmt::format("Line {} of the published listing, {}: {} ({})", listingLine(event->kind),
                                   words.where, words.what, words.values));
    }
}

void addDrawings(WordsPage& page, const AppState& state) {
    page.heading(drawingTitle(state, "canvas"));
    page.paragraph(drawingWords(state, "canvas"));
    constexpr std::array kNames{std::pair{View::field, "field"},     std::pair{View::eye, "eye"},
                                std::pair{View::profile, "profile"}, std::pair{View::integrand, "integrand"},
                                std::pair{View::error, "error"},     std::pair{View::histogram, "histogram"}};
    for (const auto& [view, name] : kNames) {
        if (!state.shows(view)) continue;
        page.heading(drawingTitle(state, name));
        page.paragraph(drawingWords(state, name));
    }
}

}  // namespace

std::string stateText(const AppState& state) {
    WordsPage page;
    page.title(titleOf(state));
    if (!lightIsComplete(state))
        page.paragraph(fmt::format("The light is not complete yet, {}.", lightProgress(state)));
    addLesson(page, state);
    page.heading("Shown");
    for (const Named<View>& view : kViews)
        if (state.shows(view.value)) page.item(fmt::format("{}: {}", view.name, view.meaning));
    addSettings(page, state);
    addMakers(page, state);
    addScene(page, state);
    if (state.shows(View::numbers) || state.shows(View::exact) || state.shows(View::damage)) {
        page.heading("Numbers");
        for (const NumberWords& number : numberWords(state)) page.fact(number.name, number.value);
    }
    addDrawings(page, state);
    addRun(page, state);
    return page.text();
}

}  // namespace halfdisk
