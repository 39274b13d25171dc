// What can be set of the three instruments: the trade, the extremes, the requirements?
#pragma once

#include <vector>

#include "core/extremes/dial.h"
#include "core/requirements/requirement.h"
#include "core/trade/trade_cost.h"

namespace halfdisk {

/// What a reader asks of the trade.
enum class Wish : std::uint8_t {
    error,  ///< this error, whatever it costs
    time    ///< the least error for so much time
};
inline constexpr std::array<Named<Wish>, 2> kWishes{{
    {Wish::error, "error", "this error, for the least cost"},
    {Wish::time, "time", "the least error, for this time"},
}};

/// Ranges of what can be set; all are logarithmic but `offset`, which starts at 0.
inline constexpr double kLeastScale = 1e-6, kMostScale = 1e6, kMostOffset = 1e5, kMostGap = 0.1;
inline constexpr double kLeastEpsilon = 1e-12, kMostEpsilon = 1.0;
inline constexpr double kLeastWishedError = 1e-3, kMostWishedError = 1.0;
inline constexpr double kLeastMilliseconds = 0.1, kMostMilliseconds = 60'000.0;
inline constexpr double kLeastTolerance = 1e-4, kMostTolerance = 0.5;

struct InstrumentSettings {
    DialSetting dial{};
    Wish wish = Wish::error;
    double wishedError = 0.01;              ///< relative
    double wishedMilliseconds = 50.0;       ///< ms
    TradeCost tradeCost = TradeCost::rays;  ///< the plot's axis, and what a wished error shall cost least of
    double tolerance = 0.01;                ///< of the requirements: share of the light that may be missing
    std::vector<Forced> forced{};           ///< of the requirements
    bool operator==(const InstrumentSettings&) const = default;
};

/// Every number moved into its range; what is not a number becomes its initial value.
InstrumentSettings withinLimits(InstrumentSettings settings);

}  // namespace halfdisk
