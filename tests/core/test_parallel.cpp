// Are chunks worked on once each and merged in their order, and do not too many wait?
#include <doctest/doctest.h>

#include <atomic>

#include "core/parallel.h"

using namespace halfdisk;

TEST_CASE("parallel: every chunk once, merged in order, on any number of threads") {
    for (const unsigned threads : {0u, 1u, 2u, 3u, 8u})
        for (const std::uint64_t chunks : {0u, 1u, 2u, 7u, 1000u})
            for (const std::uint64_t ahead :
                 {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{3}, kMostAhead}) {
                std::vector<std::uint64_t> merged;
                forChunksInOrder(
                    chunks, threads, nullptr, [](std::uint64_t c) { return c * c; },
                    [&](std::uint64_t square) { merged.push_back(square); }, ahead);
                REQUIRE(merged.size() == chunks);
                for (std::uint64_t c = 0; c < chunks; ++c) REQUIRE(merged[c] == c * c);
            }
}

TEST_CASE("parallel: no chunk begins too far ahead of the first that is not merged") {
    constexpr std::uint64_t kAhead = 5, kChunks = 2000;
    for (const unsigned threads : {2u, 3u, 5u}) {
        std::atomic<std::uint64_t> merged{0}, tooFar{0}, furthest{0};
        const auto work = [&](std::uint64_t c) {
            // One more may have been merged in the meantime, not one less.
            const std::uint64_t first = merged;
            if (c >= first + kAhead) ++tooFar;
            if (c > first) furthest = std::max<std::uint64_t>(furthest, c - first);
            // The first of some takes long: the others are done before it.
            std::uint64_t spins = c % 10 == 0 ? 20'000 : 1;
            while (spins > 0) spins -= merged < kChunks + 1 ? 1 : 0;
            return c;
        };
        forChunksInOrder(
            kChunks, threads, nullptr, work, [&](std::uint64_t) { ++merged; }, kAhead);
        CHECK(merged == kChunks);
        CHECK(tooFar == 0);
        CHECK(furthest < kAhead);
    }
}

TEST_CASE("parallel: cancelled, those that were begun are merged and no other begins") {
    for (const unsigned threads : {1u, 2u, 4u}) {
        std::atomic<bool> cancelled{false};
        std::atomic<std::uint64_t> begun{0};
        std::uint64_t merged = 0;
        forChunksInOrder(
            1'000'000, threads, &cancelled,
            [&](std::uint64_t c) {
                ++begun;
                if (c == 100) cancelled = true;
                return c;
            },
            [&](std::uint64_t c) { CHECK(c == merged++); }, 8);
        CHECK(merged == begun);
        CHECK(merged > 100);
        CHECK(merged <= 101 + 8);
    }
}
