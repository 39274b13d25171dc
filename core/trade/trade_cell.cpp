// What did one setting give for its budget? Measured against the reference, with what follows for other
// budgets.
#include "core/trade/trade_cell.h"

#include <chrono>
#include <stdexcept>

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

}  // namespace

TradeCell measureCell(const Problem& problem, const TradeSetting& setting, std::uint32_t askedDepth,
                      const TradeReference& reference, const PassBudget& budget) {
    TradeCell cell;
    cell.setting = setting;
    cell.name = nameOf(setting, askedDepth);
    const Scene& scene = problem.index.scene();
    cell.complete = setting.estimator->paths(scene, bitOf(problem.sensor)) == allPaths(scene);
    const auto start = std::chrono::steady_clock::now();
    const std::unique_ptr<Estimator> estimator = makeOrTell(problem, setting, cell.refusal);
    cell.preparationSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!estimator) return cell;

    const auto level = [&](const GroupedPasses& run) {
        cell.levels.push_back(
            {static_cast<double>(run.groups.each), statisticsOf(run.groups, reference).mse});
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
    cell.statistics = statisticsOf(run.groups, reference);
    cell.exponent = exponentOf(cell.levels);
    return cell;
}

}  // namespace halfdisk
