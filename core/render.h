// How does an estimator fill a film? Passes in chunks of a fixed size, on any number of threads, merged in
// their order: the same bits for any number of them.
#pragma once

#include <atomic>
#include <functional>

#include "estimator.h"

namespace halfdisk {

struct RenderOptions {
    std::uint64_t firstPass = 0;  ///< pass p draws other random numbers than pass q
    std::uint64_t passes = 1;     ///< at most
    unsigned threads = 1;
    /// Asked between chunks, by any thread; true ends the work after the passes under way. May be empty.
    /// Problem::stop ends it at once.
    std::function<bool()> stop;
    /// Told after each chunk, one at a time: the film so far. May be empty.
    std::function<void(const Film&)> progress;
};

/// Film::passes tells how many passes were made: the first ones, whatever ended the work. A pass that
/// Problem::stop called off is thrown away.
Film render(const Estimator& estimator, const Sensor& sensor, const RenderOptions& options);

}  // namespace halfdisk
