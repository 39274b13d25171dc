// How are the strategies of estimator `bidirectional` watched one by one? By its own passes: every join is
// kept for its strategy as well.
#pragma once

#include "core/estimators/bidirectional_join.h"
#include "core/strategies.h"

namespace halfdisk {

class StrategyPasses {
 public:
    /// `params` are those of the estimator; all strategies are made, and weighed, whatever they say. Asks
    /// what the estimator must not refuse. The table tells which strategies are kept apart.
    StrategyPasses(const Problem& problem, ParamValues params, StrategyTable table);

    /// So many passes from this one on. Throws Stopped if the problem's question says so.
    StrategyFilm render(std::uint64_t firstPass, std::uint64_t passes) const;

 private:
    JoinSetup setup_;
    StrategyTable table_;
};

}  // namespace halfdisk
