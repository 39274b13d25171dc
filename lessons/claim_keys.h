// Which keys of a claim mean something for what it measures? One that means nothing there would be a mistake
// that nobody is told of.
#pragma once

#include <array>
#include <string_view>

#include "lessons/claim.h"

namespace halfdisk {

/// A key of `with` and `over` that means something for some quantities only, and for which; other keys are
/// for all.
struct ClaimKey {
    std::string_view name;
    bool (*isFor)(Quantity quantity);
};

/// Whether it takes samples at P, by an estimator.
inline bool isSampledAtPoint(Quantity quantity) {
    switch (quantity) {
        case Quantity::irradiance:
        case Quantity::direct:
        case Quantity::indirect:
        case Quantity::radiance:
        case Quantity::error:
        case Quantity::variance:
        case Quantity::spread:
        case Quantity::standardError:
        case Quantity::relativeError:
        case Quantity::rays:
        case Quantity::nonFinite:
            return true;
        case Quantity::exact:
        case Quantity::heaviest:
        case Quantity::noise:
        case Quantity::pictureError:
        case Quantity::raysTo:
        case Quantity::planRays:
        case Quantity::planBounces:
        case Quantity::lost:
            break;
    }
    return false;
}

/// Whether the claim says by which estimator.
inline bool hasEstimator(Quantity quantity) {
    return isSampledAtPoint(quantity) || quantity == Quantity::heaviest || quantity == Quantity::noise ||
           quantity == Quantity::pictureError || quantity == Quantity::raysTo;
}

inline bool isOfPlan(Quantity quantity) {
    return quantity == Quantity::planRays || quantity == Quantity::planBounces;
}

inline constexpr std::array kClaimKeys{
    ClaimKey{"estimator", hasEstimator},
    ClaimKey{"params", hasEstimator},
    ClaimKey{"repeats", isSampledAtPoint},
    ClaimKey{"pixel", [](Quantity quantity) { return quantity == Quantity::heaviest; }},
    ClaimKey{
        "picture",
        [](Quantity quantity) { return quantity == Quantity::noise || quantity == Quantity::pictureError; }},
    ClaimKey{"dial", [](Quantity quantity) { return quantity == Quantity::lost; }},
    ClaimKey{"tolerance", isOfPlan},
    ClaimKey{"force", isOfPlan},
    ClaimKey{"wishedError", [](Quantity quantity) { return quantity == Quantity::raysTo; }},
    ClaimKey{"wishedMilliseconds", [](Quantity) { return false; }},
    ClaimKey{"tradeCost", [](Quantity) { return false; }},
};

}  // namespace halfdisk
