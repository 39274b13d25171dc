// In which ways can a path from a light and one from the sensor be joined? Strategy (s, t) takes s vertices
// from the light and t from the sensor (Veach 1997, section 10.1).
#pragma once

#include "core/estimator.h"
#include "core/strategies.h"
#include "core/subpath.h"

namespace halfdisk {

/// What all joins of a pass share.
struct JoinSetup {
    Problem problem;
    Receivers receivers;
    LightTable lights;
    std::optional<ProfileBins> bins;
    int onlyS, onlyT;  // -1: any
    bool weighs;
    Heuristic heuristic;
    StrategyCounts counts;
    WalkLimits limits;

    bool asks(std::size_t s, std::size_t t) const {
        return (onlyS < 0 || s == static_cast<std::size_t>(onlyS)) &&
               (onlyT < 0 || t == static_cast<std::size_t>(onlyT));
    }
};

/// By the parameters of estimator `bidirectional`.
JoinSetup joinSetupOf(const Problem& problem, const ParamValues& params);

/// For every pixel: follows one path from each end and adds what all strategies find to the picture, and what
/// each of them finds to `apart`, if that is not null. Throws Stopped if the problem's question says so.
void joinPaths(const JoinSetup& setup, std::uint64_t pass, Picture& picture, Counts& counts,
               StrategyPictures* apart = nullptr);

}  // namespace halfdisk
