#include "app/light_progress.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "app/language.h"
#include "app/picture_stages.h"
#include "app/trade_words.h"

namespace halfdisk {
namespace {

struct Part {
    std::string name;
    double share;  ///< 0 ... 1
};

/// Of what is known about P: the run, what is exact, many runs.
double shareOfPoint(const LightAnswer& answer) {
    if (answer.pointComplete) return 1.0;
    return (answer.record ? 0.25 : 0.0) + (answer.exact ? 0.25 : 0.0) + (answer.runs.count > 0 ? 0.25 : 0.0);
}

/// What is required is found first, then what each part costs.
double shareOfRequirements(const InstrumentAnswers& answers) {
    if (!answers.requirementsRefusal.empty()) return 1.0;
    if (!answers.requirements) return 0.0;
    if (!hasLight(*answers.requirements)) return 1.0;
    if (!answers.costs) return 0.3;
    return 0.3 + 0.7 * static_cast<double>(answers.costs->done) / static_cast<double>(answers.costs->pieces);
}

/// Nothing if it is an answer to an older question.
const LightAnswer* answerOf(const AppState& state) {
    return state.answer && state.answer->asked.id == state.questionId ? state.answer.get() : nullptr;
}

/// Measured, and what was chosen of it tried.
double shareOfTrade(const AppState& state, const LightAnswer* answer) {
    const TradeSoFar* trade = answer ? answer->instruments.trade.get() : nullptr;
    if (!trade || trade->settings == 0) return 0.0;
    const auto choice = trade->complete() ? choiceOf(state, *trade) : std::nullopt;
    if (trade->complete() && (!choice || checkOf(*trade, *choice))) return 1.0;
    return 0.9 * static_cast<double>(trade->done) / static_cast<double>(trade->settings);
}

std::vector<Part> partsOf(const AppState& state) {
    const LightAnswer* answer = answerOf(state);
    std::vector<Part> parts{{"P", answer ? shareOfPoint(*answer) : 0.0}};
    for (const View view : kPictureViews) {
        if (!state.shows(view) || (view == View::eye && !state.scene->scene.eye)) continue;
        const std::string name(tr(view == View::eye     ? "the eye's strip"
                                  : view == View::field ? "the field"
                                                        : "the profile"));
        const auto share = [&](const PictureSet* pictures) {
            const LightPicture* picture = pictures ? pictures->of(view).get() : nullptr;
            return picture ? shareDone(*picture, state.makers.second ? state.makers.equal : Budget::rays,
                                       answer->asked.effort)
                           : 0.0;
        };
        parts.push_back({name, share(answer ? &answer->pictures : nullptr)});
        if (state.makers.second) parts.push_back({name + " B", share(answer ? &answer->against : nullptr)});
    }
    if (state.shows(View::strategies))
        parts.push_back(
            {std::string(nameOf(kViews, View::strategies)),
             answer && answer->strategies ? shareDone(*answer->strategies, answer->asked.effort) : 0.0});
    if (state.shows(View::trade))
        parts.push_back({std::string(tr("the trade")), shareOfTrade(state, answer)});
    if (state.shows(View::requirements))
        parts.push_back(
            {std::string(tr("requirements")), answer ? shareOfRequirements(answer->instruments) : 0.0});
    return parts;
}

/// Never 100 % before all is done.
int percent(double share) {
    return static_cast<int>(std::floor(100.0 * share));
}

}  // namespace

bool lightIsComplete(const AppState& state) {
    const LightAnswer* answer = answerOf(state);
    return answer && answer->complete;
}

double lightShare(const AppState& state) {
    if (lightIsComplete(state)) return 1.0;
    const std::vector<Part> parts = partsOf(state);
    double sum = 0.0;
    for (const Part& part : parts) sum += part.share;
    return std::min(0.99, sum / static_cast<double>(parts.size()));
}

std::string lightParts(const AppState& state) {
    std::string words;
    for (const Part& part : partsOf(state)) {
        words += fmt::format("{}{} ", words.empty() ? "" : ", ", part.name);
        words += part.share >= 1.0 ? std::string(tr("done")) : fmt::format("{} %", percent(part.share));
    }
    return words;
}

std::string lightProgress(const AppState& state) {
    return fmt::format("{} %: {}", percent(lightShare(state)), lightParts(state));
}

}  // namespace halfdisk
