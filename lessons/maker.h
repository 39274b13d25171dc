// What makes a step's pictures? An estimator with values of its parameters, and perhaps another beside it.
#pragma once

#include <optional>
#include <string>

#include "core/estimators.h"

namespace halfdisk {

struct Maker {
    std::string estimator;                    ///< one that findEstimator knows
    ParamValues params;                       ///< all of its table's
    std::optional<std::uint32_t> depth{};     ///< instead of the step's own maxDepth
    std::optional<std::uint32_t> specular{};  ///< instead of the settings' maxSpecular
    bool operator==(const Maker&) const = default;
};

/// An estimator with its table's own values.
inline Maker makerOf(std::string_view estimator) {
    return {std::string(estimator), initialValues(*findEstimator(estimator))};
}

/// `Photon mapping, radius 0.05`: what tells it from another one beside it (may be null), if anything.
std::string titleOf(const Maker& maker, const Maker* other);

/// Only that: `radius 0.05`. Empty if nothing but the estimator differs.
std::string differenceOf(const Maker& maker, const Maker& other);

/// What two makers that stand beside each other may both spend.
enum class Budget : std::uint8_t { rays, time };

inline constexpr std::array<Named<Budget>, 2> kBudgets{{
    {Budget::rays, "rays", "both send out as many rays: the same picture on every machine"},
    {Budget::time, "time",
     "both compute as long: the picture depends on the machine, and on what else it does"},
}};

struct Makers {
    std::optional<Maker> first;   ///< none: what serves each picture best
    std::optional<Maker> second;  ///< beside it, for comparison; none: nothing
    Budget equal = Budget::rays;  ///< of the two; one alone always has so many rays
    bool operator==(const Makers&) const = default;
};

}  // namespace halfdisk
