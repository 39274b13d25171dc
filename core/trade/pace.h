// How fast is this machine just now? Times of two settings compare only if it was as fast for both.
#pragma once

namespace halfdisk {

/// Wall-clock seconds of a fixed piece of arithmetic (random numbers, some 0.2 ms): the median of five.
double paceSeconds();

/// Processor time that this thread has used, s: less than has passed where it had to wait for others. 0 where
/// the system does not tell.
double threadSeconds();

}  // namespace halfdisk
