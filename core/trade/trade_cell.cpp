// What did one setting give for its budget? Measured against the reference, with what follows for other
// budgets.
#include "core/trade/trade_cell.h"

#include <algorithm>
#include <stdexcept>

#include "core/stopwatch.h"
#include "core/trade/pace.h"

namespace halfdisk {
namespace {

/// Null, with the reason in `refusal`.
std::unique_ptr<Estimator> makeOrTell(const Problem& problem, const TradeSetting& setting,
                                      std::string& refusal) {
    refusal = refusalOf(*setting.estimator, problem, setting.params);
    if (!refusal.empty()) return nullptr;
    try {
        return setting.estimator->make(problem, setting.params);
    } catch (const std::invalid_argument& found) {
        refusal = found.what();
        return nullptr;
    }
}

/// A path that meets a lamp or the sky by chance brings no more than their radiance from all around. If it
/// comes once in n / 3 passes, n of them miss it with probability exp(-3), 5 %, and look as if it were not.
double unseenLight(const Scene& scene, std::uint64_t passes) {
    double most = 0.0;
    const auto see = [&](const Rgb& radiance) {
        most = std::max({most, radiance.x, radiance.y, radiance.z});
    };
    for (const Segment& wall : scene.segments) see(wall.emission);
    const Environment& sky = scene.environment;
    if (sky.strip.empty()) see(sky.radiance);
    for (const Rgb& factor : sky.strip) see(sky.radiance * factor);
    return 3.0 * 2.0 * kPi * most / static_cast<double>(passes);
}

/// What is prepared in a moment is prepared again, and the median time told: a single interruption would be
/// many times as long.
std::unique_ptr<Estimator> prepared(const Problem& problem, const TradeSetting& setting, TradeCell& cell) {
    constexpr double kMoment = 0.01;
    constexpr std::size_t kTimes = 5;
    std::unique_ptr<Estimator> estimator;
    std::vector<double> times;
    do {
        const Stopwatch watch;
        estimator = makeOrTell(problem, setting, cell.refusal);
        times.push_back(watch.seconds());
    } while (estimator && times.size() < kTimes && times[0] < kMoment);
    std::sort(times.begin(), times.end());
    cell.preparationSeconds = times[times.size() / 2];
    return estimator;
}

}  // namespace

bool isSameLight(const TradeCell& a, const TradeCell& b) {
    const TradeSetting &one = a.setting, &other = b.setting;
    if (!a.measured() || !b.measured() || one.estimator != other.estimator || one.maxDepth != other.maxDepth)
        return false;
    // What has a bias does more than follow paths: patches, photons. It takes its time.
    if (!one.estimator->bias.empty()) return false;
    // What has no noise may come to the same in another way; noise to the last bit is the same paths.
    const double variance = a.statistics.variance.value;
    if (!(variance > 0.0) || !(b.statistics.variance.value > 0.0)) return false;
    if (a.passes == b.passes)
        return a.rays == b.rays && a.statistics.mean == b.statistics.mean &&
               variance == b.statistics.variance.value;
    const std::size_t common = std::min(a.levels.size(), b.levels.size());
    return common > 0 && std::equal(a.levels.begin(), a.levels.begin() + static_cast<std::ptrdiff_t>(common),
                                    b.levels.begin(), [](const TradeLevel& x, const TradeLevel& y) {
                                        return x.passes == y.passes && x.mse.value == y.mse.value &&
                                               x.rays == y.rays;
                                    });
}

bool isSameRun(const TradeCell& a, const TradeCell& b) {
    return a.setting.index == b.setting.index && isSameLight(a, b);
}

TradeCell measureCell(const Problem& problem, const TradeSetting& setting, std::uint32_t askedDepth,
                      const TradeReference& reference, const PassBudget& budget) {
    TradeCell cell;
    cell.setting = setting;
    cell.name = nameOf(setting, askedDepth);
    const Scene& scene = problem.index.scene();
    cell.complete = setting.estimator->paths(scene, bitOf(problem.sensor)) == allPaths(scene);
    const double before = paceSeconds();
    const std::unique_ptr<Estimator> estimator = prepared(problem, setting, cell);
    if (!estimator) return cell;

    const auto level = [&](const GroupedPasses& run) {
        cell.levels.push_back(
            {static_cast<double>(run.groups.each), statisticsOf(run.groups, reference).mse, run.counts.rays});
    };
    const GroupedPasses run =
        runGroups(*estimator, pixelCount(problem.sensor), reference.pixels, budget, problem.stop, level);
    if (run.interrupted) throw Stopped();
    cell.passes = run.groups.passes();
    cell.groups = run.groups.means.size();
    cell.rays = run.counts.rays;
    cell.cut = run.counts.cut;
    cell.nonFinite = run.counts.nonFinite;
    cell.seconds = run.seconds;
    cell.secondsError = run.groups.timeError() * run.seconds;
    cell.paceSeconds = 0.5 * (before + paceSeconds()) * run.waiting();
    cell.unseen = unseenLight(scene, cell.passes);
    cell.statistics = statisticsOf(run.groups, reference);
    cell.exponent = exponentOf(cell.levels);
    return cell;
}

}  // namespace halfdisk
