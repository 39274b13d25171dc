// Which estimator is asked for, and with which values of its parameters? All from the registry's own table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/maker_reader.h"

namespace halfdisk {

/// What is used if nothing is said.
inline constexpr std::string_view kDefaultEstimator = "path";

/// Which is none of the registry: the program chooses one.
inline constexpr std::string_view kAutomaticEstimator = "auto";

/// The estimator of that id. Throws InputError that names all there are.
const EstimatorInfo& estimatorArgument(std::string_view id);

/// `name=value` texts over the table's defaults; a choice's value is its name. Throws InputError for an
/// unknown name, a value of the wrong kind or out of range, and for a name given twice.
ParamValues paramArguments(const EstimatorInfo& info, const std::vector<std::string>& texts);

/// A value as paramArguments reads it back, bit for bit.
std::string paramText(const ParamInfo& param, double value);

/// A line `  id  meaning` per estimator, for help.
std::string describedEstimators();

}  // namespace halfdisk
