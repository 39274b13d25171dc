#include "app/requirements_text.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "app/plan_words.h"
#include "app/requirements_arguments.h"

namespace halfdisk {
namespace {

constexpr std::size_t kWidth = 100;  // columns

/// Words in lines that start at a column; the first line is there already.
std::string wrapped(const std::string& text, std::size_t column) {
    std::string lines;
    std::size_t at = column;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (at > column && at + 1 + word.size() > kWidth) {
            lines += '\n';
            lines.append(column, ' ');
            at = column;
        } else if (at > column) {
            lines += ' ';
            ++at;
        }
        lines += word;
        at += word.size();
    }
    return lines + "\n";
}

std::string pathTypesText(const RequirementsAnswer& answer) {
    std::string text = "Light that there is:\n";
    bool any = false;
    for (const PathType& type : answer.pathTypes)
        if (type.exists) {
            text += fmt::format("  {:<13} {}\n", type.word, type.meaning);
            any = true;
        }
    return any ? text : "There is no light.\n";
}

std::string costLine(const std::string& what, const PlanCost& cost) {
    const auto& change = cost.change;
    const std::string pixels =
        change && change->ofPixels > 0.0 ? fmt::format("{:.2g} %", 100.0 * change->ofPixels) : "-";
    const std::string light =
        change ? fmt::format("{:+.2f} ± {:.2f} %", 100.0 * change->share, 200.0 * change->standardError)
               : "none met";
    // Between noise and no noise there is no factor.
    const auto factor = [](std::optional<double> value) {
        return value && std::isfinite(*value) && *value > 0.0 ? fmt::format("{:.3g}", *value)
                                                              : std::string("-");
    };
    return fmt::format("{:<24} {:>20} {:>8} {:>10} {:>10.2f} {:>10}  {}\n", what, light, pixels,
                       factor(cost.raysFactor), cost.timePerRayFactor, factor(cost.timeFactor()),
                       cost.plan.estimator->id);
}

/// Of an answer that was called off: what was tried until then.
std::string triedText(const RequirementsAnswer& answer, const SegmentIndex& index) {
    std::string text;
    for (const Candidate& candidate : answer.candidates)
        text +=
            fmt::format("tried: {}: {:.3g} rays until the noise is {:g} %\n", planLine(candidate.plan, index),
                        candidate.pilot.raysTo(answer.tolerance), 100.0 * answer.tolerance);
    return text;
}

}  // namespace

std::string requirementValue(const Requirement& requirement) {
    if (requirement.number && requirement.on) return std::to_string(*requirement.number);
    return requirement.on ? "on" : "off";
}

std::string switchedValue(RequirementId id, std::uint32_t value) {
    if (infoOf(id).kind == Switch::number && value > 0) return std::to_string(value);
    return value > 0 ? "on" : "off";
}

std::string requirementsText(const RequirementsAnswer& answer, const SegmentIndex& index) {
    constexpr std::size_t kColumn = 26;
    std::string text = pathTypesText(answer) + "\n";
    if (!isPlanned(answer)) return text + triedText(answer, index);
    for (const Requirement& requirement : answer.requirements) {
        text += fmt::format("{:<17} {:>6}  ", infoOf(requirement.id).name, requirementValue(requirement));
        text +=
            wrapped(requirement.reason + (requirement.ground == Ground::force ? " [forced]" : ""), kColumn);
    }
    text += "\nplan: " + wrapped(planLine(answer.plan, index), 6);
    for (const std::string& note : {lostSentence(answer), rareSentence(answer)})
        if (!note.empty()) text += "NOTE: " + wrapped(note, 6);
    text += fmt::format("found with {} rays in {:.2g} s\n", answer.rays, answer.seconds);
    return text;
}

std::string explanation(const RequirementsAnswer& answer, const SegmentIndex& index,
                        std::string_view estimator) {
    std::string text = estimator == kAutomatic
                           ? std::string()
                           : fmt::format("{} was asked for; this is what auto would do:\n\n", estimator);
    return text + requirementsText(answer, index) + "\n";
}

std::string costsText(const Costs& costs) {
    std::string text = fmt::format("\n{:<24} {:>19} {:>8} {:>10} {:>10} {:>10}\n", "what a change costs",
                                   "light", "pixels", "rays", "time/ray", "time");
    const auto add = [&](const std::string& what, const PlanCost& cost, const std::string& impossible) {
        text += impossible.empty() ? costLine(what, cost)
                                   : fmt::format("{:<24} {}", what, wrapped(impossible, 25));
    };
    for (const RequirementCost& row : costs.rows)
        add(fmt::format("{} {} -> {}", infoOf(row.id).name, switchedValue(row.id, row.from),
                        switchedValue(row.id, row.to)),
            row.cost, row.impossible);
    if (costs.complete()) add("everything on", costs.everything, costs.everythingImpossible);
    text += wrapped(fmt::format("light: change of the mean, ± 2 standard errors; pixels: root mean square of "
                                "their changes, where "
                                "noise does not hide it; rays: to the same noise (-: one of the two has "
                                "none, or met no light); time: rays times time per "
                                "ray, on this machine, "
                                "now. The plan itself: {:.3g} ns per ray.",
                                1e9 * costs.plan.secondsPerRay()),
                    0);
    return text;
}

}  // namespace halfdisk
