#include "timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace halfdisk {
namespace {

/// CPU seconds of `count` items from `first` on; past the last comes the first again.
double time(const Contender& contender, std::size_t first, std::size_t count, std::size_t items) {
    const double start = processSeconds();
    while (count > 0) {
        const std::size_t now = std::min(count, items - first);
        contender(first, now);
        count -= now;
        first = 0;
    }
    return processSeconds() - start;
}

/// So many items, a power of two of blocks, that a turn takes about `seconds`. Warms the contender up.
std::size_t itemsPerTurn(const Contender& contender, const ContestOptions& options) {
    for (std::size_t count = options.block;; count *= 2)
        if (time(contender, 0, count, options.items) >= 0.7 * options.turnSeconds) return count;
}

}  // namespace

double processSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double quantile(std::vector<double> values, double q) {
    const double last = static_cast<double>(values.size() - 1);
    const auto rank = static_cast<std::size_t>(std::lround(q * last));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

Contest::Contest(const std::vector<Contender>& contenders, const ContestOptions& options)
    : seconds_(contenders.size()) {
    std::vector<std::size_t> counts;
    for (const Contender& contender : contenders) counts.push_back(itemsPerTurn(contender, options));
    const std::size_t least = *std::min_element(counts.begin(), counts.end());
    for (int turn = 0; turn < options.turns; ++turn) {
        // The blocks of the slowest contender begin the turns of all.
        const std::size_t first = static_cast<std::size_t>(turn) * least % options.items;
        for (std::size_t k = 0; k < contenders.size(); ++k) {
            const std::size_t who = (k + static_cast<std::size_t>(turn)) % contenders.size();
            const double seconds = time(contenders[who], first, counts[who], options.items);
            seconds_[who].push_back(seconds / static_cast<double>(counts[who]));
        }
    }
}

double Contest::speedOver(std::size_t contender, std::size_t other) const {
    std::vector<double> ratios;
    for (std::size_t turn = 0; turn < seconds_[contender].size(); ++turn)
        ratios.push_back(seconds_[other][turn] / seconds_[contender][turn]);
    return quantile(ratios, 0.5);
}

}  // namespace halfdisk
