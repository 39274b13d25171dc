// How is a trade drawn? The front of all settings, and how their errors fall.
#include "app/trade_plots.h"

namespace halfdisk {

std::vector<std::string> writeTradePlots(const std::filesystem::path&, const TradeReport&) {
    return {};
}

}  // namespace halfdisk
