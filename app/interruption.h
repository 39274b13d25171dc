// Was the program asked to stop, and how does it learn of it without leaving work half done?
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace halfdisk {

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM only sets `asked`; the second one ends the program at
/// once. A signal that the program was started to ignore stays ignored. Make it before the threads that must
/// not be interrupted: they inherit the mask. Throws std::system_error if the system has no room for it.
class Interruption {
 public:
    /// `onFirst` is called once, by a thread of its own. May be empty.
    explicit Interruption(std::function<void()> onFirst = {});
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    bool asked() const { return asked_.load(std::memory_order_relaxed); }

 private:
    void watch();

    std::function<void()> onFirst_;
    sigset_t watched_{}, maskBefore_{};
    int signals_ = -1, end_ = -1;  // descriptors: signals that arrive, and the end of watching
    std::atomic<bool> asked_{false};
    std::thread watcher_;
};

}  // namespace halfdisk
