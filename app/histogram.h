// How are the contributions of single samples counted? In bins of equal width, for the plot and for its
// table.
#pragma once

#include <array>
#include <vector>

namespace halfdisk {

struct Histogram {
    static constexpr std::size_t kBins = 32;
    double low = 0.0, high = 1.0;  ///< W/m: where the bins begin and end
    std::array<double, kBins> counts{};
    double counted = 0.0;  ///< samples; those that are not finite are left out
    double mean = 0.0;     ///< W/m

    double edge(std::size_t bin) const {
        return low + (high - low) / static_cast<double>(kBins) * static_cast<double>(bin);
    }
    std::size_t binOf(double value) const;
};

/// Zero is always among the values that the bins reach over.
Histogram histogramOf(const std::vector<double>& values);

}  // namespace halfdisk
