// Which settings are compared? From a list of estimators and what is swept.
#pragma once

#include <string>
#include <vector>

#include "core/trade/trade_setting.h"

namespace halfdisk {

/// `all` or ids with commas; each sweep is `KEY=V1,V2,...`, several make a product. KEY is a parameter,
/// ESTIMATOR.PARAMETER, depth, facets, index or precision. Without sweeps: see defaultSettings. Throws
/// InputError.
std::vector<TradeSetting> tradeSettings(const std::string& estimators, const std::vector<std::string>& sweeps,
                                        std::uint32_t maxDepth);

}  // namespace halfdisk
