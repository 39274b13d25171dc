// Is what a lesson claims true? Measured as the lesson says, on its own scene.
#pragma once

#include <memory>
#include <optional>

#include "app/prepared_scene.h"
#include "lessons/claim.h"

namespace halfdisk {

struct ClaimResult {
    double of = 0.0;             ///< what was measured
    std::optional<double> over;  ///< what it is divided by
    double value = 0.0;          ///< what is compared with the claim's number
    bool holds = false;
    double seconds = 0.0;  ///< that it took
};

/// The same result on any number of threads. Throws InputError, with the claim's place in `file`, for what
/// cannot be measured: an unknown estimator or parameter, an exact value that nobody knows, too many rays.
ClaimResult checkClaim(const std::string& file, const std::shared_ptr<const PreparedScene>& scene,
                       const Claim& claim, unsigned threads);

/// `at least 10`, `0.49 +- 0.001`.
std::string expectationOf(const Claim& claim);

}  // namespace halfdisk
