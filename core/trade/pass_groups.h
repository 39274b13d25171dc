// How are an estimator's passes kept so that they can be held against the truth? In few independent groups of
// equally many passes, whose means are small experiments of their own.
#pragma once

#include <functional>

#include "core/estimator.h"

namespace halfdisk {

/// Sums of passes. When all groups are full, neighbours join, and a group has twice the passes.
struct PassGroups {
    static constexpr std::size_t kMost = 32;  ///< groups
    static constexpr std::size_t kLeast = 8;  ///< groups that are made even if the budget is spent

    std::uint64_t each = 1;         ///< passes of a group
    std::vector<Picture> means;     ///< of a group's passes; only the pixels that were asked for
    std::vector<double> seconds{};  ///< that the passes of a group took their worker; empty: not known
    std::uint64_t passes() const { return each * means.size(); }
    void joinNeighbours();
    /// Relative standard error of the mean of `seconds`, by how the groups differ; 0: not known.
    double timeError() const;
};

/// Only these pixels; all if `pixels` is empty.
Picture chosenPixels(const Picture& all, const std::vector<std::uint32_t>& pixels);

/// How long an estimator works: until it has cast so many rays, or worked so long (at least kLeast passes).
struct PassBudget {
    double rays = 0.0;         ///< 0: no limit; else the same passes on every machine
    double seconds = 0.0;      ///< 0: no limit
    std::uint64_t passes = 0;  ///< 0: no limit
    unsigned threads = 1;
};

struct GroupedPasses {
    PassGroups groups;
    Counts counts;
    double seconds = 0.0;  ///< wall-clock, of all passes
    /// Of the workers, summed: wall-clock, and what they had of the processor.
    double workerSeconds = 0.0, processorSeconds = 0.0;
    bool interrupted = false;  ///< called off: the groups that were done are here

    /// By which the workers took longer because others had the processor; 1: not at all.
    double waiting() const;
};

/// Told when all kMost groups of a size are there: every level of the convergence curve.
using LevelTold = std::function<void(const GroupedPasses&)>;

/// Passes 0, 1, ... of `estimator`, which keep `pixels` only (all if empty). `stop` is that of the
/// estimator's problem. `begun`: what an interrupted run left, to go on with; with a budget of rays or passes
/// the result is that of a run without interruption.
GroupedPasses runGroups(const Estimator& estimator, std::uint32_t pixelCount,
                        const std::vector<std::uint32_t>& pixels, const PassBudget& budget,
                        const StopQuestion& stop, const LevelTold& level = {}, GroupedPasses begun = {});

}  // namespace halfdisk
