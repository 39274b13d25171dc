// Against what are estimates held? The exact picture where there is one, else a long run of an estimator that
// leaves nothing out.
#pragma once

#include <stdexcept>
#include <string>

#include "core/trade/trade_statistics.h"

namespace halfdisk {

/// No picture can be trusted to be the truth. what() tells why and what would help.
struct NoReference : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Its error, as a share of the light: of exactPicture, and of walls lit by fine patches (exactCells).
inline constexpr double kExactError = 1e-4, kExactErrorDeep = 1e-3;
/// Cells of a field that are known exactly.
inline constexpr std::size_t kKnownCells = 200;

/// Exact if the scene is matt and has few walls (see Reference); nothing else. Throws Stopped.
std::optional<TradeReference> exactReference(const Problem& problem);

/// A long run that was called off: whose, and how far it came.
struct BegunRun {
    std::string estimator;  ///< empty: not begun
    GroupedPasses run;
};

/// A long run with another seed, of an estimator without bias that carries all paths: of those, the one whose
/// pilot has the least variance times rays. `budget` is that of the whole run; pilots take a tenth of it
/// each. `begun` (may be null): what an earlier call left to go on with, and where this one leaves it. Throws
/// NoReference and Stopped.
TradeReference longRun(const Problem& problem, const PassBudget& budget, BegunRun* begun = nullptr);

}  // namespace halfdisk
