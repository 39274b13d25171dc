// What can be chosen when light is to be computed? An estimator, its parameters, and what the scene is made
// of.
#pragma once

#include "core/estimators.h"

namespace halfdisk {

/// One way to compute a picture.
struct TradeSetting {
    const EstimatorInfo* estimator = nullptr;
    ParamValues params;
    std::uint32_t maxDepth = 0;
    double facets = 1.0;                         ///< factor on the number of facets of round things
    IndexMethod index = IndexMethod::automatic;  ///< and with it the precision that decides what is met

    bool operator==(const TradeSetting&) const = default;
};

/// `path`, `path emitters=hit`, `cast-ray samples=16 depth=3`: what differs from the estimator's initial
/// values and from the depth that is asked for. Different settings have different names.
std::string nameOf(const TradeSetting& setting, std::uint32_t askedDepth);

/// Empty, or why the passes of an estimator with this parameter are no independent estimates of one picture.
std::string_view whyNotSwept(const EstimatorInfo& info, std::string_view param);

/// What is measured if nothing is said: an estimator at its initial values, and with one parameter changed at
/// a time, all choices, and a quarter and four times of numbers.
std::vector<TradeSetting> defaultSettings(const EstimatorInfo& info, std::uint32_t maxDepth);

}  // namespace halfdisk
