#include "core/requirements/requirements.h"

#include <algorithm>
#include <stdexcept>

#include "core/requirements/bounce_findings.h"
#include "core/requirements/reasons.h"
#include "core/requirements/specular_findings.h"
#include "core/requirements/way_search.h"
#include "core/requirements/words.h"
#include "core/stopwatch.h"

namespace halfdisk {
namespace {

std::vector<PathType> pathTypesOf(const SceneFacts& facts, const Sensor& sensor) {
    const SceneTraits& has = facts.traits;
    const bool light = has.delta || has.area, matt = has.scattering && facts.mostAlbedo > 0.0;
    // A ray that is aimed meets no light without size.
    const bool aimed = std::holds_alternative<EyeStrip>(sensor) || std::holds_alternative<Look>(sensor);
    const bool straight = aimed ? has.area : light;
    return {
        {"LE", "light straight from its source", straight},
        {"LD+E", "light that walls scatter", light && matt},
        {"LS+E", "light sources seen in mirrors or through glass", straight && has.specular},
        {"LS+D(S|D)*E", "caustics: light that mirrors or glass send on walls", light && has.specular && matt},
        {"L(S|D)*DS+E", "walls seen in mirrors or through glass", light && has.specular && matt},
        {"LS+DS+E", "caustics seen in mirrors or through glass", light && has.specular && matt},
    };
}

RequirementsAnswer::Escapes escapesOf(const SegmentIndex& index) {
    constexpr std::uint32_t kRays = 2048;
    RequirementsAnswer::Escapes escapes;
    const auto& walls = index.scene().segments;
    if (walls.empty()) return escapes;
    const Rng rng(1, 0);
    for (; escapes.tried < kRays; ++escapes.tried) {
        const std::uint32_t k = escapes.tried;
        const auto segment = static_cast<std::uint32_t>(std::uint64_t{k} * walls.size() / kRays);
        const Scattered way = sampleDiffuse({Rgb(1.0)}, index.normal(segment), rng.uniform(k, 1));
        const Vec2 P = index.pointOn(segment, rng.uniform(k, 0));
        if (!index.closestHit({originOff(index, segment, P, way.direction), way.direction, segment}))
            ++escapes.left;
    }
    return escapes;
}

void cutAt(std::uint32_t depth, BounceFindings& bounces) {
    bounces.depth = depth;
    bounces.missing = shareBeyondDepth(bounces, depth);
}

// What is tried must not be what is then shown: choosing by the same random numbers would favour them.
std::uint64_t tried(std::uint64_t seed) {
    return ~seed;
}

/// Sets `seconds` when it ends, also if the work is called off.
class Timed {
 public:
    explicit Timed(double& seconds) : seconds_(seconds) {}
    ~Timed() { seconds_ = watch_.seconds(); }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

 private:
    double& seconds_;
    Stopwatch watch_;
};

void refuseForced(const RequirementsQuestion& question) {
    for (const Forced& forced : question.forced) {
        const RequirementInfo& info = infoOf(forced.id);
        if (info.kind == Switch::none)
            throw std::invalid_argument(words::joined(info.name, " can't be switched: ", info.fixed));
    }
}

std::optional<BeyondDepth> missingChains(const RequirementsQuestion& question, const Sensor& small,
                                         RequirementsAnswer& answer) {
    if (!answer.facts.traits.specular || !hasLight(answer)) return std::nullopt;
    const RequirementsQuestion asked{.index = question.index,
                                     .sensor = small,
                                     .tolerance = question.tolerance,
                                     .seed = question.seed,
                                     .stop = question.stop,
                                     .effort = question.effort};
    return beyondEvents(asked, answer.specular, answer.series, answer.plan.maxSpecular, answer.rays);
}

/// Chooses the way, from what is known of the scene.
void choosePlan(const RequirementsQuestion& question, RequirementsAnswer& answer) {
    RequirementsQuestion asked = question;
    asked.seed = tried(question.seed);
    answer.candidates.clear();
    answer.loses.clear();
    answer.dark = false;
    answer.plan = {};
    answer.plan.maxSpecular = forcedTo(asked, RequirementId::specular).value_or(answer.specular.required);
    if (const auto index = forcedTo(asked, RequirementId::index))
        answer.plan.index = *index != 0 ? IndexMethod::tree : IndexMethod::bruteForce;
    cutAt(forcedTo(asked, RequirementId::bounces).value_or(answer.bounces.required), answer.bounces);
    const Sensor small = pilotSensor(asked.sensor);
    answer.specular.missing = missingChains(asked, small, answer);
    searchWay(asked, small, answer);
    answer.requirements = requirementRows(asked, answer);
}

}  // namespace

std::optional<RareLight> rareLight(const RequirementsAnswer& answer) {
    constexpr double kRare = 0.1;
    for (const Candidate& candidate : answer.candidates) {
        if (!candidate.chosen) continue;
        const double known = knownLight(answer.bounces, answer.plan.maxDepth);
        const double unmet =
            known > 0.0 && (candidate.lacks || answer.dark) ? 1.0 - candidate.pilot.mean / known : 0.0;
        // Where nothing was met and nothing is known there may be none.
        const double error = candidate.pilot.mean > 0.0 ? lightError(candidate.pilot) : 0.0;
        if (std::max(error, unmet) > kRare) return RareLight{std::max(error, unmet), unmet > error};
    }
    return std::nullopt;
}

RequirementsAnswer requirementsOf(const RequirementsQuestion& question) {
    RequirementsAnswer answer;
    findRequirements(question, answer);
    return answer;
}

void findRequirements(const RequirementsQuestion& question, RequirementsAnswer& answer) {
    answer = {};
    const Timed timed(answer.seconds);
    refuseForced(question);
    if (const std::string fault = faultOf(question.sensor, question.index); !fault.empty())
        throw std::invalid_argument(fault);
    const Sensor small = pilotSensor(question.sensor);
    answer.tolerance = question.tolerance;
    answer.facts = factsOf(question.index.scene());
    answer.pathTypes = pathTypesOf(answer.facts, question.sensor);
    answer.escapes = escapesOf(question.index);
    if (question.told) question.told(0.0, "bounces");
    RequirementsQuestion first{.index = question.index,
                               .sensor = small,
                               .tolerance = question.tolerance,
                               .forced = {},
                               .seed = tried(question.seed),
                               .stop = question.stop,
                               .effort = question.effort};
    if (hasLight(answer)) answer.series = seriesOf(first, answer.facts.traits, answer.rays);
    answer.specular = findSpecular(first, answer.facts, answer.series, answer.rays);
    first.tolerance -= specularShare(answer.specular, question.tolerance);
    if (answer.series) answer.series->plan.maxSpecular = answer.specular.required;
    if (hasLight(answer)) answer.bounces = findBounces(first, answer.facts, answer.series, answer.rays);
    choosePlan(question, answer);
}

RequirementsAnswer replanned(const RequirementsQuestion& question, const RequirementsAnswer& known) {
    refuseForced(question);
    RequirementsAnswer answer = known;
    {
        const Timed timed(answer.seconds);
        choosePlan(question, answer);
    }
    return answer;
}

std::uint32_t valueIn(const Plan& plan, RequirementId id, const SceneTraits& traits,
                      const SegmentIndex& index) {
    switch (id) {
        case RequirementId::specular:
            return plan.maxSpecular;
        case RequirementId::bounces:
            return plan.maxDepth;
        case RequirementId::lightSampling:
            return asksLights(plan.way, traits) ? 1 : 0;
        case RequirementId::mis:
            return plan.way.mis ? 1 : 0;
        case RequirementId::lightPass:
            return plan.way.lightPass ? 1 : 0;
        case RequirementId::photonPass:
            return plan.way.photonPass ? 1 : 0;
        case RequirementId::roulette:
            return rouletteOf(plan) > 0 ? 1 : 0;
        case RequirementId::index: {
            const IndexMethod method = plan.index == IndexMethod::automatic ? index.method() : plan.index;
            return method == IndexMethod::tree || method == IndexMethod::grid ? 1 : 0;
        }
        default:
            return 0;
    }
}

}  // namespace halfdisk
