// How do threads share work so that the result does not depend on them? Fixed chunks, merged in their order.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace halfdisk {

/// Calls `work(c)` for c = 0 ... chunks - 1 on `threads` threads and `merge(result)` for each in ascending
/// order of c, one at a time. Stops early, leaving the later chunks out, once `cancelled` (may be null) is
/// set. Neither call may throw.
template <class Work, class Merge>
void forChunksInOrder(std::uint64_t chunks, unsigned threads, const std::atomic<bool>* cancelled,
                      const Work& work, const Merge& merge) {
    std::atomic<std::uint64_t> next{0};
    std::uint64_t merged = 0;
    std::map<std::uint64_t, decltype(work(std::uint64_t{}))> waiting;  // done, but an earlier chunk is not
    std::mutex mutex;

    const auto run = [&] {
        while (!cancelled || !cancelled->load(std::memory_order_relaxed)) {
            const std::uint64_t c = next.fetch_add(1);
            if (c >= chunks) return;
            auto result = work(c);
            const std::lock_guard lock(mutex);
            waiting.emplace(c, std::move(result));
            for (auto first = waiting.begin(); first != waiting.end() && first->first == merged; ++merged) {
                merge(first->second);
                first = waiting.erase(first);
            }
        }
    };

    std::vector<std::thread> helpers;
    try {
        for (unsigned i = 1; i < threads && i < chunks; ++i) helpers.emplace_back(run);
    } catch (const std::system_error&) {
        // No more threads are to be had: those that are here do the work.
    }
    run();
    for (std::thread& helper : helpers) helper.join();
}

}  // namespace halfdisk
