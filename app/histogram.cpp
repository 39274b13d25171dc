#include "app/histogram.h"

#include <algorithm>
#include <cmath>

namespace halfdisk {

std::size_t Histogram::binOf(double value) const {
    return static_cast<std::size_t>((value - low) / (high - low) * static_cast<double>(kBins) * 0.999999);
}

Histogram histogramOf(const std::vector<double>& values) {
    Histogram histogram;
    histogram.high = 0.0;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        histogram.low = std::min(histogram.low, value);
        histogram.high = std::max(histogram.high, value);
    }
    if (histogram.high <= histogram.low) histogram.high = histogram.low + 1.0;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        ++histogram.counts[histogram.binOf(value)];
        ++histogram.counted;
    }
    for (const double value : values)
        histogram.mean += std::isfinite(value) ? value / histogram.counted : 0.0;
    return histogram;
}

}  // namespace halfdisk
