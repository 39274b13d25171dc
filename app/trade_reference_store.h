// How does a folder keep a trade's truth, done or only begun?
//
//   reference.json          the truth, with its error
//   reference.begun.json    a long run that was called off, to go on with
#pragma once

#include <filesystem>
#include <optional>

#include "app/cli_output.h"
#include "core/trade/trade_reference.h"

namespace halfdisk {

/// Nothing if the folder has none. Throws InputError for a file that answers another question, can't be read,
/// or is no picture of so many pixels.
std::optional<TradeReference> readReference(const std::filesystem::path& folder, const Json& question,
                                            std::uint32_t pixels);
/// In place of what was begun.
void writeReference(const std::filesystem::path& folder, const Json& question,
                    const TradeReference& reference);

/// Not begun if the folder has none. Throws like readReference.
BegunRun readBegunReference(const std::filesystem::path& folder, const Json& question, std::uint32_t pixels);
void writeBegunReference(const std::filesystem::path& folder, const Json& question, const BegunRun& begun);

/// reference.json of the first folder that has one which can be read, copied; returns what is wrong with
/// those that can't.
std::vector<std::string> copyReference(const std::vector<std::filesystem::path>& folders,
                                       const std::filesystem::path& to, const Json& question);

}  // namespace halfdisk
