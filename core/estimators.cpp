#include "estimators.h"

#include <array>

#include "estimators/all.h"

namespace halfdisk {
namespace {

// One line each, in the order of explanation.
constexpr std::array kEstimators{
    &kCastRayEstimator,   &kPathEstimator,          &kLightEstimator,     &kBidirectionalEstimator,
    &kPhotonMapEstimator, &kVirtualLightsEstimator, &kRadiosityEstimator, &kClosedFormEstimator,
};

}  // namespace

std::span<const EstimatorInfo* const> estimators() {
    return kEstimators;
}

const EstimatorInfo* findEstimator(std::string_view id) {
    for (const EstimatorInfo* info : kEstimators)
        if (info->id == id) return info;
    return nullptr;
}

}  // namespace halfdisk
