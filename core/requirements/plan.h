// How is light to be carried, in all that can be set? And which ways are there to choose from?
#pragma once

#include <span>

#include "core/estimators.h"

namespace halfdisk {

/// One way of an estimator, with what it does on the way.
struct Way {
    std::string_view estimator;
    std::string_view emitters{};  ///< its parameter of this name; empty: it has none
    bool lightSampling = false, mis = false, lightPass = false, photonPass = false;
    bool roulette = false;  ///< it can end paths by chance
    bool unbiased = true;
    bool operator==(const Way&) const = default;
};

/// The cheapest first: of ways that are equally good the first one is taken.
std::span<const Way> allWays();

/// All that is asked of the program for a picture.
struct Plan {
    const EstimatorInfo* estimator = nullptr;
    ParamValues params;
    std::uint32_t maxDepth = 0, maxSpecular = 0;
    IndexMethod index = IndexMethod::automatic;
    Way way;
};

/// The parameters of a way, its other ones as fit the scene's size. roulette: scattering from which paths may
/// end by chance, 0: never.
ParamValues paramsOf(const Way& way, const SegmentIndex& index, std::uint32_t roulette);

/// Scattering from which a plan's paths may end by chance; 0: never.
std::uint32_t rouletteOf(const Plan& plan);

/// Whether it carries all light that the scene sends to the sensor, for these scatterings.
bool isComplete(const Way& way, const SegmentIndex& index, const Sensor& sensor, std::uint32_t maxDepth);

/// What it carries, as a regular expression over L, D, S and E.
std::string pathsOf(const Way& way, const Scene& scene, const Sensor& sensor);

/// Nothing left out: paths from both ends, all joins, weights, roulette; for a field, which has no such
/// paths, from the cells to the lights.
Plan everythingOn(const SegmentIndex& index, const Sensor& sensor, std::uint32_t maxDepth,
                  std::uint32_t maxSpecular);

}  // namespace halfdisk
