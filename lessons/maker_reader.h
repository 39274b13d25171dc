// How do `estimator`, `params`, `specular` and `against` of a step become what makes its pictures?
#pragma once

#include "lessons/maker.h"
#include "lessons/table_reader.h"

namespace halfdisk {

/// Depth that a maker may have of its own.
inline constexpr std::uint64_t kMostMakerDepth = 64;

/// Replaces what `estimator` and `params` of the table say; faults as of readMakers.
void readMaker(TableReader& table, std::optional<Maker>& maker);

/// Replaces what the table says. A new estimator begins with its own values. Throws InputError for an unknown
/// estimator or parameter, for a value that it does not take, and for what belongs to no estimator.
void readMakers(TableReader& table, Makers& makers);

/// What values a parameter takes: `one of a, b`, `a whole number from 0 to 10`.
std::string paramRange(const ParamInfo& param);

}  // namespace halfdisk
