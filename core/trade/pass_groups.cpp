// How are an estimator's passes kept so that they can be held against the truth? In few independent groups of
// equally many passes, whose means are small experiments of their own.
#include "core/trade/pass_groups.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/trade/pace.h"

namespace halfdisk {
namespace {

struct Group {
    Picture mean;
    Counts counts;
    double seconds = 0.0, processor = 0.0;
    bool whole = true;
};

}  // namespace

Picture chosenPixels(const Picture& all, const std::vector<std::uint32_t>& pixels) {
    if (pixels.empty()) return all;
    Picture some;
    some.reserve(pixels.size());
    for (const std::uint32_t pixel : pixels) some.push_back(all[pixel]);
    return some;
}

void PassGroups::joinNeighbours() {
    std::vector<Picture> joined;
    for (std::size_t i = 0; i + 1 < means.size(); i += 2) {
        joined.push_back(std::move(means[i]));
        for (std::size_t pixel = 0; pixel < joined.back().size(); ++pixel)
            joined.back()[pixel] = (joined.back()[pixel] + means[i + 1][pixel]) / 2.0;
    }
    means = std::move(joined);
    for (std::size_t i = 0; i + 1 < seconds.size(); i += 2) seconds[i / 2] = seconds[i] + seconds[i + 1];
    seconds.resize(seconds.size() / 2);
    each *= 2;
}

double GroupedPasses::waiting() const {
    return processorSeconds > 0.0 ? std::max(1.0, workerSeconds / processorSeconds) : 1.0;
}

double PassGroups::timeError() const {
    if (seconds.size() < 2) return 0.0;
    const double count = static_cast<double>(seconds.size());
    double sum = 0.0, squares = 0.0;
    for (const double one : seconds) sum += one;
    for (const double one : seconds) squares += (one - sum / count) * (one - sum / count);
    return sum > 0.0 ? std::sqrt(squares / (count - 1.0) * count) / sum : 0.0;
}

GroupedPasses runGroups(const Estimator& estimator, std::uint32_t pixelCount,
                        const std::vector<std::uint32_t>& pixels, const PassBudget& budget,
                        const StopQuestion& stop, const LevelTold& level, GroupedPasses begun) {
    GroupedPasses run = std::move(begun);
    run.interrupted = false;
    const auto elapsed = [watch = Stopwatch(), before = run.seconds] { return before + watch.seconds(); };
    const auto isSpent = [&] {
        if (run.groups.means.size() < PassGroups::kLeast) return false;
        // In the dark some cast none: a pass counts as a ray at least.
        const double rays = static_cast<double>(std::max(run.counts.rays, run.groups.passes()));
        return (budget.rays > 0.0 && rays >= budget.rays) ||
               (budget.seconds > 0.0 && elapsed() >= budget.seconds) ||
               (budget.passes > 0 && run.groups.passes() >= budget.passes);
    };
    std::atomic<bool> done{isSpent()};
    while (!done) {
        const std::uint64_t each = run.groups.each, first = run.groups.means.size();
        const auto work = [&](std::uint64_t chunk) {
            Group group;
            const Stopwatch watch;
            const double used = threadSeconds();
            Picture sum(pixelCount, Rgb(0.0));
            try {
                for (std::uint64_t k = 0; k < each; ++k) {
                    throwIfStopped(stop);
                    estimator.addPass((first + chunk) * each + k, sum, group.counts);
                }
            } catch (const Stopped&) {
                group.whole = false;
                done = true;
            }
            for (Rgb& pixel : sum) pixel /= static_cast<double>(each);
            group.mean = chosenPixels(sum, pixels);
            group.seconds = watch.seconds();
            group.processor = threadSeconds() - used;
            return group;
        };
        bool whole = true;
        const auto merge = [&](const Group& group) {
            whole = whole && group.whole;
            if (!whole) run.interrupted = true;
            // In their order: what other threads did beyond the budget is left out, so that rays alone
            // decide.
            if (!whole || (done && isSpent())) return;
            run.groups.means.push_back(group.mean);
            run.groups.seconds.push_back(group.seconds);
            run.counts.merge(group.counts);
            run.processorSeconds += group.processor;
            run.workerSeconds += group.seconds;
            if (isSpent()) done = true;
        };
        forChunksInOrder(PassGroups::kMost - first, budget.threads, &done, work, merge);
        run.seconds = elapsed();
        if (run.groups.means.size() < PassGroups::kMost) break;
        if (level) level(run);
        if (done) break;
        run.groups.joinNeighbours();
    }
    return run;
}

}  // namespace halfdisk
