// Which estimators are there? The one list; command line, help, tests and window read it.
#pragma once

#include "estimator.h"

namespace halfdisk {

std::span<const EstimatorInfo* const> estimators();

/// Null if there is none of this id.
const EstimatorInfo* findEstimator(std::string_view id);

}  // namespace halfdisk
