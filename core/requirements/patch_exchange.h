// What do patches of matt walls send each other, and by which factor does it shrink in the end?
#pragma once

#include <vector>

#include "core/form_factors.h"

namespace halfdisk {

/// One number for each patch.
using Row = std::vector<double>;

class Exchange {
 public:
    Exchange(const Visibility& visibility, const Patches& patches, const StopQuestion& stop)
        : patches_(patches), lengths_(exchangeLengths(visibility.index(), patches, stop)) {}

    /// Irradiance of each patch from radiosities 1 W/m (B = 2 L): sum over j of F_ij B_j.
    Row arriving(const Row& radiosity) const {
        const std::size_t size = patches_.size();
        Row sum(size);
        for (std::size_t i = 0; i < size; ++i) {
            double total = 0.0;
            for (std::size_t j = 0; j < size; ++j) total += lengths_[i * size + j] * radiosity[j];
            sum[i] = total / patches_.all()[i].length;
        }
        return sum;
    }

 private:
    const Patches& patches_;
    ExchangeLengths lengths_;
};

/// Largest factor by which A = rho F makes a positive row grow, in the end. Throws Stopped if `stop` says so.
double spectralRadiusOf(const Exchange& exchange, const Patches& patches, const Row& albedo,
                        const StopQuestion& stop);

}  // namespace halfdisk
