// How do threads share work so that the result does not depend on them? Fixed chunks, merged in their order.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace halfdisk {

/// Results that may be done but not merged yet, if they are small.
inline constexpr std::uint64_t kMostAhead = 256;

/// Calls `work(c)` for c = 0 ... chunks - 1 on `threads` threads and `merge(result)` for each in ascending
/// order of c, one at a time, while the others go on. Stops early, leaving the later chunks out, once
/// `cancelled` (may be null) is set. Neither call may throw. No chunk begins `mostAhead` (at least `threads`)
/// or more after the first that is not merged, so at most so many results are kept.
template <class Work, class Merge>
void forChunksInOrder(std::uint64_t chunks, unsigned threads, const std::atomic<bool>* cancelled,
                      const Work& work, const Merge& merge, std::uint64_t mostAhead = kMostAhead) {
    using Result = decltype(work(std::uint64_t{}));
    const std::uint64_t workers = std::clamp<std::uint64_t>(chunks, 1, std::max(threads, 1u));
    const std::uint64_t ahead = std::clamp<std::uint64_t>(mostAhead, workers, std::max(chunks, workers));
    std::vector<std::optional<Result>> done(ahead);  // chunk c in place c % ahead
    std::uint64_t next = 0, merged = 0;
    bool merging = false;
    std::mutex mutex;
    std::condition_variable wasMerged;
    const auto isCancelled = [&] { return cancelled && cancelled->load(std::memory_order_relaxed); };

    const auto run = [&] {
        std::unique_lock lock(mutex);
        while (true) {
            // The first chunk that is not merged is being worked on whenever somebody waits here.
            wasMerged.wait(lock, [&] { return next < merged + ahead || next >= chunks; });
            if (next >= chunks || isCancelled()) return;
            const std::uint64_t c = next++;
            lock.unlock();
            std::optional<Result> result(work(c));
            lock.lock();
            done[c % ahead] = std::move(result);
            if (merging) continue;
            merging = true;
            while (std::optional<Result>& first = done[merged % ahead]) {
                const Result taken = std::move(*first);
                first.reset();
                lock.unlock();
                merge(taken);
                lock.lock();
                ++merged;
                wasMerged.notify_all();
            }
            merging = false;
        }
    };

    std::vector<std::thread> helpers;
    try {
        while (helpers.size() + 1 < workers) helpers.emplace_back(run);
    } catch (const std::system_error&) {
        // No more threads are to be had: those that are here do the work.
    }
    run();
    for (std::thread& helper : helpers) helper.join();
}

}  // namespace halfdisk
