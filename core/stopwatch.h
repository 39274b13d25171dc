// How long did it take?
#pragma once

#include <chrono>

namespace halfdisk {

/// Runs from when it is made. Wall-clock time: what others on the machine do is in it.
class Stopwatch {
 public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace halfdisk
