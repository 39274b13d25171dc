#include "app/requirements_json.h"

#include "app/plan_words.h"
#include "app/render_result.h"
#include "app/requirements_text.h"
#include "core/requirements/series.h"

namespace halfdisk {
namespace {

constexpr std::array<std::string_view, 3> kGrounds{"proof", "measurement", "force"};

Json costJson(const PlanCost& cost, const std::string& impossible, const SegmentIndex& index) {
    if (!impossible.empty()) return {{"impossible", impossible}};
    Json object = planJson(cost.plan, index);
    object["impossible"] = Json();
    const auto& change = cost.change;
    object["change"] = change ? jsonOf(change->share) : Json();
    object["changeError"] = change ? jsonOf(change->standardError) : Json();
    object["changeOfPixels"] = change ? jsonOf(change->ofPixels) : Json();
    object["raysFactor"] = cost.raysFactor ? jsonOf(*cost.raysFactor) : Json();
    object["timePerRayFactor"] = jsonOf(cost.timePerRayFactor);
    object["timeFactor"] = cost.timeFactor() ? jsonOf(*cost.timeFactor()) : Json();
    return object;
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

}  // namespace

void tellLost(const RequirementsAnswer& answer, Json& result) {
    const std::string lost = lostWords(answer);
    result["loses"] = lost.empty() ? Json() : Json(lost);
}

Json costsJson(const Costs& costs, const SegmentIndex& index) {
    Json object;
    object["secondsPerRay"] = jsonOf(costs.plan.secondsPerRay());
    object["rows"] = Json::array();
    for (const RequirementCost& row : costs.rows) {
        Json line = costJson(row.cost, row.impossible, index);
        line["id"] = std::string(infoOf(row.id).name);
        line["from"] = switchedValue(row.id, row.from);
        line["to"] = switchedValue(row.id, row.to);
        line["words"] = row.words;
        object["rows"].push_back(line);
    }
    object["complete"] = costs.complete();
    object["everything"] =
        costs.complete() ? costJson(costs.everything, costs.everythingImpossible, index) : Json();
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
