#include "app/requirements_text.h"

#include <fmt/format.h>

#include <sstream>

#include "app/estimator_arguments.h"
#include "app/render_result.h"

namespace halfdisk {
namespace {

constexpr std::size_t kWidth = 100;  // columns
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

Json bouncesJson(const BounceFindings& bounces) {
    Json object;
    object["depth"] = bounces.depth;
    object["byAlbedo"] = bounces.byAlbedo ? Json(*bounces.byAlbedo) : Json();
    object["byRadius"] = bounces.byRadius ? Json(*bounces.byRadius) : Json();
    object["spectralRadius"] = bounces.patches ? jsonOf(bounces.patches->spectralRadius) : Json();
    object["patches"] = bounces.patches ? Json(bounces.patches->patches) : Json();
    object["byPatches"] = Json::array();
    if (bounces.patches)
        for (const double share : bounces.patches->beyond) object["byPatches"].push_back(jsonOf(share));
    object["measured"] = Json::array();
    for (const BeyondDepth& beyond : bounces.measured)
        object["measured"].push_back({{"depth", beyond.depth},
                                      {"beyond", jsonOf(beyond.share)},
                                      {"standardError", jsonOf(beyond.standardError)}});
    return object;
}

Json candidatesJson(const RequirementsAnswer& answer, const SegmentIndex& index) {
    Json rows = Json::array();
    for (const Candidate& candidate : answer.candidates) {
        Json row = planJson(candidate.plan, index);
        row["raysToTolerance"] = jsonOf(candidate.pilot.raysTo(answer.tolerance));
        row["secondsPerRay"] = jsonOf(candidate.pilot.secondsPerRay());
        row["raysTried"] = candidate.pilot.rays;
        row["chosen"] = candidate.chosen;
        rows.push_back(row);
    }
    return rows;
}

}  // namespace

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
    for (const Requirement& requirement : answer.requirements) {
        text += fmt::format("{:<17} {:>6}  ", infoOf(requirement.id).name, requirementValue(requirement));
        text +=
            wrapped(requirement.reason + (requirement.ground == Ground::force ? " [forced]" : ""), kColumn);
    }
    text += "\nplan: " + wrapped(planLine(answer.plan, index), 6);
    if (!answer.loses.empty()) text += "NOTE: " + wrapped(fmt::format("this plan {}", answer.loses), 6);
    text += fmt::format("found with {} rays in {:.2g} s\n", answer.rays, answer.seconds);
    return text;
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
    object["bounces"] = bouncesJson(answer.bounces);
    object["plan"] = planJson(answer.plan, index);
    object["loses"] = answer.loses.empty() ? Json() : Json(answer.loses);
    object["tried"] = candidatesJson(answer, index);
    object["rays"] = answer.rays;
    object["seconds"] = jsonOf(answer.seconds);
    return object;
}

}  // namespace halfdisk
