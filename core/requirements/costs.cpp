#include "core/requirements/costs.h"

#include <algorithm>
#include <stdexcept>

#include "core/requirements/words.h"
#include "core/stopwatch.h"

namespace halfdisk {
namespace {

/// Other random numbers than those that the plan was chosen by: it would seem better than it is.
constexpr std::uint64_t kOther = 0x5bd1e9955bd1e995;

/// The index that a plan wants: the question's own, or one made for it.
struct PlannedIndex {
    PlannedIndex(const SegmentIndex& own, IndexMethod method) : index(&own) {
        if (method != IndexMethod::automatic && method != own.method())
            index = &made.emplace(own.scene(), method);
    }
    std::optional<SegmentIndex> made;
    const SegmentIndex* index;
};

Pilot run(const RequirementsQuestion& question, const Sensor& small, const Plan& plan,
          const PilotLimits& limits) {
    const PlannedIndex planned(question.index, plan.index);
    const Problem problem{
        .index = *planned.index, .sensor = small, .seed = question.seed ^ kOther, .stop = question.stop};
    return pilot(problem, plan, limits);
}

// The same way with the same random numbers differs by just what was changed: pass by pass.
double errorOfChange(const Pilot& pilot, const Pilot& other, bool paired) {
    if (!paired) return std::sqrt(pilot.meanError * pilot.meanError + other.meanError * other.meanError);
    const double n = static_cast<double>(other.totals.size());
    const double mean = pilot.mean - other.mean;
    double squares = 0.0;
    for (std::size_t k = 0; k < other.totals.size(); ++k) {
        const double off = pilot.totals[k] - other.totals[k] - mean;
        squares += off * off;
    }
    return n > 1.0 ? std::sqrt(squares / (n - 1.0) / n) : 0.0;
}

double changeOfPixels(const Pilot& pilot, const Pilot& other, bool paired) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pilot.picture.size(); ++i) {
        const Rgb off = pilot.picture[i] - other.picture[i];
        sum += glm::dot(off, off) / (3.0 * static_cast<double>(pilot.picture.size()));
    }
    const double noise = pilot.variance / static_cast<double>(pilot.passes) +
                         other.variance / static_cast<double>(other.passes);
    const double left = paired ? sum : sum - noise;
    return left > 0.0 && other.square > 0.0 ? std::sqrt(left / other.square) : 0.0;
}

PlanCost beside(const RequirementsQuestion& question, const Sensor& small, const Plan& plan,
                const Plan& other, const Pilot& known, const CostLimits& limits) {
    PlanCost cost{.plan = plan, .pilot = {}, .change = {}, .raysFactor = {}};
    // Roulette is drawn beside the path, which stays the same up to its end.
    const bool paired = plan.way == other.way;
    const PilotLimits wanted =
        paired ? PilotLimits{.rays = 0, .leastPasses = known.passes} : PilotLimits{.rays = limits.rays};
    double fastest = kInfinity, fastestOther = known.secondsPerRay();
    for (int repeat = 0; repeat < limits.repeats; ++repeat) {
        cost.pilot = run(question, small, plan, wanted);
        fastest = std::min(fastest, cost.pilot.secondsPerRay());
        const Pilot again = run(question, small, other, {.rays = 0, .leastPasses = known.passes});
        fastestOther = std::min(fastestOther, again.secondsPerRay());
    }
    if (fastestOther > 0.0) cost.timePerRayFactor = fastest / fastestOther;
    if (known.mean == 0.0) return cost;
    cost.change = LightChange{(cost.pilot.mean - known.mean) / known.mean,
                              errorOfChange(cost.pilot, known, paired) / known.mean,
                              changeOfPixels(cost.pilot, known, paired)};
    const double noise = cost.pilot.variance * cost.pilot.raysPerPass(),
                 noiseOther = known.variance * known.raysPerPass();
    cost.raysFactor = noiseOther > 0.0 ? noise / noiseOther : noise > 0.0 ? kInfinity : 1.0;
    return cost;
}

std::string lightWords(const PlanCost& cost) {
    if (!cost.raysFactor) return "no short run met any light";
    if (!cost.change) return "no path met light that this changes";
    const double share = cost.change->share, sure = 2.0 * cost.change->standardError;
    if (std::abs(share) > sure && std::abs(share) > 1e-9)
        return words::joined("light changes by ", words::number(100.0 * share), " % (± ",
                             words::number(100.0 * sure, 1), " %)");
    return sure > 0.0 ? words::joined("no light is lost (within ", words::number(100.0 * sure, 1), " %)")
                      : "light stays the same";
}

std::string wordsOf(const RequirementCost& row) {
    if (!row.impossible.empty()) return row.impossible;
    std::string text = lightWords(row.cost);
    if (const auto rays = row.cost.raysFactor) {
        if (std::isinf(*rays))
            text += "; there is noise, where the plan has none";
        else if (*rays == 0.0)
            text += "; there is no noise";
        else
            text += words::joined("; ", words::number(*rays, 3), " times the rays to the same noise");
    }
    return words::joined(text, ", ", words::number(row.cost.timePerRayFactor, 2), " times the time per ray");
}

/// Whether the scene has paths of which the number `id` lets through more or fewer.
bool mayChange(RequirementId id, const SceneFacts& facts) {
    return id == RequirementId::specular  ? facts.traits.specular
           : id == RequirementId::bounces ? facts.mostAlbedo > 0.0
                                          : false;
}

/// What to change each requirement to.
std::vector<std::uint32_t> flipsOf(RequirementId id, std::uint32_t value) {
    if (infoOf(id).kind == Switch::none) return {};
    if (infoOf(id).kind == Switch::onOff) return {value != 0 ? 0u : 1u};
    if (id == RequirementId::specular && value == 0)
        return {static_cast<std::uint32_t>(kMaxSpecularInfo.initial)};
    const std::uint32_t more =
        std::min<std::uint32_t>(std::max(1u, 2 * value), static_cast<std::uint32_t>(kMaxDepthInfo.most));
    if (value == 0) return {more};
    const std::uint32_t less = id == RequirementId::specular ? 0 : value - 1;
    if (more <= value) return {less};
    return {less, more};
}

/// None of them measured yet.
std::vector<RequirementCost> rowsOf(const RequirementsQuestion& question, const RequirementsAnswer& answer) {
    std::vector<RequirementCost> rows;
    for (const RequirementInfo& info : kRequirements) {
        const std::uint32_t value = valueIn(answer.plan, info.id, answer.facts.traits, question.index);
        for (const std::uint32_t flipped : flipsOf(info.id, value))
            rows.push_back(
                {.id = info.id, .from = value, .to = flipped, .impossible = {}, .cost = {}, .words = {}});
    }
    return rows;
}

void measureRow(const RequirementsQuestion& question, const RequirementsAnswer& answer,
                const CostLimits& limits, const Sensor& small, const Pilot& known, RequirementCost& row) {
    RequirementsQuestion forced = question;
    std::erase_if(forced.forced, [&](const Forced& one) { return one.id == row.id; });
    forced.forced.push_back({row.id, row.to});
    try {
        const RequirementsAnswer other = replanned(forced, answer);
        row.cost = beside(question, small, other.plan, answer.plan, known, limits);
        // Not one path differs: that the light is the same nobody knows.
        const std::optional<LightChange>& change = row.cost.change;
        if (mayChange(row.id, answer.facts) && change && change->share == 0.0 && change->standardError == 0.0)
            row.cost.change.reset();
    } catch (const std::invalid_argument& why) {
        row.impossible = why.what();
    }
    row.words = wordsOf(row);
}

void measureEverything(const RequirementsQuestion& question, const RequirementsAnswer& answer,
                       const CostLimits& limits, const Sensor& small, Costs& costs) {
    const auto usual = static_cast<std::uint32_t>(kMaxSpecularInfo.initial);
    try {
        costs.everything = beside(question, small,
                                  everythingOn(question.index, question.sensor, answer.plan.maxDepth,
                                               std::max(usual, answer.plan.maxSpecular)),
                                  answer.plan, costs.plan, limits);
    } catch (const std::invalid_argument& why) {
        costs.everythingImpossible = why.what();
    }
}

}  // namespace

PlanCost compareCost(const RequirementsQuestion& question, const Plan& plan, const Plan& other,
                     const CostLimits& limits, Pilot* otherPilot) {
    const Sensor small = pilotSensor(question.sensor);
    const Pilot known = run(question, small, other, {.rays = limits.rays});
    if (otherPilot) *otherPilot = known;
    return beside(question, small, plan, other, known, limits);
}

bool measureNextCost(const RequirementsQuestion& question, const RequirementsAnswer& answer,
                     const CostLimits& limits, Costs& costs) {
    const Stopwatch watch;
    const Sensor small = pilotSensor(question.sensor);
    const std::vector<RequirementCost> rows = rowsOf(question, answer);
    if (costs.complete()) return false;
    if (costs.done == 0) {
        costs.plan = run(question, small, answer.plan, {.rays = limits.rays});
        costs.pieces = rows.size() + 2;
    } else if (costs.rows.size() < rows.size()) {
        RequirementCost row = rows[costs.rows.size()];
        measureRow(question, answer, limits, small, costs.plan, row);
        costs.rows.push_back(std::move(row));
    } else {
        measureEverything(question, answer, limits, small, costs);
    }
    ++costs.done;
    costs.seconds += watch.seconds();
    return true;
}

Costs costsOf(const RequirementsQuestion& question, const RequirementsAnswer& answer,
              const CostLimits& limits) {
    Costs costs;
    while (measureNextCost(question, answer, limits, costs)) {
    }
    return costs;
}

}  // namespace halfdisk
