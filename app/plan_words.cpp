#include "app/plan_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/estimator_arguments.h"
#include "core/requirements/series.h"

namespace halfdisk {
namespace {

/// Of an answer without light: that the plan is a guess.
std::string darkWords(const RequirementsAnswer& answer) {
    return answer.bounces.patches
               ? "no short run met any light, but patches know of some; the plan may lose it"
               : "no short run met any light; if there is some, the plan may lose it";
}

/// What is surely missing; may be empty.
std::string missingWords(const RequirementsAnswer& answer) {
    std::vector<std::string> lost;
    if (!answer.loses.empty()) lost.push_back(fmt::format("the plan {}", answer.loses));
    const auto add = [&](const std::optional<BeyondDepth>& missing, std::uint32_t followed,
                         std::string_view what) {
        if (!missing || missing->depth != followed || isEnough(*missing, answer.tolerance)) return;
        lost.push_back(fmt::format("after {} {}, where paths are cut, comes {}", what, missing->depth,
                                   shareWords(*missing, answer.tolerance)));
    };
    add(answer.specular.missing, answer.plan.maxSpecular, "mirror or glass event");
    add(answer.bounces.missing, answer.plan.maxDepth, "bounce");
    return fmt::format("{}", fmt::join(lost, "; "));
}

}  // namespace

std::string_view methodOf(const Plan& plan, const SegmentIndex& index) {
    return nameOf(kIndexMethods, plan.index == IndexMethod::automatic ? index.method() : plan.index);
}

std::string planLine(const Plan& plan, const SegmentIndex& index) {
    std::string line = fmt::format("estimator {}", plan.estimator->id);
    for (std::size_t i = 0; i < plan.params.size(); ++i) {
        const ParamInfo& param = plan.estimator->params[i];
        line += fmt::format(", {} = {}", param.name, paramText(param, plan.params[i]));
    }
    return line + fmt::format("; depth {}, specular {}, walls by {}", plan.maxDepth, plan.maxSpecular,
                              methodOf(plan, index));
}

bool isPlanned(const RequirementsAnswer& answer) {
    return !answer.requirements.empty();
}

std::string lostWords(const RequirementsAnswer& answer) {
    const std::string missing = missingWords(answer);
    return missing.empty() && answer.dark ? darkWords(answer) : missing;
}

std::string lostSentence(const RequirementsAnswer& answer) {
    const std::string missing = missingWords(answer);
    if (!missing.empty()) return "light is missing: " + missing;
    return answer.dark ? darkWords(answer) : std::string();
}

std::string rareSentence(const RequirementsAnswer& answer) {
    const auto rare = rareLight(answer);
    if (!rare) return {};
    const std::string share = fmt::format("{:.2g} %", 100.0 * rare->share),
                      known = rare->isUnmet ? fmt::format("has not met {} of what patches know of", share)
                                            : fmt::format("knows it to ± {} only", share),
                      // Shares by patches don't rest on short runs.
        wrong = answer.bounces.patches ? "the rays told above may be far too few"
                                       : "what is told above may be far off, and the rays far too few";
    return fmt::format("light is so rare here that the plan's short run {}: {}", known, wrong);
}

std::string lostWarning(const RequirementsAnswer& answer) {
    const std::string lost = lostSentence(answer);
    return lost.empty() ? lost : fmt::format("\nWARNING: {}\n", lost);
}

}  // namespace halfdisk
