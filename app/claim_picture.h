// What do claims say about whole pictures? What the window would show of them, measured without a window.
#pragma once

#include <memory>

#include "app/prepared_scene.h"
#include "lessons/claim.h"

namespace halfdisk {

/// Where a claim's trial takes place, and by what its pictures are made.
struct ClaimPlace {
    std::shared_ptr<const PreparedScene> scene;
    const Trial& trial;
};

// All throw InputError, without a place, for what cannot be measured. The same on any machine.

/// What chance still does to the finished picture: see noiseOf.
double pictureNoise(const ClaimPlace& place);

/// How far the finished picture is off the exact one: see errorOf.
double pictureError(const ClaimPlace& place);

/// Rays until a picture of the trial's estimator is off by the wished error, by the law of the trade.
double raysToWished(const ClaimPlace& place);

/// Share of a pixel's light that comes by the path that brings most of it, of the recorded run.
double heaviestShare(const ClaimPlace& place);

/// Rays until the noise of the requirements' plan is the tolerance.
double planRays(const ClaimPlace& place);

/// Scatterings that the requirements' plan follows.
double planBounces(const ClaimPlace& place);

}  // namespace halfdisk
