// What do several estimators' parameters have in common? Choices that mean the same wherever they stand.
#pragma once

#include <array>

#include "core/direct_light.h"
#include "core/estimator.h"

namespace halfdisk {

inline constexpr std::array<std::string_view, 2> kOffOn{"off", "on"};
inline constexpr std::array<std::string_view, 3> kEmitterChoices{kEmitters[0].name, kEmitters[1].name,
                                                                 kEmitters[2].name};
inline constexpr std::array<std::string_view, 2> kHeuristicChoices{"balance", "power"};
inline constexpr std::array<std::string_view, 2> kDirectionChoices{"lobe", "half-disk"};

inline constexpr ParamInfo kEmittersParam{
    .name = "emitters",
    .meaning =
        "how lamps and the environment are found: drawn (sample), met by chance (hit), or both, weighed",
    .initial = 2,
    .choices = kEmitterChoices};
inline constexpr ParamInfo kHeuristicParam{.name = "heuristic",
                                           .meaning = "how two ways of finding the same light share it",
                                           .choices = kHeuristicChoices};
inline constexpr ParamInfo kDirectionsParam{
    .name = "directions",
    .meaning = "how directions are drawn at a wall: as it scatters, or all alike",
    .choices = kDirectionChoices};
inline constexpr ParamInfo kRouletteParam{
    .name = "roulette",
    .meaning = "scattering from which paths may end by chance; 0: never",
    .most = 1000,
    .initial = 4,
    .whole = true};

/// The value of a choice or of a whole number.
template <class Value>
Value as(double value) {
    return static_cast<Value>(static_cast<std::uint32_t>(value));
}

}  // namespace halfdisk
