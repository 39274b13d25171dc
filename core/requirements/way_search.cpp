#include "core/requirements/way_search.h"

#include <algorithm>
#include <stdexcept>

#include "core/requirements/bounce_findings.h"
#include "core/requirements/words.h"

namespace halfdisk {
namespace {

constexpr std::uint32_t kRouletteFrom = 4;

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

class Search {
 public:
    Search(const RequirementsQuestion& question, const Sensor& small, RequirementsAnswer& answer)
        : question_(question), small_(small), answer_(answer) {}

    void choose() {
        for (const int round : {0, 1, 2}) {
            double looked = 0.0;
            for (const Way& way : allWays()) {
                tell(kBounceShare + (1.0 - kBounceShare) * looked++ / static_cast<double>(allWays().size()),
                     way.estimator);
                const int rank = isWhole(way) ? (way.unbiased ? 0 : 1) : 2;
                if (rank == round && isAllowed(way, question_, answer_.facts)) tryWay(way);
            }
            if (!answer_.candidates.empty()) break;
        }
        if (answer_.candidates.empty())
            throw NoWay(words::joined("no way of carrying light does what is forced",
                                      refusal_.empty() ? "" : ": ", refusal_));
        takeBest();
        tryOtherRoulette();
        if (answer_.plan.way.estimator == "closed-form") return;
        if (!isWhole(answer_.plan.way))
            answer_.loses = words::joined(
                "carries ", pathsOf(answer_.plan.way, question_.index.scene(), question_.sensor), ", of ",
                allPaths(question_.index.scene()));
    }

 private:
    std::uint32_t depth() const { return answer_.bounces.depth; }

    bool isWhole(const Way& way) const { return isComplete(way, question_.index, question_.sensor, depth()); }

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
        tryPlan(planOf(way, roulette ? std::min(kRouletteFrom, std::max(1u, depth())) : 0));
    }

    void tryPlan(const Plan& plan) {
        if (!(plan.estimator->sensors & bitOf(question_.sensor))) return;
        const auto& tried = answer_.candidates;
        const auto isTooLong = [](const Candidate& candidate) { return tooLongToJoin(candidate.pilot); };
        if (plan.estimator->id == "bidirectional" && std::any_of(tried.begin(), tried.end(), isTooLong))
            return;
        const Problem whole{question_.index,  question_.sensor, plan.maxDepth,
                            plan.maxSpecular, question_.seed,   question_.stop};
        if (plan.estimator->id == "closed-form") {
            // Its refusal looks at every pixel. It is no news: a formula is not expected to do.
            if (!refusalOf(*plan.estimator, whole, plan.params).empty()) return;
        }
        // Light that comes through mirrors and glass is rare and bright: few rays don't show its noise.
        const bool rare = answer_.facts.traits.specular && answer_.facts.traits.area;
        const Problem problem{
            .index = question_.index, .sensor = small_, .seed = question_.seed, .stop = question_.stop};
        const double rays = question_.effort * (rare ? 400'000.0 : 80'000.0);
        try {
            answer_.candidates.push_back(
                {plan, pilot(problem, plan, {.rays = static_cast<std::uint64_t>(rays)})});
            answer_.rays += answer_.candidates.back().pilot.rays;
        } catch (const std::invalid_argument& why) {
            refusal_ = why.what();
        }
    }

    /// Of the ones that bring most light, as far as noise shows it, the cheapest: others lose some, or have
    /// not met what is rare.
    void takeBest() {
        // Where so few rays do, they are no cost: then the simplest way is the best.
        constexpr double kFewRays = 16.0;  // for each pixel
        const auto rays = [&](const Candidate& candidate) {
            return std::max(candidate.pilot.raysTo(answer_.tolerance),
                            kFewRays * static_cast<double>(candidate.pilot.pixels));
        };
        // Light that is surely there: a slit between rooms patches can't miss as rays can.
        double least = knownLight(answer_.bounces, depth());
        bool any = false;
        for (const Candidate& candidate : answer_.candidates) {
            least = std::max(least, surelyBrought(candidate.pilot));
            any = any || candidate.pilot.mean > 0.0;
        }
        Candidate* best = nullptr;
        for (Candidate& candidate : answer_.candidates) {
            // What has met no light has no noise either.
            candidate.lacks = any && lacksLight(candidate.pilot, least);
            if (!candidate.lacks && (!best || rays(candidate) < 0.98 * rays(*best))) best = &candidate;
        }
        const bool formula = answer_.candidates.front().plan.way.estimator == "closed-form";
        answer_.dark = !any && !formula;
        const auto darker = [](const Candidate& a, const Candidate& b) {
            return a.pilot.mean < b.pilot.mean;
        };
        // All have met less than the patches know of.
        if (!best) best = &*std::max_element(answer_.candidates.begin(), answer_.candidates.end(), darker);
        // The last one tried looks in most ways.
        if (answer_.dark) best = &answer_.candidates.back();
        for (Candidate& candidate : answer_.candidates) candidate.chosen = &candidate == best;
        answer_.plan = best->plan;
    }

    void tryOtherRoulette() {
        const Way way = answer_.plan.way;
        if (answer_.dark || !way.roulette || depth() == 0 || forcedTo(question_, RequirementId::roulette))
            return;
        tryPlan(planOf(way, rouletteOf(answer_.plan) > 0 ? 0 : std::min(kRouletteFrom, depth())));
        takeBest();
    }

    const RequirementsQuestion& question_;
    const Sensor& small_;
    RequirementsAnswer& answer_;
    std::string refusal_;
};

}  // namespace

std::optional<std::uint32_t> forcedTo(const RequirementsQuestion& question, RequirementId id) {
    for (const Forced& forced : question.forced)
        if (forced.id == id) return forced.value;
    return std::nullopt;
}

bool asksLights(const Way& way, const SceneTraits& traits) {
    return way.lightSampling || (way.emitters == "hit" && traits.delta);
}

void searchWay(const RequirementsQuestion& question, const Sensor& small, RequirementsAnswer& answer) {
    Search(question, small, answer).choose();
}

}  // namespace halfdisk
