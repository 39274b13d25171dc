#include "core/requirements/way_reasons.h"

#include <algorithm>

#include "core/requirements/way_search.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

using words::joined;

/// "path (both) 1.2e+04, light 3e+05": rays to the tolerance of the ways tried.
std::string raysOf(const RequirementsAnswer& answer) {
    std::string text;
    for (const Candidate& candidate : answer.candidates) {
        const Way& way = candidate.plan.way;
        if (!text.empty()) text += ", ";
        text += way.estimator;
        if (!way.emitters.empty()) text += joined(" (", way.emitters, ")");
        if (rouletteOf(candidate.plan) > 0) text += " with roulette";
        // What it doesn't meet it never will, in so few rays.
        const bool never = candidate.lacks || candidate.pilot.mean == 0.0;
        text += never ? std::string(" \u221e")
                      : joined(" ", words::number(candidate.pilot.raysTo(answer.tolerance), 3));
    }
    return text;
}

std::string byRays(const RequirementsAnswer& answer, const std::string& conclusion) {
    return conclusion + "; rays to " + words::percent(answer.tolerance) + " noise: " + raysOf(answer);
}

/// Where there is nothing to compare.
std::string agreeing(const RequirementsAnswer& answer) {
    const bool lacking = std::any_of(answer.candidates.begin(), answer.candidates.end(),
                                     [](const Candidate& candidate) { return candidate.lacks; });
    return lacking ? "ways that bring as much light agree in this" : "all ways tried agree in this";
}

/// Fewest rays of the ways tried, that bring as much light, for which `is` says yes; none: nobody tried.
template <class Is>
std::optional<double> leastRays(const RequirementsAnswer& answer, const Is& is) {
    std::optional<double> least;
    for (const Candidate& candidate : answer.candidates)
        if (!candidate.lacks && candidate.pilot.mean > 0.0 && is(candidate)) {
            const double rays = candidate.pilot.raysTo(answer.tolerance);
            if (!least || rays < *least) least = rays;
        }
    return least;
}

std::string fewer(const std::string& way, double times) {
    if (times < 1.05) return joined(way, " takes about as many rays to the same noise");
    return joined(way, " takes ", words::rounded(times), " times fewer rays to the same noise");
}

/// Whether a way for which `is` says yes carries all light.
template <class Is>
bool isAllCarried(const RequirementsQuestion& question, const RequirementsAnswer& answer, const Is& is) {
    const auto ways = allWays();
    return std::any_of(ways.begin(), ways.end(), [&](const Way& way) {
        return is(way) && isComplete(way, question.index, question.sensor, answer.plan.maxDepth);
    });
}

constexpr const char* kDark = "no way that was tried met any light: the last one is taken";

/// Of ways that do it and others; empty where there are not both.
template <class Is, class IsOther>
std::string compared(const RequirementsAnswer& answer, const Is& is, const IsOther& isOther,
                     const std::string& with, const std::string& without) {
    const auto on = leastRays(answer, is), off = leastRays(answer, isOther);
    if (!on || !off || !(*on > 0.0) || !(*off > 0.0)) return {};
    return *on <= *off ? fewer(with, *off / *on) : fewer(without, *on / *off);
}

template <class Is>
std::string factor(const RequirementsAnswer& answer, const Is& is, const std::string& with,
                   const std::string& without) {
    return compared(
        answer, is, [&](const Candidate& candidate) { return !is(candidate); }, with, without);
}

std::string orElse(const std::string& text, const std::string& other) {
    return text.empty() ? other : text;
}

}  // namespace

std::string lightSamplingReason(const RequirementsAnswer& answer) {
    if (answer.plan.way.estimator == "closed-form")
        return "direct light alone, nothing in its way: a formula gives it";
    if (answer.facts.traits.delta && !answer.plan.way.lightPass)
        return "lights without size can't be met by chance: they must be asked";
    if (answer.dark) return kDark;
    const auto asks = [&](const Candidate& candidate) { return candidate.plan.way.lightSampling; };
    return byRays(answer,
                  orElse(factor(answer, asks, "asking lights", "not asking lights"), agreeing(answer)));
}

std::string misReason(const RequirementsAnswer& answer) {
    if (!answer.facts.traits.area) {
        const std::string why = "no lamp and no environment: no light can be found in two ways";
        if (!answer.plan.way.mis) return why;
        return why + (answer.plan.way.estimator == "bidirectional"
                          ? ", but joined paths can be joined in several"
                          : ", so that weighing them changes nothing");
    }
    if (answer.facts.lampInCorner && answer.plan.way.mis)
        return "a lamp touches a wall that it lights: what a point on it brings has no bound there, and rays "
               "that meet "
               "it by chance must share it";
    if (answer.plan.way.estimator == "closed-form")
        return "a formula gives all the light: nothing is weighed";
    if (answer.dark) return kDark;
    if (answer.plan.way.lightPass)
        return answer.plan.way.mis ? "paths from both ends find the same light in many ways, which share it"
                                   : "paths from the lights find all light in one way";
    // Looking back from the sensor: what paths from both ends gain is not the weights' merit.
    const auto weighs = [](bool mis) {
        return [=](const Candidate& candidate) {
            return candidate.plan.way.mis == mis && !candidate.plan.way.lightPass;
        };
    };
    return orElse(compared(answer, weighs(true), weighs(false), "weighing two ways", "one way alone"),
                  agreeing(answer));
}

std::string lightPassReason(const RequirementsQuestion& question, const RequirementsAnswer& answer) {
    const SceneTraits& has = answer.facts.traits;
    if (has.delta && has.specular && has.scattering)
        return "mirrors or glass send light of point or directional lights on walls: paths from the sensor "
               "never "
               "find it";
    if (answer.plan.maxDepth == 0 && !answer.plan.way.lightPass)
        return "light is not scattered before it arrives";
    if (has.delta && forcedTo(question, RequirementId::lightSampling) == 0u)
        return "lights without size are not asked, and paths from the sensor never meet them";
    if (!isAllCarried(question, answer, [](const Way& way) { return !way.lightPass; }))
        return "paths from the sensor don't find all light";
    if (answer.dark) return kDark;
    const auto sends = [](const Candidate& candidate) { return candidate.plan.way.lightPass; };
    if (!has.specular || !question.forced.empty() || answer.candidates.size() > 1)
        return orElse(
            factor(answer, sends, "sending paths from the lights", "looking back from the sensor alone"),
            answer.plan.way.lightPass ? "paths from the sensor find all light as well"
                                      : "paths from the sensor find all light");
    return "paths from the sensor find all light";
}

std::string photonReason(const RequirementsQuestion& question, const RequirementsAnswer& answer) {
    const auto storing = [](const Way& way) { return way.photonPass; };
    const bool others =
        isAllCarried(question, answer, [&](const Way& way) { return !storing(way) && way.unbiased; });
    if (answer.plan.way.photonPass)
        return others ? "storing photons blurs light that other ways carry as well"
                      : "no way without stored photons carries all paths: caustics of lights without size, "
                        "seen in mirrors or through glass";
    if (others) return "ways without bias carry all light: storing photons would blur it";
    return isAllCarried(question, answer, storing) ? "only stored photons would carry all light"
                                                   : "no way carries all light, storing photons neither";
}

std::string rouletteReason(const RequirementsAnswer& answer) {
    if (!answer.plan.way.roulette) return "there are no paths to end";
    if (answer.plan.maxDepth == 0) return "paths end at the first scattering";
    const auto ends = [](const Candidate& candidate) { return rouletteOf(candidate.plan) > 0; };
    const Candidate *on = nullptr, *off = nullptr;
    for (const Candidate& candidate : answer.candidates)
        if (candidate.plan.way == answer.plan.way) (ends(candidate) ? on : off) = &candidate;
    if (answer.dark) return kDark;
    if (!on) return "ending paths by chance was not tried";
    if (!off) return "following paths to their end was not tried";
    if (on->lacks) return "ending paths by chance met less light";
    if (off->lacks) return "following paths to their end met less light";
    const double ended = on->pilot.raysTo(answer.tolerance), followed = off->pilot.raysTo(answer.tolerance);
    const bool ending = ended < followed;
    const std::string reason = ending ? fewer("ending paths by chance", followed / ended)
                                      : fewer("following paths to their end", ended / followed);
    return ending == ends(*(on->chosen ? on : off)) ? reason : reason + ", but so few rays are no cost";
}

}  // namespace halfdisk
