#include "core/requirements/requirements.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "core/requirements/bounce_findings.h"
#include "core/requirements/reasons.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kRouletteFrom = 4;
constexpr double kBounceShare = 0.3;  // of the time: the bounces; then the ways are tried

std::optional<std::uint32_t> forcedTo(const RequirementsQuestion& question, RequirementId id) {
    for (const Forced& forced : question.forced)
        if (forced.id == id) return forced.value;
    return std::nullopt;
}

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

// Where the geometry has no bound, mirrors' reflectances may have one: at least the usual number, and more
// where mirrors are so bright that this would be seen.
std::uint32_t specularOf(const SceneFacts& facts, double tolerance) {
    if (facts.longestChain) return *facts.longestChain;
    const auto usual = static_cast<std::uint32_t>(kMaxSpecularInfo.initial);
    if (facts.glass > 0 || facts.mostReflectance <= 0.0) return usual;
    if (facts.mostReflectance >= 1.0) return static_cast<std::uint32_t>(kMaxSpecularInfo.most);
    const double events = std::ceil(std::log(tolerance) / std::log(facts.mostReflectance));
    return static_cast<std::uint32_t>(
        std::clamp(events, static_cast<double>(usual), static_cast<double>(kMaxSpecularInfo.most)));
}

/// Lights without size can't be met: whoever looks back must ask them.
bool asksLights(const Way& way, const SceneTraits& traits) {
    return way.lightSampling || (way.emitters == "hit" && traits.delta);
}

bool isAllowed(const Way& way, const RequirementsQuestion& question, const SceneFacts& facts) {
    const SceneTraits& traits = facts.traits;
    const auto agrees = [&](RequirementId id, bool value) {
        const auto wanted = forcedTo(question, id);
        return !wanted || (*wanted != 0) == value;
    };
    // With nothing to be met, all three ways of `path` are the same; with nothing to be met or asked too.
    if (!traits.area && way.estimator == "path" && !forcedTo(question, RequirementId::mis) &&
        way.emitters != "sample")
        return false;
    // Next to a lamp the light that asking brings has no bound, and few rays don't show it.
    const bool rough = facts.lampInCorner || std::holds_alternative<Field>(question.sensor);
    if (traits.area && rough && way.emitters == "sample" && !forcedTo(question, RequirementId::mis))
        return false;
    const auto roulette = forcedTo(question, RequirementId::roulette);
    return agrees(RequirementId::lightSampling, asksLights(way, traits)) &&
           agrees(RequirementId::mis, way.mis) && agrees(RequirementId::lightPass, way.lightPass) &&
           agrees(RequirementId::photonPass, way.photonPass) &&
           !(roulette && *roulette != 0 && !way.roulette);
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

class Search {
 public:
    Search(const RequirementsQuestion& question, const Sensor& small, RequirementsAnswer& answer)
        : question_(question), small_(small), answer_(answer) {}

    /// Of the complete ways without bias the one that takes the fewest rays; else of those with a bias; else
    /// of what is left.
    void choose() {
        for (const int round : {0, 1, 2}) {
            double looked = 0.0;
            for (const Way& way : allWays()) {
                tell(kBounceShare + (1.0 - kBounceShare) * looked++ / static_cast<double>(allWays().size()),
                     way.estimator);
                const bool complete = isComplete(way, question_.index, question_.sensor, depth());
                const int rank = complete ? (way.unbiased ? 0 : 1) : 2;
                if (rank == round && isAllowed(way, question_, answer_.facts)) tryWay(way);
            }
            if (!answer_.candidates.empty()) break;
        }
        if (answer_.candidates.empty())
            throw std::invalid_argument(words::joined("no way of carrying light does what is forced",
                                                      refusal_.empty() ? "" : ": ", refusal_));
        takeBest();
        tryOtherRoulette();
        if (answer_.plan.way.estimator == "closed-form") return;
        if (!isComplete(answer_.plan.way, question_.index, question_.sensor, depth()))
            answer_.loses = words::joined(
                "carries ", pathsOf(answer_.plan.way, question_.index.scene(), question_.sensor), ", of ",
                allPaths(question_.index.scene()));
    }

 private:
    std::uint32_t depth() const { return answer_.bounces.depth; }

    void tell(double share, std::string_view what) const {
        if (question_.told) question_.told(share, what);
    }

    Plan planOf(const Way& way, std::uint32_t roulette) const {
        return {findEstimator(way.estimator),
                paramsOf(way, question_.index, way.roulette ? roulette : 0),
                depth(),
                answer_.plan.maxSpecular,
                answer_.plan.index,
                way};
    }

    void tryWay(const Way& way) {
        const auto forced = forcedTo(question_, RequirementId::roulette);
        const bool roulette = forced ? *forced != 0 : depth() > kRouletteFrom;
        tryPlan(planOf(way, roulette ? kRouletteFrom : 0));
    }

    void tryPlan(const Plan& plan) {
        if (!(plan.estimator->sensors & bitOf(question_.sensor))) return;
        const Problem whole{question_.index,  question_.sensor, plan.maxDepth,
                            plan.maxSpecular, question_.seed,   question_.stop};
        if (plan.estimator->id == "closed-form") {
            // Its refusal looks at every pixel.
            if (std::string why = refusalOf(*plan.estimator, whole, plan.params); !why.empty()) {
                refusal_ = why;
                return;
            }
        }
        // Light that comes through mirrors and glass is rare and bright: few rays don't show its noise.
        const bool rare = answer_.facts.traits.specular && answer_.facts.traits.area;
        const Problem problem{
            .index = question_.index, .sensor = small_, .seed = question_.seed, .stop = question_.stop};
        const double rays = question_.effort * (rare ? 400'000.0 : 80'000.0);
        try {
            answer_.candidates.push_back(
                {plan, pilot(problem, plan, {.rays = static_cast<std::uint64_t>(rays)}), false});
            answer_.rays += answer_.candidates.back().pilot.rays;
        } catch (const std::invalid_argument& why) {
            refusal_ = why.what();
        }
    }

    void takeBest() {
        // Where so few rays do, they are no cost: then the simplest way is the best.
        constexpr double kFewRays = 16.0;  // for each pixel
        const auto rays = [&](const Candidate& candidate) {
            return std::max(candidate.pilot.raysTo(answer_.tolerance),
                            kFewRays * static_cast<double>(candidate.pilot.pixels));
        };
        Candidate* best = &answer_.candidates.front();
        for (Candidate& candidate : answer_.candidates)
            if (rays(candidate) < 0.98 * rays(*best)) best = &candidate;
        for (Candidate& candidate : answer_.candidates) candidate.chosen = &candidate == best;
        answer_.plan = best->plan;
    }

    void tryOtherRoulette() {
        const Way way = answer_.plan.way;
        if (!way.roulette || depth() == 0 || forcedTo(question_, RequirementId::roulette)) return;
        tryPlan(planOf(way, rouletteOf(answer_.plan) > 0 ? 0 : std::min(kRouletteFrom, depth())));
        takeBest();
    }

    const RequirementsQuestion& question_;
    const Sensor& small_;
    RequirementsAnswer& answer_;
    std::string refusal_;
};

void cutAt(std::uint32_t depth, BounceFindings& bounces) {
    bounces.depth = depth;
    bounces.missing.reset();
    if (bounces.patches) {
        const std::vector<double>& beyond = bounces.patches->beyond;
        const std::size_t known = std::min<std::size_t>(depth, beyond.size() - 1);
        bounces.missing = {static_cast<std::uint32_t>(known), beyond[known], 0.0};
        return;
    }
    for (const BeyondDepth& beyond : bounces.measured)
        if (beyond.depth <= depth) bounces.missing = beyond;
}

// What is tried must not be what is then shown: choosing by the same random numbers would favour them.
std::uint64_t tried(std::uint64_t seed) {
    return ~seed;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void refuseForced(const RequirementsQuestion& question) {
    for (const Forced& forced : question.forced) {
        const RequirementInfo& info = infoOf(forced.id);
        if (info.kind == Switch::none)
            throw std::invalid_argument(words::joined(info.name, " can't be switched: ", info.fixed));
    }
}

/// Chooses the way, from what is known of the scene.
void choosePlan(const RequirementsQuestion& question, RequirementsAnswer& answer) {
    RequirementsQuestion asked = question;
    asked.seed = tried(question.seed);
    answer.candidates.clear();
    answer.loses.clear();
    answer.plan = {};
    answer.plan.maxSpecular =
        forcedTo(asked, RequirementId::specular).value_or(specularOf(answer.facts, asked.tolerance));
    if (const auto index = forcedTo(asked, RequirementId::index))
        answer.plan.index = *index != 0 ? IndexMethod::tree : IndexMethod::bruteForce;
    cutAt(forcedTo(asked, RequirementId::bounces).value_or(answer.bounces.required), answer.bounces);
    const Sensor small = pilotSensor(asked.sensor);
    Search(asked, small, answer).choose();
    answer.requirements = requirementRows(asked, answer);
}

}  // namespace

RequirementsAnswer requirementsOf(const RequirementsQuestion& question) {
    RequirementsAnswer answer;
    findRequirements(question, answer);
    return answer;
}

void findRequirements(const RequirementsQuestion& question, RequirementsAnswer& answer) {
    const auto start = std::chrono::steady_clock::now();
    answer = {};
    refuseForced(question);
    if (const std::string fault = faultOf(question.sensor, question.index); !fault.empty())
        throw std::invalid_argument(fault);
    const Sensor small = pilotSensor(question.sensor);
    answer.tolerance = question.tolerance;
    answer.facts = factsOf(question.index.scene());
    answer.pathTypes = pathTypesOf(answer.facts, question.sensor);
    answer.escapes = escapesOf(question.index);
    if (question.told) question.told(0.0, "bounces");
    if (answer.facts.traits.delta || answer.facts.traits.area)
        answer.bounces = findBounces({question.index,
                                      small,
                                      question.tolerance,
                                      {},
                                      tried(question.seed),
                                      question.stop,
                                      question.effort},
                                     answer.facts, specularOf(answer.facts, question.tolerance), answer.rays);
    choosePlan(question, answer);
    answer.seconds = secondsSince(start);
}

RequirementsAnswer replanned(const RequirementsQuestion& question, const RequirementsAnswer& known) {
    const auto start = std::chrono::steady_clock::now();
    refuseForced(question);
    RequirementsAnswer answer = known;
    choosePlan(question, answer);
    answer.seconds = secondsSince(start);
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
