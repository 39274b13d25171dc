#include "app/number_words.h"

#include <fmt/format.h>

#include "app/draw_text.h"
#include "app/language.h"
#include "app/message_words.h"

namespace halfdisk {
namespace {

std::string withUnit(const Rgb& value, const char* unit) {
    if (isGray(value)) return fmt::format("{} {}", shown(value), unit);
    return say("{} {} (red, green, blue: {})", shown(gray(value)), unit, shown(value));
}

std::string irradiance(const Rgb& value) {
    return withUnit(value, "W/m");
}

void add(std::vector<NumberWords>& numbers, std::string_view name, std::string value) {
    numbers.push_back({std::string(tr(name)), std::move(value)});
}

void addEstimate(std::vector<NumberWords>& numbers, const AppState& state, const LightAnswer& answer) {
    const bool printed = state.settings.defects != DefectSet{};
    const Rgb E = answer.estimate.total();
    std::string value = irradiance(E);
    if (answer.standardError)
        value += say(" \u00b1 {:.2g}, one standard error from its own samples", gray(*answer.standardError));
    else if (answer.runs.count > 1)
        value += say(" \u00b1 {:.2g}, one standard error from the spread of {} runs",
                     gray(glm::sqrt(answer.runs.variance())), answer.runs.count);
    add(numbers, printed ? "E as printed" : "estimate of E", value);
    if (!printed && state.settings.maxDepth > 0) {
        add(numbers, "of it direct", irradiance(answer.estimate.direct));
        add(numbers, "of it indirect", irradiance(answer.estimate.indirect));
    }
    if (answer.corrected) add(numbers, "E corrected", irradiance(answer.corrected->total()));
}

void addDamage(std::vector<NumberWords>& numbers, const LightAnswer& answer) {
    for (const Damage& damage : answer.damage)
        numbers.push_back(
            {say("what {} alone does to E", nameOf(kDefects, damage.defect)),
             local(fmt::format("{:+.1f} % \u00b1 {:.2g} %", 100.0 * damage.relative, 100.0 * damage.error))});
}

/// Of another run than castRay's.
std::vector<NumberWords> pathRunNumbers(const AppState& state, const LightAnswer& answer) {
    const PathRun& run = *answer.pathRun;
    std::vector<NumberWords> numbers;
    const auto pixel = pixelOf(answer);
    const std::string name =
        pixel && answer.asked.makers.second
            ? say("estimate of L, pixel {} of strip {}", *pixel, nameOf(kSides, answer.asked.pixelOf))
        : pixel ? say("estimate of L, pixel {} of the eye's strip", *pixel)
                : std::string(tr("estimate of E"));
    if (state.shows(View::exact))
        add(numbers, pixel ? "exact E at P" : "exact E",
            answer.exact ? irradiance(*answer.exact) : std::string(tr("not known")));
    if (!state.shows(View::numbers)) return numbers;
    if (!run.refusal.empty()) return {{name, say("none: {}", trMessage(run.refusal))}};
    std::string value = withUnit(run.estimate, unitOf(answer));
    if (run.standardError)
        value += say(" \u00b1 {:.2g}, one standard error from its own paths", gray(*run.standardError));
    const bool finished = !state.playback.stepping || state.playback.event >= state.eventCount();
    if (!finished) value = say("not finished, at step {} of {}", state.playback.event, state.eventCount());
    numbers.push_back({name, value});
    if (finished) add(numbers, "rays cast", fmt::format("{}", run.counts.rays));
    return numbers;
}

}  // namespace

std::vector<NumberWords> numberWords(const AppState& state) {
    if (!state.answer || (state.answer->tooManyRays && !state.answer->pathRun)) return {};
    const LightAnswer& answer = *state.answer;
    if (answer.pathRun) return pathRunNumbers(state, answer);
    std::vector<NumberWords> numbers;
    const bool finished = !state.playback.stepping || state.playback.event >= state.eventCount();
    const bool counted = state.shows(View::numbers) && finished;
    if (counted) addEstimate(numbers, state, answer);
    if (state.shows(View::numbers) && !finished)
        add(numbers, "estimate of E",
            say("not finished, at step {} of {}", state.playback.event, state.eventCount()));
    if (state.shows(View::exact)) {
        add(numbers, "exact E", answer.exact ? irradiance(*answer.exact) : std::string(tr("not known")));
        if (counted && answer.exact && gray(*answer.exact) != 0.0)
            add(numbers, "off by",
                local(fmt::format("{:+.1f} %",
                                  100.0 * (gray(answer.estimate.total()) / gray(*answer.exact) - 1.0))));
    }
    if (counted) {
        add(numbers, "L of the wall",
            answer.radiance ? fmt::format("{} W/(m rad)", shown(*answer.radiance))
                            : std::string(tr("depends on the view")));
        add(numbers, "rays cast", std::to_string(answer.rays));
    }
    if (answer.nonFinite > 0) add(numbers, "samples not finite", std::to_string(answer.nonFinite));
    if (state.shows(View::damage)) addDamage(numbers, answer);
    return numbers;
}

}  // namespace halfdisk
