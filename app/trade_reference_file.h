// How does a picture that somebody has already become the truth of a trade?
#pragma once

#include <filesystem>

#include "app/cli_output.h"
#include "core/trade/trade_statistics.h"

namespace halfdisk {

/// What the picture must be of.
struct AskedPicture {
    std::uint32_t pixels = 0;
    bool strip = false;  ///< one row
    Json facts;          ///< see pictureFacts; those that a file tells must agree
};

/// From what `halfdisk eye`, `profile` or `field` wrote: .json with its standard errors, or .pfm (a strip's
/// first row), which tells no error and is taken for exact. Throws InputError, also for a picture of
/// something else.
TradeReference referenceFromFile(const std::filesystem::path& file, const AskedPicture& asked);

}  // namespace halfdisk
