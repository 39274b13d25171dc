// Which setting is the cheapest for each error, and where do two estimators cost the same?
#pragma once

#include "core/trade/trade_report.h"

namespace halfdisk {

/// The report's fronts and crossings, from its verdicts.
void findFronts(TradeReport& report);

}  // namespace halfdisk
