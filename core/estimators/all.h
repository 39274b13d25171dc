// The estimators' rows, each defined in the file of its name.
#pragma once

#include "core/estimator.h"

namespace halfdisk {

extern const EstimatorInfo kCastRayEstimator;
extern const EstimatorInfo kPathEstimator;
extern const EstimatorInfo kLightEstimator;
extern const EstimatorInfo kBidirectionalEstimator;
extern const EstimatorInfo kPhotonMapEstimator;
extern const EstimatorInfo kVirtualLightsEstimator;
extern const EstimatorInfo kRadiosityEstimator;
extern const EstimatorInfo kClosedFormEstimator;

}  // namespace halfdisk
