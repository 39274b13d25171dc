// What should the photon map find, and what does it? The mean over its kernel by quadrature, and its passes.
#pragma once

#include "core/estimate.h"
#include "core/estimators/all.h"
#include "core/quadrature.h"
#include "core/reference.h"
#include "run_estimator.h"

namespace halfdisk::test {

/// Mean over the kernel about t of a wall, cut at the wall's ends, of light scattered 1 to `depth` times.
inline Rgb kernelMean(const SegmentIndex& index, const Reference& reference, std::uint32_t segment, double t,
                      double radius, unsigned depth, bool indirectOnly = true) {
    const double length = index.length(segment);
    const double from = std::max(0.0, t - radius / length), to = std::min(1.0, t + radius / length);
    const auto E = [&](double u) {
        const ShadedPoint at = shadedPointOn(index, segment, u);
        Rgb value = reference.irradiance(at, depth);
        if (indirectOnly) value -= reference.irradiance(at, 0);
        return Integrals<3>{value.x, value.y, value.z};
    };
    const Integrals<3> sum = integrate<3>(E, from, to, {1e-8, 1e-8, 1e-8}, 8);
    return Rgb(sum[0], sum[1], sum[2]) / (to - from);
}

/// The photon map's passes at a wall's point, less the light that comes straight from lights without a size;
/// times `scale`.
inline Statistics indirectPasses(const SegmentIndex& index, const ShadedPoint& at, const Ask& ask,
                                 double scale = 1.0) {
    const Sensor sensor = Probe{at};
    const Problem problem{.index = index, .sensor = sensor, .maxDepth = ask.maxDepth, .seed = ask.seed};
    const auto estimator = kPhotonMapEstimator.make(problem, paramsOf(kPhotonMapEstimator, ask.params));
    const Rgb direct = deltaIrradiance(index, at);
    Statistics passes;
    Counts counts;
    for (std::uint64_t pass = 0; pass < ask.passes; ++pass) {
        Picture picture(1);
        estimator->addPass(pass, picture, counts);
        passes.add((picture[0] - direct) * scale);
    }
    return passes;
}

}  // namespace halfdisk::test
