// How fast is this machine just now? Times of two settings compare only if it was as fast for both.
#pragma once

namespace halfdisk {

/// Wall-clock seconds of a fixed piece of arithmetic (random numbers, some 0.3 ms): the median of five.
double paceSeconds();

}  // namespace halfdisk
