#include "app/state_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/draw_text.h"
#include "app/goal_check.h"
#include "app/language.h"
#include "app/light_progress.h"
#include "app/message_words.h"
#include "app/number_words.h"
#include "app/picture_stages.h"
#include "app/plot_words.h"
#include "app/profile_difference.h"
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
        return say("Halfdisk: {}, step {} of {}: {}", state.lesson->title, state.step + 1,
                   state.lesson->steps.size(), state.currentStep()->title);
    const std::string& title = state.scene->scene.title;
    return fmt::format("Halfdisk: {}", title.empty() ? std::string(tr("a scene without a lesson")) : title);
}

/// Ends it, unless it ends by itself.
std::string sentence(std::string words) {
    if (!words.empty() && std::string_view(".?!").find(words.back()) == std::string_view::npos) words += '.';
    return words;
}

/// Numbers of the window stand apart from each other; read aloud they need a stop between them.
std::string readAloud(std::string_view values) {
    constexpr std::string_view kGap = "   ";
    std::string read;
    for (std::size_t gap = values.find(kGap); gap != std::string_view::npos; gap = values.find(kGap)) {
        read += values.substr(0, gap);
        read += "; ";
        values.remove_prefix(gap + kGap.size());
    }
    return read.append(values);
}

/// Those of the lesson's words that the step explains on hover.
void addTerms(WordsPage& page, const Lesson& lesson, const Step& step) {
    std::vector<bool> used(lesson.terms.size());
    for (const Paragraph& paragraph : step.prose)
        for (const Span& span : paragraph.spans)
            if (span.style == SpanStyle::term) used[span.term] = true;
    if (std::find(used.begin(), used.end(), true) == used.end()) return;
    page.heading(tr("Words"));
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) page.fact(lesson.terms[i].name, lesson.terms[i].meaning);
}

void addGoal(WordsPage& page, const AppState& state, const Goal& goal) {
    const std::optional<double> value = valueOf(goal, state);
    page.heading(tr(value && isReached(goal, *value) ? "Reached" : "To try"));
    page.paragraph(goal.says);
    const bool percent = goal.quantity == GoalQuantity::relativeError;
    const auto number = [&](double x) { return percent ? fmt::format("{} %", shown(100.0 * x)) : shown(x); };
    page.fact(tr("now"), value ? number(*value) : std::string(tr("not known")));
    page.fact(tr("wanted"),
              fmt::format("{} {}", tr(goal.relation == Relation::atMost ? "at most" : "at least"),
                          number(goal.number)));
}

void addLesson(WordsPage& page, const AppState& state) {
    const Step* step = state.currentStep();
    if (!step) return;
    page.paragraph(say("Lesson {}, {}. It teaches, of the published one: {}", state.lesson->number,
                       state.lesson->slug, sentence(state.lesson->section)));
    page.heading(tr("What the lesson says"));
    page.prose(plainText(step->prose));
    addTerms(page, *state.lesson, *step);
    if (step->goal) addGoal(page, state, *step->goal);
    if (!step->question) return;
    page.heading(tr("Question"));
    page.paragraph(plainText(step->question->ask));
    if (state.answerShown) page.fact(tr("Answer"), plainText(step->question->answer));
}

/// Rays and source are castRay's unless something else runs.
std::string_view meaningOf(const Named<View>& view, Run run) {
    if (run != Run::castRay && view.value == View::rays) return "the paths of the run";
    if (run != Run::castRay && view.value == View::code)
        return "the source of what runs, with the current line lit";
    return view.meaning;
}

std::string_view meaningOf(Run run) {
    for (const Named<Run>& known : kRuns)
        if (known.value == run) return known.meaning;
    return {};
}

/// Of castRay's run alone.
void addCastRaySettings(WordsPage& page, const Settings& settings) {
    for (const auto& sampler : kSamplers)
        if (sampler.value == settings.sampler)
            page.fact("sampler", fmt::format("{} ({})", sampler.name, tr(sampler.meaning)));
    for (const auto& emitters : kEmitters)
        if (emitters.value == settings.emitters)
            page.fact("emitters", fmt::format("{} ({})", emitters.name, tr(emitters.meaning)));
    if (settings.defects == DefectSet{}) page.fact(tr("source"), tr("the corrected castRay"));
    for (const auto& defect : kDefects)
        if (settings.defects.has(defect.value))
            page.fact(tr("as printed"), fmt::format("{} ({})", defect.name, tr(defect.meaning)));
}

void addSettings(WordsPage& page, const AppState& state) {
    const Settings& settings = state.settings;
    // Of a pixel another run than the one that is chosen may be shown.
    const Run run = state.answer && state.answer->pathRun ? state.answer->asked.run : state.run;
    const bool castRay = run == Run::castRay;
    page.heading(tr("Settings"));
    page.fact(tr("run"), fmt::format("{} ({})", nameOf(kRuns, run), tr(meaningOf(run))));
    page.fact(tr(castRay ? "N, samples per bounce" : "N, paths"), std::to_string(settings.samples));
    page.fact("maxDepth", std::to_string(settings.maxDepth));
    page.fact("seed", std::to_string(settings.seed));
    if (castRay) addCastRaySettings(page, settings);
    if (const Step* step = state.currentStep(); step && step->unlock)
        for (const auto& control : kControls)
            if (control.value == *step->unlock) page.fact(tr("this step unlocks"), tr(control.meaning));
}

/// What makes the pictures, with its parameters.
void addMakers(WordsPage& page, const AppState& state) {
    const auto add = [&](std::string_view name, const Maker& maker) {
        const EstimatorInfo& info = *findEstimator(maker.estimator);
        std::string words = fmt::format("{} ({}): {}", tr(info.title), info.id, tr(info.meaning));
        for (std::size_t i = 0; i < info.params.size(); ++i) {
            const ParamInfo& param = info.params[i];
            const double value = maker.params[i];
            words += fmt::format("{} {} ", i == 0 ? ";" : ",", param.name);
            words += param.choices.empty() ? shown(value)
                                           : std::string(param.choices[static_cast<std::size_t>(value)]);
        }
        if (maker.depth) words += say("; depth {}", *maker.depth);
        if (maker.specular) words += say("; {} mirrors or skins of glass in a row", *maker.specular);
        page.fact(name, words);
    };
    if (state.makers.second) {
        if (state.makers.first) add(tr("estimator A of the pictures"), *state.makers.first);
        add(tr("estimator B of the pictures"), *state.makers.second);
        page.fact(tr("equal"), tr(kBudgets[static_cast<std::size_t>(state.makers.equal)].meaning));
        return;
    }
    if (state.makers.first) return add(tr("estimator of the pictures"), *state.makers.first);
    for (const View view : kPictureViews)
        if (state.shows(view))
            add(tr(view == View::field ? "estimator of the field"
                   : view == View::eye ? "estimator of the eye's strip"
                                       : "estimator of the profile"),
                usualMaker(view));
}

void addScene(WordsPage& page, const AppState& state) {
    const SceneDescription& scene = state.scene->description;
    page.heading(scene.title.empty() ? std::string(tr("Scene")) : say("Scene: {}", tr(scene.title)));
    page.paragraph(tr("Places are in metres, x to the right and y up."));
    for (const std::string& wall : wallWords(scene)) page.item(wall);
    page.paragraph(tr("Materials:"));
    for (const std::string& material : materialWords(scene)) page.item(material);
    page.paragraph(tr("Lights that are no walls, and the sky:"));
    for (const std::string& light : lightWords(scene)) page.item(light);
    page.paragraph(eyeWords(scene));
    const Vec2 P = positionOf(state.scene->scene, state.at), N = state.scene->index.normal(state.at.segment);
    page.paragraph(say("P is at {}, {:.4g} of the way along {}. Its normal is {}.", placeWords(P), state.at.t,
                       state.scene->scene.segmentNames[state.at.segment], placeWords(N)));
}

/// How often each kind of step occurs.
template <class Events, class Kinds>
void addKinds(WordsPage& page, const Events& events, const Kinds& table) {
    page.paragraph(tr("Steps by kind:"));
    for (const auto& kind : table) {
        const auto count = std::count_if(events.begin(), events.end(),
                                         [&](const auto& event) { return event.kind == kind.value; });
        if (count > 0) page.item(fmt::format("{}: {}", tr(kind.meaning), count));
    }
}

/// Where the reader is in the run.
void addPlayback(WordsPage& page, const AppState& state) {
    if (!state.playback.stepping) return page.paragraph(tr("The whole run is shown."));
    const std::size_t count = state.eventCount(), event = std::min(state.playback.event, count);
    page.paragraph(say("Shown up to step {} of {}.", event, count));
}

void addPathRun(WordsPage& page, const AppState& state, const PathRun& run) {
    const LightAnswer& answer = *state.answer;
    const auto pixel = pixelOf(answer);
    const std::string_view name = nameOf(kRuns, answer.asked.run);
    page.heading(pixel ? say("The recorded run of {}, for pixel {} of the eye's strip", name, *pixel)
                       : say("The recorded run of {}", name));
    if (!run.refusal.empty()) return page.paragraph(say("There is none: {}.", trMessage(run.refusal)));
    page.paragraph(say("Steps: {}, paths: {}, rays: {}. It says {} = {} {}.", run.record.events.size(),
                       run.record.paths, run.counts.rays, pixel ? "L" : "E", shown(run.estimate),
                       unitOf(answer)));
    if (run.record.truncated) page.paragraph(tr("Later paths were left out of the record."));
    addKinds(page, run.record.events, kPathEventKinds);
    if (const std::string whose = whosePixel(answer); !whose.empty()) page.paragraph(whose);
    if (pixel) page.paragraph(pixelSumWords(answer));
    if (pixel) page.paragraph(pixelSumMeaning(answer));
    addPlayback(page, state);
    if (!currentPathEvent(state)) return;
    const StepText words = describeStep(state);
    page.paragraph(fmt::format("{}: {} ({})", words.where, words.what, readAloud(words.values)));
}

void addRun(WordsPage& page, const AppState& state) {
    if (state.answer && state.answer->pathRun) return addPathRun(page, state, *state.answer->pathRun);
    page.heading(say("The recorded run of {}", "castRay"));
    const LightAnswer* answer = state.answer.get();
    if (answer && answer->tooManyRays)
        return page.paragraph(say("It was not begun: it would cast about {:.3g} rays. Lower N or maxDepth.",
                                  static_cast<double>(answer->rays)));
    if (!answer || !answer->record) return page.paragraph(tr("It is not known yet."));
    const Record& record = *answer->record;
    std::uint32_t deepest = 0;
    for (const Call& call : record.calls) deepest = std::max(deepest, call.depth);
    const std::size_t events = record.events.size(), calls = record.calls.size();
    page.paragraph(calls == 1 ? say("{} steps in one half-disk; {} rays.", events, record.rays)
                              : say("{} steps in {} half-disks, down to depth {}; {} rays.", events, calls,
                                    deepest, record.rays));
    if (record.truncated) page.paragraph(tr("Deeper steps were left out of the record."));
    addKinds(page, record.events, kEventKinds);
    addPlayback(page, state);
    if (const Event* event = currentEvent(state)) {
        const StepText words = describeStep(state);
        page.paragraph(say("Line {} of the published listing, {}: {} ({})", listingLine(event->kind),
                           words.where, words.what, readAloud(words.values)));
    }
}

void addDrawings(WordsPage& page, const AppState& state) {
    page.heading(drawingTitle(state, "canvas"));
    page.paragraph(drawingWords(state, "canvas"));
    constexpr std::array kNames{
        std::pair{View::field, "field"},           std::pair{View::eye, "eye"},
        std::pair{View::profile, "profile"},       std::pair{View::integrand, "integrand"},
        std::pair{View::error, "error"},           std::pair{View::histogram, "histogram"},
        std::pair{View::strategies, "strategies"}, std::pair{View::extremes, "extremes"},
        std::pair{View::trade, "trade"},           std::pair{View::requirements, "requirements"}};
    const auto add = [&](std::string_view name) {
        page.heading(drawingTitle(state, name));
        page.paragraph(drawingWords(state, name));
    };
    for (const auto& [view, name] : kNames) {
        if (!state.shows(view)) continue;
        add(name);
        if (view == View::profile && plotsDifference(state)) add("difference");
    }
}

}  // namespace

std::string stateText(const AppState& state) {
    WordsPage page;
    page.title(titleOf(state));
    if (!lightIsComplete(state))
        page.paragraph(say("The light is not complete yet, {}.", lightProgress(state)));
    addLesson(page, state);
    page.heading(tr("Shown"));
    for (const Named<View>& view : kViews)
        if (state.shows(view.value)) page.item(tr(meaningOf(view, state.run)));
    addSettings(page, state);
    addMakers(page, state);
    addScene(page, state);
    if (state.shows(View::numbers) || state.shows(View::exact) || state.shows(View::damage)) {
        page.heading(tr("Numbers"));
        for (const NumberWords& number : numberWords(state)) page.fact(number.name, number.value);
    }
    addDrawings(page, state);
    addRun(page, state);
    return page.text();
}

}  // namespace halfdisk
