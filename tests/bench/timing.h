// How is time measured? In the CPU time of one thread, which other programs on the machine hardly disturb.
#pragma once

#include <vector>

namespace halfdisk {

/// CPU time that the calling thread has used, s.
double threadSeconds();

/// The q-quantile (0 ... 1) of `values`, by nearest rank. `values` must not be empty.
double quantile(std::vector<double> values, double q);

}  // namespace halfdisk
