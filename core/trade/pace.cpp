#include "core/trade/pace.h"

#include <time.h>

#include <algorithm>
#include <array>

#include "core/rng.h"
#include "core/stopwatch.h"

namespace halfdisk {
namespace {

/// Its result is used, so that no compiler leaves the work out.
double fixedWork(std::uint64_t seed) {
    constexpr std::uint32_t kDraws = 20'000;
    const Rng rng(seed, 0);
    double sum = 0.0;
    for (std::uint32_t i = 0; i < kDraws; ++i) sum += rng.uniform(i, 0);
    return sum;
}

}  // namespace

double paceSeconds() {
    std::array<double, 5> times{};
    volatile double used = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Stopwatch watch;
        used = used + fixedWork(i);
        times[i] = watch.seconds();
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

double threadSeconds() {
    timespec time{};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) != 0) return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace halfdisk
