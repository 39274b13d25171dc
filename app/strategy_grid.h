// What does each strategy (s, t) of paths from both ends bring, as it is shown? Grows while it is looked at.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/sensor.h"
#include "core/strategies.h"

namespace halfdisk {

/// Paths of more vertices are counted together: more rows could not be read.
inline constexpr std::uint32_t kGridVertices = 6;

/// Never changes: more passes are another one.
struct StrategyGrid {
    Sensor sensor;              ///< the scene's eye, or else P's wall
    StrategyFilm film;          ///< its table goes up to kGridVertices
    std::uint32_t longest = 2;  ///< vertices of the longest paths that may be there, at most kGridVertices
    bool hasLonger = false;     ///< some may be longer than that
    double white = 0.0;         ///< one for all; 0: all is black
    std::vector<std::uint32_t> weightedColors{}, aloneColors{};  ///< packed, strategy after strategy
    std::string refusal{};                                       ///< not empty: why there are none
    bool complete = false;

    bool ofEye() const { return std::holds_alternative<EyeStrip>(sensor); }
    /// An eye is a point: no path from a light meets it.
    bool canBe(Strategy strategy) const {
        return strategy.vertices() <= longest && (!ofEye() || strategy.t > 0);
    }
    const PixelStatistics& means(bool alone) const { return alone ? film.aloneMeans : film.weightedMeans; }
    const std::vector<std::uint32_t>& colors(bool alone) const {
        return alone ? aloneColors : weightedColors;
    }
    /// Of the light that all of them bring together, 0 ... 1 (alone: or more); 0 where there is none.
    double share(std::size_t place, bool alone) const;
};

/// Of the whole work, 0 ... 1.
double shareDone(const StrategyGrid& grid, double effort);

}  // namespace halfdisk
