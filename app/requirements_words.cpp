#include "app/requirements_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/language.h"
#include "app/message_words.h"
#include "app/plan_words.h"
#include "core/requirements/words.h"
#include "lessons/maker_reader.h"

namespace halfdisk {
namespace {

const InstrumentAnswers* answersOf(const AppState& state) {
    return state.answer ? &state.answer->instruments : nullptr;
}

/// A plan that can be followed.
const RequirementsAnswer* plannedOf(const AppState& state) {
    const InstrumentAnswers* answers = answersOf(state);
    return answers && answers->requirements && hasLight(*answers->requirements) ? answers->requirements.get()
                                                                                : nullptr;
}

/// Core's sentences are English, their numbers too.
std::string told(const std::string& sentence) {
    std::string words = trMessage(sentence);
    const Language* language = spoken();
    if (!language || language->decimalPoint == ".") return words;
    const auto digit = [&](std::size_t at) {
        return at < words.size() && std::isdigit(static_cast<unsigned char>(words[at])) != 0;
    };
    for (std::size_t at = 1; at < words.size(); ++at)
        if (words[at] == '.' && digit(at - 1) && digit(at + 1)) words.replace(at, 1, language->decimalPoint);
    return words;
}

std::string switchedWords(RequirementId id, std::uint32_t value) {
    if (infoOf(id).kind == Switch::number && value > 0) return std::to_string(value);
    return std::string(tr(value > 0 ? "on" : "off"));
}

std::string valueWords(const Requirement& requirement) {
    if (!requirement.on) return std::string(tr("not needed"));
    if (requirement.number) return say("{} needed", *requirement.number);
    return std::string(tr("needed"));
}

constexpr double kSeen = 1e-5;  // of the light: less is not told

std::string lightWords(const PlanCost& cost) {
    if (!cost.raysFactor) return std::string(tr("no run met light"));
    if (!cost.change) return std::string(tr("such light was not met"));
    const double share = cost.change->share, sure = 2.0 * cost.change->standardError;
    const bool changes = std::abs(share) > sure && std::abs(share) > kSeen;
    std::string words = changes ? say("light {:+.2g} %", 100.0 * share) : std::string(tr("same light"));
    if (sure > kSeen) words += say(" (\u00b1 {:.1g} %)", 100.0 * sure);
    return words;
}

std::string factorWords(double factor) {
    return local(words::rounded(factor));
}

std::string raysWords(const PlanCost& cost) {
    if (!cost.raysFactor) return std::string(tr("rays unknown"));
    if (std::isinf(*cost.raysFactor)) return std::string(tr("noise, where there was none"));
    if (*cost.raysFactor == 0.0) return std::string(tr("no noise any more"));
    return say("rays \u00d7 {}", factorWords(*cost.raysFactor));
}

std::string timeWords(const PlanCost& cost) {
    const std::optional<double> factor = cost.timeFactor();
    if (!factor || !std::isfinite(*factor) || *factor <= 0.0)
        return say("each ray takes \u00d7 {}", factorWords(cost.timePerRayFactor));
    return say("time \u00d7 {}", factorWords(*factor));
}

std::string costWords(const RequirementCost& row, bool time) {
    const bool number = infoOf(row.id).kind == Switch::number;
    const std::string change = row.to == 0 ? std::string(tr("without it"))
                               : number    ? say("with {}", row.to)
                                           : std::string(tr("with it"));
    if (!row.impossible.empty()) return fmt::format("{}: {}", change, told(row.impossible));
    std::string words = fmt::format("{}: {}, {}", change, lightWords(row.cost), raysWords(row.cost));
    if (time) words += fmt::format(", {}", timeWords(row.cost));
    return words;
}

RequirementLine lineOf(const AppState& state, const RequirementsAnswer& known, RequirementId id) {
    const InstrumentAnswers& answers = *answersOf(state);
    const Requirement& requirement = known.of(id);
    RequirementLine line;
    line.id = id;
    line.title = tr(infoOf(id).title);
    line.on = requirement.on;
    line.value = valueWords(requirement);
    line.reason = fmt::format("{}: {}", tr(groundWord(requirement.ground)), told(requirement.reason));
    if (const auto value = forcedValue(state.instruments, id)) {
        line.forced = true;
        line.value = say("forced: {}", switchedWords(id, *value));
        if (answers.unforced)
            line.reason = fmt::format("{}; {}", say("the scene: {}", valueWords(answers.unforced->of(id))),
                                      line.reason);
    }
    if (!answers.costs) return line;
    for (const RequirementCost& row : answers.costs->rows)
        if (row.id == id) {
            line.costs.push_back(costWords(row, false));
            line.costsByTime.push_back(costWords(row, true));
        }
    return line;
}

std::string wayWords(const Plan& plan, bool eye) {
    const std::string_view from = tr(eye ? "from the eye" : "from the wall"),
                           to = tr(eye ? "to the eye" : "to the wall");
    if (plan.way.photonPass) return say("Store photons from the lights, then look them up {}", from);
    if (plan.way.estimator == "bidirectional")
        return say("Follow paths {} and from the lights, join them in every way, and weigh all", from);
    if (plan.way.lightPass) return say("Send paths from the lights, and join each wall they meet {}", to);
    if (plan.way.mis) return say("Follow paths back {}, ask a light at every wall, and weigh both", from);
    if (plan.way.lightSampling) return say("Follow paths back {}, and ask a light at every wall", from);
    return say("Follow paths back {}, until they meet a light by chance", from);
}

std::string planSentence(const RequirementsAnswer& answer, bool eye) {
    const Plan& plan = answer.plan;
    if (plan.way.estimator == "closed-form")
        return std::string(tr("Take the formula: direct light alone, with nothing in its way."));
    std::string words = wayWords(plan, eye) + ": ";
    words += plan.maxDepth == 0   ? std::string(tr("no scattering"))
             : plan.maxDepth == 1 ? std::string(tr("at most 1 scattering"))
                                  : say("at most {} scatterings", plan.maxDepth);
    if (plan.maxSpecular > 0) words += say(", {} mirrors or skins of glass in a row", plan.maxSpecular);
    if (rouletteOf(plan) > 0) words += tr(", and paths end by chance");
    return words + ".";
}

}  // namespace

const RequirementsAnswer* knownRequirements(const AppState& state) {
    const InstrumentAnswers* answers = answersOf(state);
    if (!answers) return nullptr;
    return answers->requirements ? answers->requirements.get() : answers->unforced.get();
}

std::string_view groundWord(Ground ground) {
    constexpr std::array<std::string_view, 3> kGroundWords{"proof", "measurement", "force"};
    return kGroundWords[static_cast<std::size_t>(ground)];
}

std::optional<std::uint32_t> forcedValue(const InstrumentSettings& settings, RequirementId id) {
    for (const Forced& one : settings.forced)
        if (one.id == id) return one.value;
    return std::nullopt;
}

void force(InstrumentSettings& settings, RequirementId id, std::optional<std::uint32_t> value) {
    std::erase_if(settings.forced, [&](const Forced& one) { return one.id == id; });
    if (value) settings.forced.push_back({id, *value});
    std::sort(settings.forced.begin(), settings.forced.end(),
              [](const Forced& a, const Forced& b) { return a.id < b.id; });
}

std::vector<RequirementLine> requirementLines(const AppState& state) {
    std::vector<RequirementLine> lines;
    const RequirementsAnswer* known = knownRequirements(state);
    if (!known) return lines;
    for (const bool switched : {true, false})
        for (const RequirementInfo& info : kRequirements)
            if ((info.kind != Switch::none) == switched) lines.push_back(lineOf(state, *known, info.id));
    return lines;
}

std::string advice(const AppState& state) {
    const InstrumentAnswers* answers = answersOf(state);
    if (answers && !answers->requirementsRefusal.empty())
        return say("There is no plan: {}.", told(answers->requirementsRefusal));
    if (!answers || !answers->requirements) return std::string(tr("It is being found out."));
    if (!hasLight(*answers->requirements))
        return std::string(tr("There is no light in this scene: nothing has to be carried."));
    return planSentence(*answers->requirements, state.scene->scene.eye.has_value());
}

std::string adviceLacks(const AppState& state) {
    const RequirementsAnswer* planned = plannedOf(state);
    if (!planned) return {};
    if (planned->dark && planned->bounces.patches)
        return std::string(
            tr("No short run met any light, but patches know of some: this plan may lose it."));
    if (planned->dark)
        return std::string(tr("No short run met any light: if there is some, this plan may lose it."));
    if (!planned->loses.empty()) return told(fmt::format("This plan {}.", planned->loses));
    const auto shareOf = [](const std::optional<BeyondDepth>& missing, std::uint32_t followed) {
        return missing && missing->depth == followed ? missing->share : 0.0;
    };
    const double share = shareOf(planned->bounces.missing, planned->plan.maxDepth) +
                         shareOf(planned->specular.missing, planned->plan.maxSpecular);
    if (share > kSeen) return say("It leaves out {:.2g} % of the light.", 100.0 * std::min(1.0, share));
    if (const auto rare = rareLight(*planned))
        return rare->isUnmet
                   ? say("Light is rare here: the short run has not met {:.2g} % of it.", 100.0 * rare->share)
                   : say("Light is rare here: the short run knows it to {:.2g} % only.", 100.0 * rare->share);
    return {};
}

std::string forcedWords(const AppState& state) {
    const InstrumentAnswers* answers = answersOf(state);
    if (!answers || !answers->forcedCost) return {};
    const PlanCost& cost = *answers->forcedCost;
    return say("What is forced costs: {}, {}, {}.", lightWords(cost), raysWords(cost), timeWords(cost));
}

std::string everythingWords(const AppState& state) {
    const InstrumentAnswers* answers = answersOf(state);
    if (!answers || !answers->costs || !answers->costs->complete()) return {};
    if (const std::string& why = answers->costs->everythingImpossible; !why.empty())
        return say("With everything on: {}.", told(why));
    const PlanCost& cost = answers->costs->everything;
    return say("With everything on: {}, {}, {}.", lightWords(cost), raysWords(cost), timeWords(cost));
}

std::optional<Maker> plannedMaker(const AppState& state) {
    const RequirementsAnswer* planned = plannedOf(state);
    if (!planned) return std::nullopt;
    const Plan& plan = planned->plan;
    return Maker{std::string(plan.estimator->id), plan.params,
                 static_cast<std::uint32_t>(std::min<std::uint64_t>(plan.maxDepth, kMostMakerDepth)),
                 plan.maxSpecular};
}

std::string plannedMakerWords(const AppState& state) {
    const RequirementsAnswer* planned = plannedOf(state);
    return planned ? planLine(planned->plan, state.answer->asked.scene->index) : std::string();
}

std::string requirementsWords(const AppState& state) {
    std::string words = advice(state);
    for (const std::string& more : {adviceLacks(state), forcedWords(state)})
        if (!more.empty()) words += fmt::format(" {}", more);
    words += say("\nThe tolerance is {:.3g} %.", 100.0 * state.instruments.tolerance);
    for (const RequirementLine& line : requirementLines(state)) {
        words += fmt::format("\n{}: {}; {}", line.title, line.value, line.reason);
        for (const std::string& cost : line.costsByTime) words += fmt::format("; {}", cost);
    }
    if (const std::string all = everythingWords(state); !all.empty()) words += fmt::format("\n{}", all);
    return words;
}

}  // namespace halfdisk
