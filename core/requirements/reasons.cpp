#include "core/requirements/reasons.h"

#include <algorithm>

#include "core/requirements/bounce_findings.h"
#include "core/requirements/specular_findings.h"
#include "core/requirements/way_reasons.h"
#include "core/requirements/way_search.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

using words::counted;

std::string lightsReason(const SceneFacts& facts) {
    if (!facts.traits.delta) return "no point and no directional light";
    std::string lights;
    if (facts.points > 0) lights += counted(facts.points, "point light");
    if (facts.points > 0 && facts.suns > 0) lights += ", ";
    if (facts.suns > 0) lights += counted(facts.suns, "directional light");
    return lights + ", which no ray meets by chance";
}

std::string indexReason(const RequirementsQuestion& question) {
    return counted(question.index.scene().segments.size(), "wall") + ": " +
           std::string(nameOf(kIndexMethods, question.index.method())) + " is fastest for so many";
}

}  // namespace

std::vector<Requirement> requirementRows(const RequirementsQuestion& question,
                                         const RequirementsAnswer& answer) {
    const SceneFacts& facts = answer.facts;
    std::vector<Requirement> rows;
    const auto add = [&](RequirementId id, bool on, std::string reason, Ground ground,
                         std::optional<std::uint32_t> number = std::nullopt) {
        for (const Forced& forced : question.forced)
            if (forced.id == id) ground = Ground::force;
        rows.push_back({id, on, number, ground, std::move(reason)});
    };
    const auto planned = [&](RequirementId id, std::string reason, Ground ground = Ground::measurement) {
        add(id, valueIn(answer.plan, id, facts.traits, question.index) != 0, std::move(reason), ground);
    };
    add(RequirementId::deltaLights, facts.traits.delta, lightsReason(facts), Ground::proof);
    add(RequirementId::areaLights, facts.lamps > 0, counted(facts.lamps, "lamp"), Ground::proof);
    add(RequirementId::environment, facts.environment,
        facts.environment ? "the environment shines" : "the environment is black", Ground::proof);
    const RequirementsAnswer::Escapes escapes = answer.escapes;
    add(RequirementId::open, escapes.left > 0,
        std::to_string(escapes.left) + " of " + std::to_string(escapes.tried) +
            " rays that left a wall met no other",
        escapes.left > 0 ? Ground::proof : Ground::measurement);
    add(RequirementId::specular, answer.plan.maxSpecular > 0, specularReason(answer),
        answer.specular.measured.empty() ? Ground::proof : Ground::measurement, answer.plan.maxSpecular);
    add(RequirementId::glossy, facts.glossy > 0,
        facts.glossy > 0 ? counted(facts.glossy, "glossy wall") + ", the sharpest with exponent " +
                               words::number(facts.mostExponent, 4)
                         : "no wall is glossy",
        Ground::proof);
    add(RequirementId::bounces, answer.plan.maxDepth > 0,
        facts.traits.delta || facts.traits.area
            ? bouncesReason(answer.bounces, facts, answer.tolerance,
                            specularShare(answer.specular, answer.tolerance))
            : "there is no light",
        facts.mostAlbedo == 0.0 ? Ground::proof : Ground::measurement, answer.plan.maxDepth);
    planned(RequirementId::lightSampling, lightSamplingReason(answer),
            facts.traits.delta ? Ground::proof : Ground::measurement);
    planned(RequirementId::mis, misReason(answer), facts.traits.area ? Ground::measurement : Ground::proof);
    planned(RequirementId::lightPass, lightPassReason(question, answer));
    planned(RequirementId::photonPass, photonReason(question, answer), Ground::proof);
    planned(RequirementId::roulette, rouletteReason(answer));
    planned(RequirementId::index, indexReason(question), Ground::proof);
    add(RequirementId::colour, !facts.grey,
        facts.grey ? "all lights and walls are grey: one channel would do"
                   : "lights or walls differ by channel",
        Ground::proof);
    add(RequirementId::doublePrecision, true,
        "single precision proposes walls and double precision decides which one is met", Ground::proof);
    return rows;
}

}  // namespace halfdisk
