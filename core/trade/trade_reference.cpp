// Against what are estimates held? The exact picture where there is one, else a long run of an estimator that
// leaves nothing out.
#include "core/trade/trade_reference.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

#include "core/estimators.h"
#include "core/exact_field.h"
#include "core/exact_picture.h"

namespace halfdisk {
namespace {

constexpr std::uint64_t kOtherSeed = 0x9E3779B97F4A7C15;  // a reference shares no random numbers
constexpr double kPilotShare = 0.1;
constexpr std::uint32_t kPatches = 800;

struct Candidate {
    std::string_view estimator;
    std::string_view param{};  ///< one parameter that is not at its initial value
    double value = 0.0;
};
// In the order of trust where pilots tell nothing.
constexpr std::array kCandidates{Candidate{"bidirectional"}, Candidate{"path"}, Candidate{"light"},
                                 Candidate{"cast-ray", "emitters", 2}};

ParamValues paramsOf(const EstimatorInfo& info, const Candidate& candidate) {
    ParamValues params = initialValues(info);
    for (std::size_t i = 0; i < params.size(); ++i)
        if (info.params[i].name == candidate.param) params[i] = candidate.value;
    return params;
}

PassBudget shareOf(const PassBudget& budget, double share) {
    PassBudget part = budget;
    part.rays *= share;
    part.seconds *= share;
    part.passes = static_cast<std::uint64_t>(static_cast<double>(budget.passes) * share);
    if (budget.passes > 0 && part.passes == 0) part.passes = 1;
    return part;
}

Picture meanOf(const std::vector<Picture>& groups) {
    Picture mean(groups.front().size(), Rgb(0.0));
    for (const Picture& group : groups)
        for (std::size_t pixel = 0; pixel < mean.size(); ++pixel) mean[pixel] += group[pixel];
    for (Rgb& pixel : mean) pixel /= static_cast<double>(groups.size());
    return mean;
}

/// Against its own mean: the spread alone is of use.
Uncertain varianceOf(const PassGroups& groups) {
    TradeReference own;
    own.mean = meanOf(groups.means);
    return statisticsOf(groups, own).variance;
}

TradeReference ofRun(const EstimatorInfo& info, const GroupedPasses& run, std::uint32_t maxSpecular) {
    TradeReference reference;
    reference.groups = run.groups.means;
    reference.mean = meanOf(reference.groups);
    const double variance = varianceOf(run.groups).value / static_cast<double>(run.groups.passes()),
                 light = reference.light();
    reference.relativeError = light > 0.0 ? std::sqrt(variance) / light : 0.0;
    reference.how = std::string(info.id) + ", " + std::to_string(run.groups.passes()) +
                    " passes of another seed, " + std::to_string(run.counts.rays) + " rays";
    if (run.counts.cut > 0)
        reference.how += "; " + std::to_string(run.counts.cut) + " of " + std::to_string(run.counts.paths) +
                         " paths were given up after " + std::to_string(maxSpecular) +
                         " mirror and glass events: their light is missing";
    return reference;
}

/// Reference asks a flag, not a question: while this lives, somebody asks on its behalf.
class FlagOf {
 public:
    explicit FlagOf(const StopQuestion& stop) {
        if (!stop) return;
        watcher_ = std::thread([this, stop] {
            constexpr std::chrono::milliseconds kBetween{5};
            while (!done_ && !flag_) {
                if (stop()) flag_ = true;
                std::this_thread::sleep_for(kBetween);
            }
        });
    }
    ~FlagOf() {
        done_ = true;
        if (watcher_.joinable()) watcher_.join();
    }
    FlagOf(const FlagOf&) = delete;
    FlagOf& operator=(const FlagOf&) = delete;

    const std::atomic<bool>& flag() const { return flag_; }

 private:
    std::atomic<bool> flag_{false}, done_{false};
    std::thread watcher_;
};

Reference referenceOf(const Problem& problem, unsigned depth) {
    const FlagOf watched(problem.stop);
    Reference reference(problem.index, depth, &watched.flag());
    if (!reference.ready()) throw Stopped();
    return reference;
}

/// What the quadrature may be off by, as a share of the light: less than is told anyhow, or what is
/// measured.
double errorOf(const Reference& reference, const Sensor& sensor, unsigned depth, double light) {
    std::vector<std::uint32_t> walls(reference.visibility().index().scene().segments.size());
    std::iota(walls.begin(), walls.end(), 0u);
    double off = 0.0;  // in the sensor's unit
    if (const auto* profile = std::get_if<Profile>(&sensor))
        off = reference.interpolationError(profile->segments, depth);
    else if (std::holds_alternative<EyeStrip>(sensor))
        off = reference.interpolationError(walls, depth) / 2.0;  // L = albedo / 2 E
    else if (depth > 0)
        off = reference.interpolationError(walls, depth - 1);
    return std::max(depth == 0 ? kExactError : kExactErrorDeep, light > 0.0 ? off / light : 0.0);
}

const Candidate* candidateOf(std::string_view estimator) {
    const auto found = std::find_if(kCandidates.begin(), kCandidates.end(),
                                    [&](const Candidate& one) { return one.estimator == estimator; });
    return found == kCandidates.end() ? nullptr : &*found;
}

/// By pilots. Throws NoReference and Stopped.
const Candidate* bestCandidate(const Problem& problem, const PassBudget& budget) {
    const std::string all = allPaths(problem.index.scene());
    const Candidate* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : kCandidates) {
        const EstimatorInfo& info = *findEstimator(candidate.estimator);
        const ParamValues values = paramsOf(info, candidate);
        if (!info.bias.empty() || info.paths(problem.index.scene(), bitOf(problem.sensor)) != all) continue;
        if (!refusalOf(info, problem, values).empty()) continue;
        const auto estimator = info.make(problem, values);
        const GroupedPasses pilot =
            runGroups(*estimator, pixelCount(problem.sensor), {}, shareOf(budget, kPilotShare), problem.stop);
        if (pilot.interrupted) throw Stopped();
        const Uncertain variance = varianceOf(pilot.groups);
        const double rays =
            static_cast<double>(pilot.counts.rays) / static_cast<double>(pilot.groups.passes());
        // A variance that few groups made, the others saw nothing, is told too small more often than not.
        const double price = rays * (variance.value + 4.0 * variance.error);
        if (best != nullptr && !(price < least)) continue;
        best = &candidate;
        least = price;
    }
    if (best == nullptr)
        throw NoReference("no estimator without bias carries all light of this scene to the sensor " +
                          std::string(kSensorNames[problem.sensor.index()]));
    return best;
}

}  // namespace

std::optional<TradeReference> exactReference(const Problem& problem) {
    const Scene& scene = problem.index.scene();
    const SceneTraits traits = traitsOf(scene);
    const unsigned depth = problem.maxDepth;
    const std::size_t most = depth == 0 ? Reference::kMostWalls : Reference::kMostWallsDeep;
    constexpr unsigned kDeepest = 8;
    if (!traits.diffuseOnly || scene.segments.size() > most || depth > kDeepest) return std::nullopt;
    TradeReference known;
    known.relativeError = depth == 0 ? kExactError : kExactErrorDeep;
    if (const auto* field = std::get_if<Field>(&problem.sensor)) {
        const Radiosity light(problem.index, kPatches, depth, problem.stop);
        KnownCells cells = exactCells(light, *field, kKnownCells, problem.stop);
        known.pixels = std::move(cells.pixels);
        known.mean = std::move(cells.mean);
        known.how = "exact, in " + std::to_string(known.mean.size()) + " cells";
        return known;
    }
    throwIfStopped(problem.stop);
    known.how = "exact, by quadrature";
    const auto* probe = std::get_if<Probe>(&problem.sensor);
    if (!probe && !hasExactPicture(problem.sensor)) return std::nullopt;
    const Reference reference = referenceOf(problem, probe ? depth : depth + 1);
    if (probe)
        known.mean = {reference.irradiance(probe->at, depth)};
    else
        known.mean = exactPicture(reference, problem.sensor, depth, problem.stop);
    known.relativeError = errorOf(reference, problem.sensor, depth, known.light());
    constexpr double kTooLarge = 0.005;
    if (known.relativeError > kTooLarge) return std::nullopt;
    return known;
}

TradeReference longRun(const Problem& problem, const PassBudget& budget, BegunRun* begun) {
    Problem other = problem;
    other.seed = problem.seed ^ kOtherSeed;
    const Candidate* chosen = begun && !begun->estimator.empty() ? candidateOf(begun->estimator) : nullptr;
    if (chosen == nullptr) {
        chosen = bestCandidate(other, budget);
        if (begun) *begun = {std::string(chosen->estimator), {}};
    }
    const EstimatorInfo& info = *findEstimator(chosen->estimator);
    const auto estimator = info.make(other, paramsOf(info, *chosen));
    GroupedPasses run = runGroups(*estimator, pixelCount(problem.sensor), {}, budget, problem.stop, {},
                                  begun ? std::move(begun->run) : GroupedPasses{});
    if (run.interrupted) {
        if (begun) begun->run = std::move(run);
        throw Stopped();
    }
    return ofRun(info, run, problem.maxSpecular);
}

}  // namespace halfdisk
