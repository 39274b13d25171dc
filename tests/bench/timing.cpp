// How is time measured? In the CPU time of one thread, which other programs on the machine hardly disturb.
#include "timing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>

namespace halfdisk {

double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double quantile(std::vector<double> values, double q) {
    const double last = static_cast<double>(values.size() - 1);
    const auto rank = static_cast<std::size_t>(std::lround(q * last));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

}  // namespace halfdisk
