#include "app/requirements_text.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "app/estimator_arguments.h"
#include "app/render_result.h"
#include "app/requirements_arguments.h"
#include "core/requirements/series.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

constexpr std::size_t kWidth = 100;  // columns
constexpr std::string_view kDark = "no short run met any light; if there is some, the plan may lose it";
constexpr std::array<std::string_view, 3> kGrounds{"proof", "measurement", "force"};

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

std::string_view methodOf(const Plan& plan, const SegmentIndex& index) {
    return nameOf(kIndexMethods, plan.index == IndexMethod::automatic ? index.method() : plan.index);
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

/// `off`, `on` or the number.
std::string switched(RequirementId id, std::uint32_t value) {
    if (infoOf(id).kind == Switch::number && value > 0) return std::to_string(value);
    return value > 0 ? "on" : "off";
}

Json costJson(const PlanCost& cost, const SegmentIndex& index) {
    Json object = planJson(cost.plan, index);
    object["change"] = jsonOf(cost.change);
    object["changeError"] = jsonOf(cost.changeError);
    object["changeOfPixels"] = jsonOf(cost.changeOfPixels);
    object["raysFactor"] = jsonOf(cost.raysFactor);
    object["timePerRayFactor"] = jsonOf(cost.timePerRayFactor);
    object["timeFactor"] = jsonOf(cost.timeFactor());
    return object;
}

std::string costLine(const std::string& what, const PlanCost& cost) {
    const std::string pixels =
        cost.changeOfPixels > 0.0 ? fmt::format("{:.2g} %", 100.0 * cost.changeOfPixels) : "-";
    const std::string change =
        fmt::format("{:+.2f} ± {:.2f} %", 100.0 * cost.change, 200.0 * cost.changeError);
    // Between noise and no noise there is no factor.
    const auto factor = [](double value) {
        return std::isfinite(value) && value > 0.0 ? fmt::format("{:.3g}", value) : std::string("-");
    };
    return fmt::format("{:<24} {:>20} {:>8} {:>10} {:>10.2f} {:>10}  {}\n", what, change, pixels,
                       factor(cost.raysFactor), cost.timePerRayFactor, factor(cost.timeFactor()),
                       cost.plan.estimator->id);
}

Json sharesJson(const std::vector<BeyondDepth>& shares) {
    Json rows = Json::array();
    for (const BeyondDepth& beyond : shares)
        rows.push_back({{"depth", beyond.depth},
                        {"beyond", jsonOf(beyond.share)},
                        {"standardError", jsonOf(beyond.standardError)}});
    return rows;
}

Json bouncesJson(const BounceFindings& bounces) {
    Json object;
    object["depth"] = bounces.depth;
    object["byAlbedo"] = bounces.byAlbedo ? Json(*bounces.byAlbedo) : Json();
    object["byRadius"] = bounces.byRadius ? Json(*bounces.byRadius) : Json();
    object["spectralRadius"] = bounces.patches ? jsonOf(bounces.patches->spectralRadius) : Json();
    object["patches"] = bounces.patches ? Json(bounces.patches->patches) : Json();
    object["byPatches"] = sharesJson(bounces.patches ? bounces.patches->beyond : std::vector<BeyondDepth>());
    object["measured"] = sharesJson(bounces.measured);
    return object;
}

Json candidatesJson(const RequirementsAnswer& answer, const SegmentIndex& index) {
    Json rows = Json::array();
    for (const Candidate& candidate : answer.candidates) {
        Json row = planJson(candidate.plan, index);
        // What lacks light has no number: its noise says nothing of what it has not met.
        row["raysToTolerance"] =
            candidate.lacks || answer.dark ? Json() : jsonOf(candidate.pilot.raysTo(answer.tolerance));
        row["secondsPerRay"] = jsonOf(candidate.pilot.secondsPerRay());
        row["raysTried"] = candidate.pilot.rays;
        row["chosen"] = candidate.chosen;
        rows.push_back(row);
    }
    return rows;
}

/// Empty, or that light is missing, or may be.
std::string lostSentence(const RequirementsAnswer& answer) {
    const std::string lost = lostWords(answer);
    return lost.empty() || lost == kDark ? lost : "light is missing: " + lost;
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

bool isPlanned(const RequirementsAnswer& answer) {
    return !answer.requirements.empty();
}

std::string requirementValue(const Requirement& requirement) {
    if (requirement.number && requirement.on) return std::to_string(*requirement.number);
    return requirement.on ? "on" : "off";
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

std::string planOptions(const Plan& plan) {
    std::string line = fmt::format("--estimator {}", plan.estimator->id);
    for (std::size_t i = 0; i < plan.params.size(); ++i) {
        const ParamInfo& param = plan.estimator->params[i];
        line += fmt::format(" --param {}={}", param.name, paramText(param, plan.params[i]));
    }
    return line + fmt::format(" --depth {} --specular {}", plan.maxDepth, plan.maxSpecular);
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
    if (const std::string lost = lostSentence(answer); !lost.empty()) text += "NOTE: " + wrapped(lost, 6);
    if (const auto rare = rareLight(answer))
        text += "NOTE: " +
                wrapped(fmt::format("light is so rare here that the plan's short run {}: what is "
                                    "told above may be far off",
                                    rare->isUnmet
                                        ? fmt::format("has not met {:.2g} % of what patches know of",
                                                      100.0 * rare->share)
                                        : fmt::format("knows it to ± {:.2g} % only", 100.0 * rare->share)),
                        6);
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

std::string lostWords(const RequirementsAnswer& answer) {
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
    if (lost.empty() && answer.dark) return std::string(kDark);
    return fmt::format("{}", fmt::join(lost, "; "));
}

std::string lostWarning(const RequirementsAnswer& answer) {
    const std::string lost = lostSentence(answer);
    return lost.empty() ? lost : fmt::format("\nWARNING: {}\n", lost);
}

void tellLost(const RequirementsAnswer& answer, Json& result) {
    const std::string lost = lostWords(answer);
    result["loses"] = lost.empty() ? Json() : Json(lost);
}

std::string costsText(const Costs& costs) {
    std::string text = fmt::format("\n{:<24} {:>19} {:>8} {:>10} {:>10} {:>10}\n", "what a change costs",
                                   "light", "pixels", "rays", "time/ray", "time");
    for (const RequirementCost& row : costs.rows) {
        const std::string what = fmt::format("{} {} -> {}", infoOf(row.id).name, switched(row.id, row.from),
                                             switched(row.id, row.to));
        text += row.impossible.empty() ? costLine(what, row.cost)
                                       : fmt::format("{:<24} {}", what, wrapped(row.impossible, 25));
    }
    if (costs.complete()) text += costLine("everything on", costs.everything);
    text += wrapped(fmt::format("light: change of the mean, ± 2 standard errors; pixels: root mean square of "
                                "their changes, where "
                                "noise does not hide it; rays: to the same noise (-: one of the two has "
                                "none); time: rays times time per "
                                "ray, on this machine, "
                                "now. The plan itself: {:.3g} ns per ray.",
                                1e9 * costs.plan.secondsPerRay()),
                    0);
    return text;
}

Json costsJson(const Costs& costs, const SegmentIndex& index) {
    Json object;
    object["secondsPerRay"] = jsonOf(costs.plan.secondsPerRay());
    object["rows"] = Json::array();
    for (const RequirementCost& row : costs.rows) {
        Json line = row.impossible.empty() ? costJson(row.cost, index) : Json::object();
        line["id"] = std::string(infoOf(row.id).name);
        line["from"] = switched(row.id, row.from);
        line["to"] = switched(row.id, row.to);
        line["impossible"] = row.impossible.empty() ? Json() : Json(row.impossible);
        line["words"] = row.words;
        object["rows"].push_back(line);
    }
    object["complete"] = costs.complete();
    object["everything"] = costs.complete() ? costJson(costs.everything, index) : Json();
    return object;
}

Json planJson(const Plan& plan, const SegmentIndex& index) {
    Json object;
    object["estimator"] = std::string(plan.estimator->id);
    object["parameters"] = paramsJson(*plan.estimator, plan.params);
    object["depth"] = plan.maxDepth;
    object["specular"] = plan.maxSpecular;
    object["index"] = std::string(methodOf(plan, index));
    return object;
}

Json requirementsJson(const RequirementsAnswer& answer, const SegmentIndex& index) {
    Json object;
    object["tolerance"] = jsonOf(answer.tolerance);
    object["paths"] = Json::array();
    for (const PathType& type : answer.pathTypes)
        if (type.exists)
            object["paths"].push_back(
                {{"word", std::string(type.word)}, {"meaning", std::string(type.meaning)}});
    object["requirements"] = Json::array();
    for (const Requirement& requirement : answer.requirements)
        object["requirements"].push_back(
            {{"id", std::string(infoOf(requirement.id).name)},
             {"title", std::string(infoOf(requirement.id).title)},
             {"on", requirement.on},
             {"number", requirement.number ? Json(*requirement.number) : Json()},
             {"by", std::string(kGrounds[static_cast<std::size_t>(requirement.ground)])},
             {"switchable", infoOf(requirement.id).kind != Switch::none},
             {"reason", requirement.reason}});
    object["specular"] = {{"events", answer.specular.required},
                          {"measured", sharesJson(answer.specular.measured)}};
    object["bounces"] = bouncesJson(answer.bounces);
    object["complete"] = isPlanned(answer);
    object["plan"] = isPlanned(answer) ? planJson(answer.plan, index) : Json();
    tellLost(answer, object);
    object["tried"] = candidatesJson(answer, index);
    const auto rare = rareLight(answer);
    object["dark"] = answer.dark;
    object["lightKnownTo"] = rare ? jsonOf(rare->share) : Json();
    object["rays"] = answer.rays;
    object["seconds"] = jsonOf(answer.seconds);
    return object;
}

}  // namespace halfdisk
