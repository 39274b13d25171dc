// What do many samples say? Mean and variance in one pass, per colour channel, with the bad samples counted.
#pragma once

#include <cmath>
#include <cstdint>

#include "math.h"

namespace halfdisk {

/// Welford's running mean and variance (1962); merging by Chan et al. (1979). A sample with a value that is
/// not finite is counted and left out: it never turns silently into black.
struct Statistics {
    std::uint64_t count = 0;      ///< finite samples
    std::uint64_t nonFinite = 0;  ///< samples with NaN or infinity in any channel
    std::uint64_t negative = 0;   ///< finite samples below zero in any channel
    Rgb mean{0.0};
    Rgb squares{0.0};  ///< sum of squared deviations from the mean

    void add(const Rgb& x) {
        if (!isFinite(x)) {
            ++nonFinite;
            return;
        }
        if (x.x < 0.0 || x.y < 0.0 || x.z < 0.0) ++negative;
        ++count;
        const Rgb delta = x - mean;
        mean += delta / static_cast<double>(count);
        squares += delta * (x - mean);
    }

    /// As if the samples of `later` had been added after these. Not commutative to the bit: merge in a fixed
    /// order.
    void merge(const Statistics& later) {
        nonFinite += later.nonFinite;
        negative += later.negative;
        if (later.count == 0) return;
        if (count == 0) {  // as it is: the square of a large mean would overflow
            count = later.count;
            mean = later.mean;
            squares = later.squares;
            return;
        }
        const double here = static_cast<double>(count), there = static_cast<double>(later.count);
        const Rgb delta = later.mean - mean;
        count += later.count;
        mean += delta * (there / (here + there));
        squares += later.squares + delta * delta * (here * there / (here + there));
    }

    /// Unbiased variance of one sample; 0 for fewer than two.
    Rgb variance() const { return count > 1 ? squares / static_cast<double>(count - 1) : Rgb(0.0); }

    /// Standard error of the mean.
    Rgb standardError() const {
        return count > 0 ? glm::sqrt(variance() / static_cast<double>(count)) : Rgb(0.0);
    }
};

}  // namespace halfdisk
