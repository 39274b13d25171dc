// How is work called off on its way? It asks every so often, and leaves by an exception: what was begun is
// thrown away whole, so that nothing incomplete can be taken for a result.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>

namespace halfdisk {

/// Asked again and again, by any thread, while work goes on; true calls it off. Empty: never.
using StopQuestion = std::function<bool()>;

/// Leaves work that was called off.
struct Stopped : std::exception {
    const char* what() const noexcept override { return "the work was called off"; }
};

/// A step is a ray or a short path, a microsecond or so, and up to half a millisecond where walls are many:
/// asking for each of them would be felt, and of so many nobody sees a delay.
inline constexpr std::uint64_t kStepsPerQuestion = 16;

/// Throws Stopped if the work is called off. `step` counts what the caller does: every 16th asks, the first
/// one too. Leave it out where a step takes long.
inline void throwIfStopped(const StopQuestion& stop, std::uint64_t step = 0) {
    if (step % kStepsPerQuestion == 0 && stop && stop()) throw Stopped();
}

}  // namespace halfdisk
