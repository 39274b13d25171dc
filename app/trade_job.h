// The work of `halfdisk trade`, in its order: the truth, the settings, what follows from them.
#pragma once

#include "app/trade_request.h"

namespace halfdisk {

/// Measures, tells and, with a folder, keeps. Ends on Ctrl-C with what is there. Returns the exit code;
/// throws InputError.
int runTrade(TradeRequest request);

struct TradeMergeTexts {
    std::vector<std::string> folders;
    std::string output;
    std::optional<std::string> target;
    bool json = false;
};

/// Joins what parts measured. The same.
int runTradeMerge(const TradeMergeTexts& texts);

}  // namespace halfdisk
